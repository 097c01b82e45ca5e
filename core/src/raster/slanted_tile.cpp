// Tiles of any map. A leaf is a rectangle that leans. It is found at a sample
// that nothing was drawn at, and followed from row to row:
//
//        . . a a . .      row 0 finds a at its third sample,
//        . a a a a .      row 1 begins a sample further left,
//        a a a a . .      row 2, too, and ends further left.
//
// If a row does not touch the one above, the leaf may be found again.
#include "place/cell_raster.hpp"
#include "raster/paint_leaf.hpp"

namespace inkcell {
namespace detail {
namespace {

// In cells that are so wide primitives are asked whether they matter. [px]
constexpr uint32_t kMinWide = 6;
// Larger cells are not: px from side to side would pass 32 bits. None keeps the
// format's limits. [log2 u]
constexpr uint8_t kMostPruned = 10;

// The number of the lowest bit of those that are set.
inline int32_t lowest_bit(uint32_t bits) noexcept {
  // Each product's upper 5 bits are others: a sequence of de Bruijn.
  static constexpr uint8_t kNumbers[32] = {
      0,  1,  28, 2,  29, 14, 24, 3, 30, 22, 20, 15, 25, 17, 4,  8,
      31, 27, 13, 23, 21, 19, 16, 7, 26, 12, 18, 6,  11, 5,  10, 9};
  return kNumbers[((bits & (0u - bits)) * 0x077cb531u) >> 27];
}

// The bits from a number on, before another one up to 31.
inline uint32_t bits_between(int32_t begin, int32_t end) noexcept {
  return (1u << end) - (1u << begin);
}

// A range of places. [u, Q16]
struct Range {
  uint32_t low;
  uint32_t length;

  bool holds(uint32_t place) const noexcept { return place - low < length; }
  // Which side a place lies on: 0 if it is in the range.
  uint32_t side_of(uint32_t place) const noexcept {
    const uint32_t from = place - low;
    return from < length ? 0 : 1 + (from >> 31);
  }
};

// What may show, from the grid's corner.
struct Limits {
  Range x;
  Range y;

  explicit Limits(const CellMap& map) noexcept {
    const Rect limits = limits_of(map);
    x = range(map.field.x0_u, limits.x0, limits.x1);
    y = range(map.field.y0_u, limits.y0, limits.y1);
  }

 private:
  static Range range(int32_t corner, int32_t low, int32_t end) noexcept {
    return {static_cast<uint32_t>(low - corner) << 16,
            low < end ? static_cast<uint32_t>(end - low) << 16 : 0};
  }
};

// A row of a leaf: a rectangle, from one corner, the first sample in it, and
// the row's samples.
struct LeafRow {
  uint32_t across;
  uint32_t high;
  uint32_t x;
  uint32_t y;
  int32_t begin;
  int32_t end;

  __attribute__((always_inline)) bool holds(uint32_t at_x,
                                            uint32_t at_y) const noexcept {
    return at_x < across && at_y < high;
  }
  // Moves the end as far as samples lie in the rectangle; the last one does,
  // and lies here.
  __attribute__((always_inline)) void stretch(const GlyphStep& right,
                                              uint32_t at_x,
                                              uint32_t at_y,
                                              int32_t most) noexcept {
    while (end != most) {
      at_x += static_cast<uint32_t>(right.x_q16);
      at_y += static_cast<uint32_t>(right.y_q16);
      if (!holds(at_x, at_y)) {
        break;
      }
      ++end;
    }
  }
  // To the row below. False: no sample of it below those of this row lies in
  // the rectangle.
  __attribute__((always_inline)) bool next_row(const GlyphStep& right,
                                               const GlyphStep& up,
                                               int32_t width) noexcept {
    x -= static_cast<uint32_t>(up.x_q16);
    y -= static_cast<uint32_t>(up.y_q16);
    if (!find_begin(right)) {
      return false;
    }
    find_end(right, width);
    return true;
  }

 private:
  __attribute__((always_inline)) bool find_begin(
      const GlyphStep& right) noexcept {
    const auto step_x = static_cast<uint32_t>(right.x_q16);
    const auto step_y = static_cast<uint32_t>(right.y_q16);
    if (holds(x, y)) {
      while (begin != 0 && holds(x - step_x, y - step_y)) {
        x -= step_x;
        y -= step_y;
        --begin;
      }
      return true;
    }
    do {
      x += step_x;
      y += step_y;
      ++begin;
    } while (begin != end && !holds(x, y));
    return begin != end;
  }
  __attribute__((always_inline)) void find_end(const GlyphStep& right,
                                               int32_t width) noexcept {
    const auto last = static_cast<uint32_t>(end - 1 - begin);
    uint32_t end_x = x + times(right.x_q16, last);
    uint32_t end_y = y + times(right.y_q16, last);
    if (holds(end_x, end_y)) {
      stretch(right, end_x, end_y, width);
      return;
    }
    do {
      end_x -= static_cast<uint32_t>(right.x_q16);
      end_y -= static_cast<uint32_t>(right.y_q16);
      --end;
    } while (!holds(end_x, end_y));
  }
};

// Where a place lies in its leaf's square, as far as that may show.
struct Clipped {
  uint32_t at;
  uint32_t length;

  Clipped(uint32_t place, uint32_t mask, const Range& limits) noexcept {
    const uint32_t from = place - limits.low;
    at = place & mask;
    at = at < from ? at : from;
    const uint32_t in_square = ~place & mask;
    const uint32_t in_limits = limits.length - 1 - from;
    length = at + (in_square < in_limits ? in_square : in_limits) + 1;
  }
};

// How many samples from one beyond the limits on lie beyond them, too, on the
// same side: at least one, or fewer than there are.
int32_t count_beyond(const Limits& limits,
                     const CellMap& map,
                     GlyphPoint at,
                     int32_t left) noexcept {
  const uint32_t side_x = limits.x.side_of(at.x_q16);
  const uint32_t side_y = limits.y.side_of(at.y_q16);
  for (int32_t count = left; count > 1; count >>= 1) {
    const auto last = static_cast<uint32_t>(count - 1);
    const uint32_t x_q16 = at.x_q16 + times(map.right.x_q16, last);
    const uint32_t y_q16 = at.y_q16 + times(map.right.y_q16, last);
    if ((side_x != 0 && limits.x.side_of(x_q16) == side_x) ||
        (side_y != 0 && limits.y.side_of(y_q16) == side_y)) {
      return count;
    }
  }
  return 1;
}

// Sets the samples of a leaf, row by row, given the first one, and takes them
// out of `todo`. Those that show nothing for sure are not among them.
__attribute__((noinline)) void find_spans(const CellMap& map,
                                          const Limits& limits,
                                          TileLeaf& leaf,
                                          const GlyphPoint& at,
                                          TileSpan* spans,
                                          int32_t width,
                                          int32_t height,
                                          uint32_t* todo) noexcept {
  const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
  const Clipped x(at.x_q16, mask, limits.x);
  const Clipped y(at.y_q16, mask, limits.y);
  LeafRow row = {x.length, y.length,     x.at,
                 y.at,     spans->begin, spans->begin + 1};
  row.stretch(map.right, row.x, row.y, width);
  int32_t rows = 0;
  do {
    spans[rows] = {static_cast<uint8_t>(row.begin),
                   static_cast<uint8_t>(row.end)};
    todo[rows] &= ~bits_between(row.begin, row.end);
  } while (++rows != height && row.next_row(map.right, map.up, width));
  leaf.height = static_cast<uint8_t>(rows);
}

}  // namespace

// What matters of a leaf in the box around its samples, as far as that lies in
// its square.
__attribute__((noinline)) void CellBand::prune_spans(
    TileLeaf& leaf, const GlyphPoint& at) const noexcept {
  int32_t begin = kTileColumns;
  int32_t end = 0;
  for (int32_t row = 0; row < leaf.height; ++row) {
    begin = min(begin, leaf.spans[row].begin);
    end = max(end, leaf.spans[row].end);
  }
  // From the first sample.
  const int32_t first = begin - leaf.spans[0].begin;
  const int32_t last = end - 1 - leaf.spans[0].begin;
  const int32_t down = leaf.height - 1;
  const uint32_t mask = (1u << (leaf.size_log2 + 16)) - 1;
  const auto px_q8 = [this](uint32_t u_q16) noexcept {
    return static_cast<int32_t>(((u_q16 >> 10) * (scale_.size_q8 >> 2)) >> 14);
  };
  // More than what is cut off.
  constexpr int32_t kMargin = 8;
  const auto extend = [&](uint32_t place_q16, uint32_t place_q20,
                          int32_t right_q20, int32_t up_q20,
                          uint32_t& middle_q8, uint32_t& half_q8) noexcept {
    const int32_t right_q12 = right_q20 >> 8;
    const int32_t down_q12 = -down * (up_q20 >> 8);
    const int32_t low_q12 =
        min(right_q12 * first, right_q12 * last) + min(down_q12, int32_t{0});
    const int32_t high_q12 =
        max(right_q12 * first, right_q12 * last) + max(down_q12, int32_t{0});
    const int32_t low = max((low_q12 >> 4), -px_q8(place_q16 & mask)) - kMargin;
    const int32_t high =
        min((high_q12 >> 4), px_q8(~place_q16 & mask)) + kMargin;
    middle_q8 = q8_of(place_q20) + static_cast<uint32_t>((low + high) >> 1);
    half_q8 = static_cast<uint32_t>((high - low + 1) >> 1);
  };
  Extent all;
  extend(at.x_q16, at.x_q20, map_.right.x_q20, map_.up.x_q20, all.middle.x_q8,
         all.half_x_q8);
  extend(at.y_q16, at.y_q20, map_.right.y_q20, map_.up.y_q20, all.middle.y_q8,
         all.half_y_q8);
  all.right = &map_.right;
  constexpr uint32_t kMostHalf = 64 << 8;
  if (all.half_x_q8 < kMostHalf && all.half_y_q8 < kMostHalf) {
    prune(leaf, all);
  }
}

void CellBand::paint_spans(TileLeaf& leaf,
                           const GlyphPoint& at) const noexcept {
  if (leaf.count == 0) {
    uint8_t* line = leaf.line - leaf.spans->begin;
    for (int32_t row = 0; row < leaf.height; ++row, line += kTileColumns) {
      const TileSpan& span = leaf.spans[row];
      fill_inside(line + span.begin, span.end - span.begin);
    }
  } else if (stretching() != nullptr) {
    paint<StretchedValues>(leaf, at);
  } else if (!leaf.has_primitives()) {
    paint<SamplePoints>(leaf, at);
  } else if (!kFastCells) {
    paint_points(leaf, at);
  } else if (leaf.count == 1) {
    // Lines, too: a loop of their own is 1 % faster at 96 px, for 340 bytes.
    paint<PointValues<ArcValue, 1>>(leaf, at);
  } else if (leaf.count == 2) {
    if (leaf.has_lines(2)) {
      paint<PointValues<LineValue, 2>>(leaf, at);
    } else {
      paint<PointValues<ArcValue, 2>>(leaf, at);
    }
  } else if (leaf.has_lines(3)) {
    paint<PointValues<LineValue, 3>>(leaf, at);
  } else {
    paint<PointValues<ArcValue, 3>>(leaf, at);
  }
}

// Not inline: its leaf is off the stack when rows go to the sink.
__attribute__((noinline)) bool CellBand::cover_slanted(
    const CellBand& band,
    const GlyphPoint& first,
    int32_t width,
    int32_t height,
    uint8_t* lines) noexcept {
  const CellMap& map = band.map_;
  const Limits limits(map);
  uint32_t todo[kTileRows];
  for (int32_t y = 0; y < height; ++y) {
    todo[y] = bits_between(0, width);
  }
  const bool has_stripes = band.stripes_ != nullptr;
  bool any = false;
  GlyphPoint row = first;
  for (int32_t y = 0; y < height; ++y) {
    int32_t beyond = 0;  // samples before the row enters what may show
    while (todo[y] != 0) {
      const int32_t x = lowest_bit(todo[y]);
      GlyphPoint at = row;
      at.advance(map.right, static_cast<uint32_t>(x));
      if (!limits.x.holds(at.x_q16) || !limits.y.holds(at.y_q16)) {
        // Once a row has left what may show it does not come back.
        beyond =
            x != beyond ? width : x + count_beyond(limits, map, at, width - x);
        todo[y] &= ~bits_between(0, beyond);
        continue;
      }
      TileLeaf leaf;
      TileSpan spans[kTileRows];
      if (has_stripes && !is_in_grid(map.field, at)) {
        band.paint_beyond(at, lines + 3 * (y * kTileColumns + x));
        any = true;
        todo[y] &= ~bits_between(x, x + 1);
        continue;
      }
      find_leaf(map.field, at.x_q16 >> 16, at.y_q16 >> 16, leaf);
      spans[0].begin = static_cast<uint8_t>(x);
      leaf.spans = spans;
      find_spans(map, limits, leaf, at, spans, width, height - y, todo + y);
      if (leaf.count == 0 && !leaf.is_inside) {
        continue;
      }
      leaf.line = lines + (y * kTileColumns + x) * (has_stripes ? 3 : 1);
      if (leaf.height == 1 && spans[0].end - x == 1 && leaf.has_primitives() &&
          band.stretching() == nullptr && !has_stripes) {
        any = true;
        leaf.place = at.place();
        *leaf.line = band.byte_of(leaf);
        continue;
      }
      leaf.disable_skip();
      if (kFastCells && band.may_prune_ && leaf.has_primitives() &&
          leaf.size_log2 <= kMostPruned &&
          band.scale_.size_q8 << leaf.size_log2 >= kMinWide << 18) {
        band.prune_spans(leaf, at);
      }
      if (leaf.count != 0 || leaf.is_inside) {
        any = true;
        if (has_stripes) {
          band.stripes_->paint(band, leaf, at);
        } else {
          band.paint_spans(leaf, at);
        }
      }
    }
    row.advance(map.up, UINT32_MAX);
  }
  return any;
}

namespace {

bool find_slanted(const CellMap& map,
                  int32_t x,
                  int32_t y,
                  GlyphPoint& out) noexcept {
  return map.find(x, y, out);
}

constexpr auto kFind = kHasCells ? find_slanted : nullptr;
constexpr auto kCover = kHasCells ? CellBand::cover_slanted : nullptr;

}  // namespace

const CellRaster kTurnedCells = {clip_slanted, kFind, kCover, nullptr};
const CellRaster kStretchedCells = {clip_slanted, kFind, kCover,
                                    kHasCells ? &kStretching : nullptr};

}  // namespace detail
}  // namespace inkcell
