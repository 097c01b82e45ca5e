// The paper's tiled generator, depth first: a square that the band reaches is a
// cell if its nine samples are good enough at 16 points between them, and else
// four squares of half the width, whose samples are among those 25 points.
//
//   4 +--o--+--o--+      +  the cell's samples
//   3 o  o  o  o  o      o  where it is tested
//   2 +--o--+--o--+
//   1 o  o  o  o  o
//   0 +--o--+--o--+
//     0  1  2  3  4
//
// Only those edges of the outline are looked at that may be the nearest ones
// within the square, see Polyline::keep.
//
// In the buffer nodes grow upwards behind the tiles, and cells downwards from
// what the outline and the levels of the tree take at its end.
//
// Over 400 lines: one builder, whose steps share that buffer.
#include "inkcell/field/generate.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "field_sampler.hpp"
#include "inkcell/format/rom.hpp"
#include "polyline.hpp"

namespace inkcell {
namespace {

namespace glyphs = format::glyph;
namespace samples = format::samples;
using detail::abs;
using detail::max;
using detail::min;
using detail::OutlineGlyph;
using detail::Polyline;

// Tiles are as wide as the glyph, within these limits.
constexpr int32_t kMinTileLog2 = 6;
constexpr int32_t kMaxTileLog2 = glyphs::kMaxTileLog2;
// Cells are. Smaller ones have no points between their samples where
// coordinates are of 1/2 u.
constexpr int32_t kMaxCellLog2 = 6;
constexpr int32_t kMinCellLog2 = 1;

constexpr int32_t kMaxFraction = 6;
constexpr int32_t kCoordinateBits = 16;
constexpr int32_t kGridLimit = 15000;

// The em box. [u]
constexpr Rect kEmBox = {0, -768, 1024, 256};  // y down

// The part by which a distance beyond the band may differ.
constexpr int32_t kFarPartLog2 = 6;

// What the rounding of edges' coordinates and of distances may add.
constexpr int32_t kRounded = 2;

// Chords are no better than this. [u, Q8]
constexpr int32_t kMinChordError = 4;

constexpr uint32_t kNodeBytes = 8;
constexpr uint32_t kChildren = 4;

// No references: a square to be divided, and the end of the buffer.
constexpr uint32_t kDivide = 0x10000;
constexpr uint32_t kFull = 0x10001;

// Points of a side.
constexpr int32_t kSide = 5;
constexpr int16_t kUnknown = INT16_MIN;

// The square of a level of the tree that is being looked at. Lies in RAM that
// is lent as bytes.
struct __attribute__((may_alias)) Level {
  uint16_t x_u;  // lower left corner in the grid
  uint16_t y_u;
  uint16_t edges;  // how many may be the nearest ones
  uint16_t node;   // the offset of its children in the record
  uint16_t child;  // the next one
  int16_t distances_q6[kSide * kSide];  // row by row from below [u]
};

void store_u16(uint8_t* at, uint32_t value) noexcept {
  at[0] = static_cast<uint8_t>(value);
  at[1] = static_cast<uint8_t>(value >> 8);
}

// What holds the band around a glyph.
struct Grid {
  int32_t x0_u;
  int32_t y0_u;
  int32_t tile_log2;
  int32_t tiles_x;
  int32_t tiles_y;
  int32_t fraction;  // of coordinates

  bool set(const Rect& ink, const FieldLimits& limits) noexcept {
    const int32_t band_u = limits.band_u;
    if (ink.x0 >= ink.x1 || ink.y0 >= ink.y1 || ink.x0 < -kGridLimit ||
        ink.y0 < -kGridLimit || ink.x1 > kGridLimit || ink.y1 > kGridLimit) {
      return false;
    }
    Rect box = {ink.x0 - band_u, ink.y0 - band_u, ink.x1 + band_u,
                ink.y1 + band_u};
    if (limits.fills_em) {
      box = {min(box.x0, kEmBox.x0), min(box.y0, kEmBox.y0),
             max(box.x1, kEmBox.x1), max(box.y1, kEmBox.y1)};
    }
    x0_u = box.x0;
    y0_u = -box.y1;
    const int32_t width = box.x1 - box.x0;
    const int32_t height = box.y1 - box.y0;
    const int32_t most = max(width, height);
    tile_log2 = kMinTileLog2;
    while (tile_log2 < kMaxTileLog2 && 1 << tile_log2 < most) {
      ++tile_log2;
    }
    tiles_x = ((width - 1) >> tile_log2) + 1;
    tiles_y = ((height - 1) >> tile_log2) + 1;
    fraction = kMaxFraction;
    while (max(tiles_x, tiles_y) << tile_log2 >
           1 << (kCoordinateBits - fraction)) {
      --fraction;
    }
    return true;
  }
};

// A px is a u, and the box is up to 1 u wider than the ink.
__attribute__((noinline)) bool find_outline(const Font& font,
                                            uint16_t glyph,
                                            OutlineGlyph& outline,
                                            Rect& box) noexcept {
  detail::InkEnds ink[2];
  bool is_mirrored;
  if (!outline.find(font, glyph, Q26_6::from_int(1024), nullptr, ink,
                    is_mirrored)) {
    return false;
  }
  BandPlan plan;
  plan.ink_margin_q8 = 128;
  outline.find_box({0, 0}, plan, 0, ink, box);
  return true;
}

// Down to the next child of `parent`.
void set_child(Level& parent, int32_t log2, Level& child) noexcept {
  const int32_t right = parent.child & 1;
  const int32_t up = parent.child >> 1;
  ++parent.child;
  const int32_t half = 1 << (log2 - 1);
  child.x_u = static_cast<uint16_t>(parent.x_u + right * half);
  child.y_u = static_cast<uint16_t>(parent.y_u + up * half);
  child.edges = parent.edges;
  for (int32_t row = 0; row < kSide; ++row) {
    for (int32_t column = 0; column < kSide; ++column) {
      const bool is_shared = ((row | column) & 1) == 0 && log2 <= kMaxCellLog2;
      child.distances_q6[kSide * row + column] =
          is_shared ? parent.distances_q6[kSide * (2 * up + row / 2) +
                                          2 * right + column / 2]
                    : kUnknown;
    }
  }
}

class Builder {
 public:
  explicit Builder(const FieldLimits& limits) noexcept : limits_(limits) {}

  // Reads the outline of a glyph that has some, and shares the buffer out.
  // Not inline: the reader's stack is free again when the tree grows.
  __attribute__((noinline)) Status open(const Font& font,
                                        uint16_t glyph,
                                        Span<uint8_t> buffer) noexcept {
    OutlineGlyph outline;
    Rect box;
    if (!find_outline(font, glyph, outline, box)) {
      return Status::unsupported;
    }
    if (!grid_.set(box, limits_)) {
      return Status::corrupt;
    }
    return share_out(outline, box, buffer) ? Status::ok : Status::buffer_small;
  }

  // Makes the record at the begin of the buffer. False: it does not fit.
  __attribute__((noinline)) bool build() noexcept {
    uint8_t* slot = record_ + glyphs::kBytes;
    for (int32_t row = 0; row < grid_.tiles_y; ++row) {
      for (int32_t column = 0; column < grid_.tiles_x; ++column, slot += 2) {
        Level& tile = *levels_;
        tile.x_u = static_cast<uint16_t>(column << grid_.tile_log2);
        tile.y_u = static_cast<uint16_t>(row << grid_.tile_log2);
        tile.edges = static_cast<uint16_t>(outline_.count());
        for (int16_t& distance : tile.distances_q6) {
          distance = kUnknown;
        }
        if (!grow_tile(slot)) {
          return false;
        }
      }
    }
    finish();
    return true;
  }

  Span<const uint8_t> record() const noexcept {
    return {record_, static_cast<size_t>(nodes_ - record_) +
                         samples::kBytes * cell_count_};
  }
  // Farther from the edge squares are saturated.
  int32_t reach_u() const noexcept {
    return limits_.fills_em ? FieldLimits::kMaxFar : limits_.band_u;
  }

 private:
  bool share_out(OutlineGlyph& outline,
                 const Rect& box,
                 Span<uint8_t> buffer) noexcept {
    const Polyline::Frame frame = {
        grid_.x0_u, grid_.y0_u, grid_.fraction,
        max(limits_.tolerance.raw >> 4, kMinChordError)};
    buffer.size &= ~size_t{3};
    if (!outline_.read(outline, box, frame, buffer)) {
      return false;
    }
    const size_t levels = sizeof(Level) * static_cast<size_t>(grid_.tile_log2);
    const size_t head = glyphs::kBytes +
                        2u * static_cast<size_t>(grid_.tiles_x * grid_.tiles_y);
    if (buffer.size < levels + head) {
      return false;
    }
    record_ = buffer.data;
    tree_ = nodes_ = record_ + head;
    cells_ = record_ + (buffer.size - levels);
    levels_ = reinterpret_cast<Level*>(cells_);
    return true;
  }

  // The first level is the tile; the reference to it goes to `slot`. The other
  // levels are divided squares, whose next children are due.
  bool grow_tile(uint8_t* slot) noexcept {
    Level* level = levels_;
    int32_t log2 = grid_.tile_log2;
    while (true) {
      uint32_t reference = settle(*level, log2);
      const bool is_divided = reference == kDivide;
      if (is_divided) {
        reference = add_node(*level);
      }
      if (reference == kFull) {
        return false;
      }
      store_u16(slot, reference);
      if (!is_divided) {
        do {
          if (level == levels_) {
            return true;
          }
          --level;
          ++log2;
        } while (level->child == kChildren);
      }
      slot = tree_ + kNodeBytes * level->node + 2u * level->child;
      set_child(*level, log2, level[1]);
      ++level;
      --log2;
    }
  }

  // The reference to a square, kDivide or kFull.
  uint32_t settle(Level& level, int32_t log2) noexcept {
    const int32_t half = to_steps(1 << log2) >> 1;
    const int32_t x = to_steps(level.x_u) + half;
    const int32_t y = to_steps(level.y_u) + half;
    const int32_t centre =
        log2 > kMaxCellLog2
            ? outline_.distance(x, y, level.edges)
            : distance_q6(level, log2, 2, 2) >> (kMaxFraction - grid_.fraction);
    const int32_t radius = (half * 182 >> 7) + kRounded;
    if (abs(centre) - radius > to_steps(reach_u())) {
      return centre > 0 ? glyphs::kInside : glyphs::kOutside;
    }
    // No point of the square is farther from the edge than the centre is, and
    // the radius; so no edge matters that is farther from the centre by another
    // one.
    level.edges = static_cast<uint16_t>(
        outline_.keep(x, y, level.edges, abs(centre) + 2 * radius + kRounded));
    if (log2 > kMaxCellLog2) {
      return kDivide;
    }
    uint8_t cell[samples::kBytes];
    make_cell(level, log2, cell);
    // Samples of a single edge are right anywhere between them.
    if (log2 > kMinCellLog2 && level.edges > 1 && !is_good(level, log2, cell)) {
      return kDivide;
    }
    return add_cell(cell);
  }

  // The true distance at a point of the lattice. [u]
  int32_t distance_q6(Level& level,
                      int32_t log2,
                      int32_t column,
                      int32_t row) const noexcept {
    int16_t& known = level.distances_q6[kSide * row + column];
    if (known == kUnknown) {
      const int32_t shift = log2 + grid_.fraction - 2;
      const int32_t steps =
          outline_.distance(to_steps(level.x_u) + (column << shift),
                            to_steps(level.y_u) + (row << shift), level.edges);
      const int32_t value = steps * (1 << (kMaxFraction - grid_.fraction));
      known =
          static_cast<int16_t>(min(max(value, -INT16_MAX), int32_t{INT16_MAX}));
    }
    return known;
  }

  void make_cell(Level& level, int32_t log2, uint8_t* cell) const noexcept {
    const int32_t centre = distance_q6(level, log2, 2, 2);
    store_u16(cell + samples::kCentre, static_cast<uint32_t>(centre));
    uint8_t* out = cell + samples::kOffsets;
    for (int32_t row = 0; row < kSide; row += 2) {
      for (int32_t column = 0; column < kSide; column += 2) {
        if (row != 2 || column != 2) {
          // 1/64 u in 1/128 of the cell, to the nearest.
          const int32_t offset =
              2 * (distance_q6(level, log2, column, row) - centre);
          const int32_t quanta = (offset + (1 << log2 >> 1)) >> log2;
          *out++ = static_cast<uint8_t>(
              min(max(quanta, INT8_MIN), int32_t{INT8_MAX}));
        }
      }
    }
  }

  // Whether what a reader makes of the cell is near the distances that it is
  // not made of. Beyond the band nothing matters but that it is beyond, which
  // one point tells of its neighbours if the band is wider by the way to them.
  bool is_good(Level& level, int32_t log2, const uint8_t* cell) const noexcept {
    const int32_t band_q10 = reach_u() * 1024 + (1024 << log2 >> 2);
    const auto clamped = [band_q10](int32_t distance_q10) noexcept {
      return min(max(distance_q10, -band_q10), band_q10);
    };
    const auto place_q16 = [log2](int32_t number) noexcept {
      return (number << (14 + log2)) - (number == kSide - 1 ? 1 : 0);
    };
    for (int32_t row = 0; row < kSide; ++row) {
      const SamplesRow line =
          detail::cell_row(cell, static_cast<uint32_t>(log2),
                           static_cast<uint32_t>(place_q16(row)));
      const int32_t step = (row & 1) != 0 ? 1 : 2;
      for (int32_t column = step - 1; column < kSide; column += step) {
        const int32_t truth = 16 * distance_q6(level, log2, column, row);
        const int32_t error =
            clamped(line.distance_q10(place_q16(column))) - clamped(truth);
        const int32_t far = abs(truth) >> kFarPartLog2;
        const bool is_far = abs(truth) > limits_.band_u * 1024;
        if (abs(error) > limits_.tolerance.raw + (is_far ? far : 0)) {
          return false;
        }
      }
    }
    return true;
  }

  // The reference to a cell; they are numbered from the last one until
  // finish().
  uint32_t add_cell(const uint8_t* cell) noexcept {
    if (!has_room(samples::kBytes) || cell_count_ == glyphs::kMaxCells) {
      return kFull;
    }
    cells_ -= samples::kBytes;
    __builtin_memcpy(cells_, cell, samples::kBytes);
    return glyphs::kCellFlag | cell_count_++;
  }

  // The reference to a node whose children come next.
  uint32_t add_node(Level& level) noexcept {
    const auto number = static_cast<uint32_t>(nodes_ - tree_) / kNodeBytes;
    if (!has_room(kNodeBytes) || number == glyphs::kMaxNodes) {
      return kFull;
    }
    nodes_ += kNodeBytes;
    level.node = static_cast<uint16_t>(number);
    level.child = 0;
    return glyphs::kFirstNode + number;
  }

  // Closes the gap between nodes and cells, and numbers cells from the lowest.
  void finish() noexcept {
    for (uint8_t* at = record_ + glyphs::kBytes; at != nodes_; at += 2) {
      const uint32_t reference = detail::load_u16(at);
      if (reference >= glyphs::kCellFlag) {
        store_u16(at, 2 * glyphs::kCellFlag + cell_count_ - 1 - reference);
      }
    }
    __builtin_memmove(nodes_, cells_, samples::kBytes * cell_count_);
    record_[glyphs::kType] = glyphs::kTypeSamples;
    record_[glyphs::kTileLog2] = static_cast<uint8_t>(grid_.tile_log2);
    store_u16(record_ + glyphs::kX0, static_cast<uint32_t>(grid_.x0_u));
    store_u16(record_ + glyphs::kY0, static_cast<uint32_t>(grid_.y0_u));
    record_[glyphs::kTilesX] = static_cast<uint8_t>(grid_.tiles_x);
    record_[glyphs::kTilesY] = static_cast<uint8_t>(grid_.tiles_y);
    store_u16(record_ + glyphs::kNodeCount,
              static_cast<uint32_t>(nodes_ - tree_) / kNodeBytes);
    store_u16(record_ + glyphs::kCellCount, cell_count_);
  }

  bool has_room(size_t bytes) const noexcept {
    return static_cast<size_t>(cells_ - nodes_) >= bytes;
  }
  int32_t to_steps(int32_t u) const noexcept { return u << grid_.fraction; }

  Grid grid_ = {};
  const FieldLimits& limits_;
  Polyline outline_;
  Level* levels_ = nullptr;
  uint8_t* record_ = nullptr;
  uint8_t* tree_ = nullptr;   // the first node
  uint8_t* nodes_ = nullptr;  // behind the last one
  uint8_t* cells_ = nullptr;  // the last cell, which is the lowest
  uint32_t cell_count_ = 0;
};

bool are_valid(const FieldLimits& limits) noexcept {
  return limits.tolerance.raw >= FieldLimits::kMinTolerance.raw &&
         limits.tolerance.raw <= FieldLimits::kMaxTolerance.raw &&
         limits.band_u >= 1 && limits.band_u <= FieldLimits::kMaxBand;
}

}  // namespace

Status generate_field(const Font& font,
                      uint16_t glyph,
                      const FieldLimits& limits,
                      Span<uint8_t> buffer,
                      GlyphField& out) noexcept {
  if (glyph >= font.glyph_count()) {
    return Status::no_glyph;
  }
  if (!are_valid(limits)) {
    return Status::bad_argument;
  }
  const Span<const uint8_t> record = font.record(glyph);
  if (record.size == 0) {
    out = {};
    return Status::ok;
  }
  if (!detail::is_outline(record)) {
    return Status::unsupported;
  }
  if (reinterpret_cast<uintptr_t>(buffer.data) % 4 != 0) {
    return Status::misaligned;
  }
  Builder builder(limits);
  INKCELL_TRY(builder.open(font, glyph, buffer));
  if (!builder.build()) {
    return Status::buffer_small;
  }
  INKCELL_TRY(GlyphField::open(builder.record(), out));
  out.ink = font.ink_box(glyph);
  out.band_u = static_cast<uint16_t>(builder.reach_u());
  return Status::ok;
}

Status open_field(const Font& font,
                  uint16_t glyph,
                  const FieldLimits& limits,
                  Span<uint8_t> buffer,
                  GlyphField& out) noexcept {
  const Span<const uint8_t> record = font.record(glyph);
  if (record.size == 0 || detail::is_outline(record)) {
    return generate_field(font, glyph, limits, buffer, out);
  }
  if (!are_valid(limits)) {
    return Status::bad_argument;
  }
  if (limits.fills_em || font.range().band_u < limits.band_u) {
    return Status::beyond_band;
  }
  INKCELL_TRY(read_field(font, glyph, out));
  out.band_u = font.range().band_u;
  return Status::ok;
}

}  // namespace inkcell
