// Cells of fields in object order: every cell once, and within it from row to
// row.
//
// The fields of a cell are set up at its upper left pixel and then followed by
// addition, exact modulo 2^32, so that no pixel depends on where a window cuts
// the cell. What a field's slopes allow within the cell tells how far from 0 it
// must be to leave a whole row, or the whole cell, saturated; such fields are
// dropped or decide alone. What is left is followed along the row, and where it
// is saturated as many pixels are skipped as its slope allows.
#include "field_combine.hpp"

namespace inkcell {
namespace detail {
namespace {

// Cells are cut into blocks of at most so many pixels on a side: no product of
// a slope and a way wraps.
constexpr int32_t kMaxSide = 128;

// Roundings of bent fields do not reach so far. [px, Q22]
constexpr int32_t kArcMargin = 1 << 18;

// What a block shows: nothing, all, or what its distances say.
enum class Side : int8_t { outside = -1, edge = 0, inside = 1 };

// Whole pixels of the glyph's box: columns from the left, rows from the top.
struct Block {
  int32_t left;
  int32_t top;
  int32_t right;
  int32_t bottom;
};

// A field on its way through a block.
struct Track {
  uint32_t plane_q22;  // at the first pixel of the row
  uint32_t along_q22;
  uint32_t dx_q22;  // n, by which the plane changes in a pixel
  uint32_t dy_q22;
  int32_t bend;
  // From here on, and up to here, the rest of a row is saturated; for values
  // with the leaf's sign.
  int32_t inside_q22;
  int32_t outside_q22;
  uint16_t unit;

  int32_t value_q22(int32_t bend_log2, int32_t sign) const noexcept {
    const FieldTerm term = {plane_q22, bend, along_q22, 0, 0};
    return with_sign(term.value_q22(bend_log2), sign);
  }
  void move_right(uint32_t pixels) noexcept {
    plane_q22 += pixels * dx_q22;
    along_q22 -= pixels * dy_q22;
  }
  void move_right() noexcept {
    plane_q22 += dx_q22;
    along_q22 -= dy_q22;
  }
  void move_down() noexcept {
    plane_q22 -= dy_q22;
    along_q22 -= dx_q22;
  }
};

int32_t lesser(int32_t a, int32_t b) noexcept {
  return a < b ? a : b;
}
int32_t greater(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}
int32_t magnitude(int32_t value) noexcept {
  return value < 0 ? wrapped(0u - static_cast<uint32_t>(value)) : value;
}

// From the least to the greatest value of something linear over a block.
struct Reach {
  int32_t low;
  int32_t high;

  Reach(uint32_t first, uint32_t right, uint32_t down) noexcept {
    const int32_t a = wrapped(right);
    const int32_t b = wrapped(down);
    low = wrapped(first + static_cast<uint32_t>(lesser(a, 0)) +
                  static_cast<uint32_t>(lesser(b, 0)));
    high = wrapped(first + static_cast<uint32_t>(greater(a, 0)) +
                   static_cast<uint32_t>(greater(b, 0)));
  }
};

// Draws the leaves of a glyph.
class Cells {
 public:
  Cells(FieldPage& page, const Upright& upright) noexcept
      : page_(page),
        pixels_(upright.pixels),
        left_q16_(upright.at.x_q16 - page.field.x0_u * (1 << 16)),
        top_q16_(upright.at.y_q16 - page.field.y0_u * (1 << 16)),
        x_q8_(q8_of(upright.at.x_q20)),
        y_q8_(q8_of(upright.at.y_q20)) {}

  void draw() noexcept;

 private:
  int32_t columns() const noexcept { return pixels_.x1 - pixels_.x0; }
  int32_t rows() const noexcept { return pixels_.y1 - pixels_.y0; }
  int32_t pixels_before(int32_t way_q16, int32_t most) const noexcept;
  bool cut(uint32_t x, uint32_t y, uint32_t log2, Block& out) const noexcept;
  void draw_tile(uint32_t reference, uint32_t x, uint32_t y) noexcept;
  void draw_leaf(uint32_t reference, const Block& cell) noexcept;
  void draw_block(LeafFields leaf, const Block& block) noexcept;
  void fill(const Block& block) noexcept;
  Side set_up(Track& track, int32_t sign, const Block& block) noexcept;
  Side set_up_all(LeafFields& leaf, const Block& block) noexcept;
  void draw_single(const Track& first, int32_t x, int32_t end) noexcept;
  void draw_pair(const Track& first,
                 const Track& second,
                 PixelPlace place,
                 int32_t x,
                 int32_t end) noexcept;
  void draw_triple(const LeafFields& leaf,
                   PixelPlace place,
                   int32_t x,
                   int32_t end) noexcept;
  void draw_three(const LeafFields& leaf,
                  PixelPlace place,
                  int32_t x,
                  int32_t end) noexcept;
  Side side_of(uint32_t i) const noexcept;
  void saturate(int32_t x, int32_t end, bool inside) noexcept;
  void put(int32_t value_q22, int32_t x) noexcept;
  bool is_on_ramp(int32_t value_q22) const noexcept;
  int32_t skipped(int32_t value_q22) const noexcept;

  FieldPage& page_;
  const Rect& pixels_;
  int32_t left_q16_;  // the first pixel, from the grid's corner
  int32_t top_q16_;
  uint32_t x_q8_;
  uint32_t y_q8_;
  // Of the block.
  Track tracks_[3];
  int32_t sign_;
  int32_t slope_q14_;
  int32_t margin_q22_;
  uint32_t pixels_per_slope_;
};

// How many pixels lie before a place `way_q16` further on, the first of them at
// 0; `most` at the most. [u]
inline int32_t Cells::pixels_before(int32_t way_q16,
                                    int32_t most) const noexcept {
  if (way_q16 <= 0) {
    return 0;
  }
  // A guess from a px being 65536 u / size: right, or up to two too low.
  const uint32_t size_q6 = page_.scale.size_q8 >> 2;
  const int32_t step = page_.step_q16;
  auto count = static_cast<int32_t>(
      ((static_cast<uint32_t>(way_q16) >> 13) * size_q6) >> 19);
  if (count >= most) {
    return most;
  }
  int32_t left = way_q16 - count * step;
  if (left > 0) {
    ++count;
    left -= step;
  }
  if (left > 0) {
    ++count;
  }
  return lesser(count, most);
}

// The pixels whose centres lie in a square of the grid. False: there are none.
bool Cells::cut(uint32_t x,
                uint32_t y,
                uint32_t log2,
                Block& out) const noexcept {
  const auto left_q16 = static_cast<int32_t>(x << 16) - left_q16_;
  const int32_t top_q16 = top_q16_ - static_cast<int32_t>(y << 16);
  const int32_t size_q16 = static_cast<int32_t>(1u << (16 + log2));
  out.bottom = pixels_before(top_q16 + 1, rows());
  out.top = pixels_before(top_q16 - size_q16 + 1, out.bottom);
  if (out.top == out.bottom) {
    return false;
  }
  out.right = pixels_before(left_q16 + size_q16, columns());
  out.left = pixels_before(left_q16, out.right);
  return out.left != out.right;
}

void Cells::fill(const Block& block) noexcept {
  for (int32_t row = block.top; row < block.bottom; ++row) {
    page_.writer.go_to_row(pixels_.y0 + row);
    page_.writer.solid(pixels_.x0 + block.left, block.right - block.left);
    page_.writer.flush();
  }
}

// Sets a field up at the block's upper left pixel. What it shows of the block.
Side Cells::set_up(Track& track, int32_t sign, const Block& block) noexcept {
  const int32_t bend_log2 = page_.scale.bend_log2;
  const auto wide = static_cast<uint32_t>(block.right - block.left - 1);
  const auto high = static_cast<uint32_t>(block.bottom - block.top - 1);
  FieldTerm term;
  set_up_term(term, page_.field, track.unit,
              x_q8_ + (static_cast<uint32_t>(block.left) << 8),
              y_q8_ - (static_cast<uint32_t>(block.top) << 8), page_.scale);
  track.plane_q22 = term.plane_q22;
  track.along_q22 = term.along_q22;
  track.bend = term.bend;
  track.dx_q22 = static_cast<uint32_t>(term.nx_q14) << 8;
  track.dy_q22 = static_cast<uint32_t>(term.ny_q14) << 8;
  Reach value(track.plane_q22, wide * track.dx_q22, 0u - high * track.dy_q22);
  // The slopes along a row. [px per px, Q14]
  int32_t least = term.nx_q14;
  int32_t most = term.nx_q14;
  int32_t margin = 0;
  if (term.bend != 0) {
    const Reach along(track.along_q22, 0u - wide * track.dy_q22,
                      0u - high * track.dx_q22);
    FieldTerm end = term;
    end.plane_q22 = 0;
    end.along_q22 = static_cast<uint32_t>(along.low);
    const auto steep = [&end, bend_log2] {
      return wrapped(times(end.ny_q14,
                           static_cast<uint32_t>(end.slope_q15(bend_log2)))) >>
             14;
    };
    const int32_t low_slope = steep();
    const int32_t low_sag = end.value_q22(bend_log2);
    end.along_q22 = static_cast<uint32_t>(along.high);
    const int32_t high_slope = steep();
    const int32_t high_sag = end.value_q22(bend_log2);
    least = term.nx_q14 - greater(low_slope, high_slope) - 1;
    most = term.nx_q14 - lesser(low_slope, high_slope) + 1;
    value.low += lesser(lesser(low_sag, high_sag), 0);
    value.high += greater(greater(low_sag, high_sag), 0);
    margin = kArcMargin;
    margin_q22_ = kArcMargin;
  }
  const int32_t reach_q22 = page_.reach_q22 + margin;
  if (value.low >= reach_q22) {
    return sign == 0 ? Side::inside : Side::outside;
  }
  if (value.high <= -reach_q22) {
    return sign == 0 ? Side::outside : Side::inside;
  }
  const auto width = static_cast<int32_t>(wide) << 8;
  const int32_t down_q22 = width * lesser(least, 0);
  const int32_t up_q22 = width * greater(most, 0);
  track.inside_q22 = reach_q22 + (sign == 0 ? -down_q22 : up_q22);
  track.outside_q22 = -reach_q22 + (sign == 0 ? -up_q22 : down_q22);
  slope_q14_ = greater(slope_q14_, greater(most, -least));
  return Side::edge;
}

// Sets up the fields of a leaf and keeps those that matter. What the block
// shows, as if the operator asked for the least.
Side Cells::set_up_all(LeafFields& leaf, const Block& block) noexcept {
  slope_q14_ = 64;
  margin_q22_ = 0;
  Side sides[3];
  const uint32_t all = leaf.count;
  leaf.count = 0;
  for (uint32_t i = 0; i < all; ++i) {
    Track& track = tracks_[leaf.count];
    track.unit = leaf.units[i];
    sides[i] = set_up(track, leaf.sign, block);
    if (sides[i] == Side::outside && (i == 0 || !leaf.is_nested)) {
      return Side::outside;
    }
    if (sides[i] == Side::edge) {
      leaf.units[leaf.count++] = track.unit;
    }
  }
  if (leaf.is_nested) {
    const bool is_first_left = sides[0] == Side::edge;
    if (sides[1] == Side::outside && sides[2] == Side::outside) {
      return Side::outside;
    }
    if (sides[1] == Side::inside || sides[2] == Side::inside) {
      leaf.count = is_first_left ? 1 : 0;
    }
    leaf.is_nested = leaf.count == 3;
    if (leaf.count != 0 && !leaf.is_nested && !is_first_left) {
      // The greater of the others is all.
      leaf.sign = ~leaf.sign;
      for (uint32_t i = 0; i < leaf.count; ++i) {
        const int32_t inside_q22 = tracks_[i].inside_q22;
        tracks_[i].inside_q22 = -tracks_[i].outside_q22;
        tracks_[i].outside_q22 = -inside_q22;
      }
    }
  }
  return leaf.count == 0 ? Side::inside : Side::edge;
}

// How many pixels from one on show the same, given its value, which is beyond
// the ramp.
inline int32_t Cells::skipped(int32_t value_q22) const noexcept {
  constexpr int32_t kMost = (1 << 14) - 1;
  const int32_t way_q8 =
      (magnitude(value_q22) - page_.reach_q22 - margin_q22_) >> 14;
  if (way_q8 <= 0) {
    return 1;
  }
  return 1 +
         static_cast<int32_t>((static_cast<uint32_t>(lesser(way_q8, kMost)) *
                               pixels_per_slope_) >>
                              18);
}

// Pixels up to `end` that are all saturated.
inline void Cells::saturate(int32_t x, int32_t end, bool inside) noexcept {
  page_.writer.saturated(x, end - x, inside == (sign_ == 0));
}

// A pixel of the ramp.
inline void Cells::put(int32_t value_q22, int32_t x) noexcept {
  page_.writer.begin(x);
  page_.writer.append(page_.filter.coverage(with_sign(value_q22, sign_) >> 12),
                      x + 1);
}

inline bool Cells::is_on_ramp(int32_t value_q22) const noexcept {
  return value_q22 < page_.reach_q22 && value_q22 > -page_.reach_q22;
}

// A row, or the rest of one, of one field.
void Cells::draw_single(const Track& first, int32_t x, int32_t end) noexcept {
  const int32_t bend_log2 = page_.scale.bend_log2;
  Track track = first;
  while (true) {
    const int32_t value_q22 = track.value_q22(bend_log2, sign_);
    if (is_on_ramp(value_q22)) {
      put(value_q22, x);
      if (++x == end) {
        return;
      }
      track.move_right();
      continue;
    }
    if (value_q22 >= track.inside_q22 || value_q22 <= track.outside_q22) {
      saturate(x, end, value_q22 > 0);
      return;
    }
    const int32_t step = lesser(skipped(value_q22), end - x);
    saturate(x, x + step, value_q22 > 0);
    x += step;
    if (x == end) {
      return;
    }
    track.move_right(static_cast<uint32_t>(step));
  }
}

// The same of two, until one of them decides all that is left.
void Cells::draw_pair(const Track& first,
                      const Track& second,
                      PixelPlace place,
                      int32_t x,
                      int32_t end) noexcept {
  const int32_t bend_log2 = page_.scale.bend_log2;
  Track a = first;
  Track b = second;
  while (true) {
    int32_t values[2] = {a.value_q22(bend_log2, sign_),
                         b.value_q22(bend_log2, sign_)};
    if (values[0] <= a.outside_q22 || values[1] <= b.outside_q22) {
      saturate(x, end, false);
      return;
    }
    if (values[0] >= a.inside_q22) {
      draw_single(b, x, end);
      return;
    }
    if (values[1] >= b.inside_q22) {
      draw_single(a, x, end);
      return;
    }
    const bool in_order = values[0] <= values[1];
    int32_t value_q22 = in_order ? values[0] : values[1];
    int32_t step = 1;
    if (is_on_ramp(value_q22)) {
      // Where the greater one is farther from 0 no vertex is near.
      if (value_q22 < 0 && values[0] + values[1] < 0) {
        const LeafFields leaf = {{a.unit, b.unit}, false, 2, sign_};
        value_q22 = rounded_at(page_, leaf, in_order ? 0 : 1, in_order ? 1 : 0,
                               values, place);
      }
      put(value_q22, x);
    } else {
      step = lesser(skipped(value_q22), end - x);
      saturate(x, x + step, value_q22 > 0);
    }
    x += step;
    if (x == end) {
      return;
    }
    place.x_q8 += static_cast<uint32_t>(step) << 8;
    a.move_right(static_cast<uint32_t>(step));
    b.move_right(static_cast<uint32_t>(step));
  }
}

// A row of three fields that all matter.
void Cells::draw_triple(const LeafFields& leaf,
                        PixelPlace place,
                        int32_t x,
                        int32_t end) noexcept {
  uint32_t way = 0;
  while (x < end) {
    int32_t values[3];
    for (uint32_t i = 0; i < 3; ++i) {
      Track track = tracks_[i];
      track.move_right(way);
      values[i] = track.value_q22(page_.scale.bend_log2, sign_);
    }
    // Roundings change values on the ramp only, but there by any amount.
    const int32_t others_q22 = leaf.is_nested ? greater(values[1], values[2])
                                              : lesser(values[1], values[2]);
    const int32_t value_q22 = lesser(values[0], others_q22);
    int32_t step = 1;
    if (is_on_ramp(value_q22)) {
      put(combined(page_, leaf, values, place), x);
    } else {
      step = lesser(skipped(value_q22), end - x);
      saturate(x, x + step, value_q22 > 0);
    }
    x += step;
    way += static_cast<uint32_t>(step);
    place.x_q8 += static_cast<uint32_t>(step) << 8;
  }
}

// What the fields of a leaf are from here to the end of the row.
inline Side Cells::side_of(uint32_t i) const noexcept {
  const Track& track = tracks_[i];
  const int32_t value_q22 = track.value_q22(page_.scale.bend_log2, sign_);
  if (value_q22 <= track.outside_q22) {
    return Side::outside;
  }
  return value_q22 >= track.inside_q22 ? Side::inside : Side::edge;
}

// A row of three fields: most of them matter in a part of their cell only.
void Cells::draw_three(const LeafFields& leaf,
                       PixelPlace place,
                       int32_t x,
                       int32_t end) noexcept {
  const Side a = side_of(0);
  if (a == Side::outside) {
    saturate(x, end, false);
    return;
  }
  const Side b = side_of(1);
  const Side c = side_of(2);
  // The one that does not matter, if any.
  uint32_t other = 3;
  if (leaf.is_nested) {
    if (b == Side::outside && c == Side::outside) {
      saturate(x, end, false);
      return;
    }
    if (b == Side::inside || c == Side::inside) {
      if (a == Side::inside) {
        saturate(x, end, true);
      } else {
        draw_single(tracks_[0], x, end);
      }
      return;
    }
    if (b == Side::outside || c == Side::outside) {
      other = b == Side::outside ? 1 : 2;
    }
  } else if (b == Side::outside || c == Side::outside) {
    saturate(x, end, false);
    return;
  } else if (a == Side::inside || b == Side::inside || c == Side::inside) {
    other = a == Side::inside ? 0 : b == Side::inside ? 1 : 2;
  }
  if (other == 3) {
    draw_triple(leaf, place, x, end);
  } else {
    draw_pair(tracks_[other == 0 ? 1 : 0], tracks_[other == 2 ? 1 : 2], place,
              x, end);
  }
}

void Cells::draw_block(LeafFields leaf, const Block& block) noexcept {
  const Side side = set_up_all(leaf, block);
  sign_ = leaf.sign;
  if (side != Side::edge) {
    if ((side == Side::inside) == (sign_ == 0)) {
      fill(block);
    }
    return;
  }
  pixels_per_slope_ = block.right - block.left > 4
                          ? (1u << 24) / static_cast<uint32_t>(slope_q14_)
                          : 0;
  const int32_t x = pixels_.x0 + block.left;
  const int32_t end = pixels_.x0 + block.right;
  PixelPlace place = {x_q8_ + (static_cast<uint32_t>(block.left) << 8),
                      y_q8_ - (static_cast<uint32_t>(block.top) << 8)};
  for (int32_t row = block.top; row < block.bottom; ++row) {
    page_.writer.go_to_row(pixels_.y0 + row);
    if (leaf.count == 1) {
      draw_single(tracks_[0], x, end);
    } else if (leaf.count == 2) {
      draw_pair(tracks_[0], tracks_[1], place, x, end);
    } else {
      draw_three(leaf, place, x, end);
    }
    page_.writer.flush();
    for (uint32_t i = 0; i < leaf.count; ++i) {
      tracks_[i].move_down();
    }
    place.y_q8 -= 1 << 8;
  }
}

void Cells::draw_leaf(uint32_t reference, const Block& cell) noexcept {
  LeafFields leaf;
  leaf.count = 0;
  if (reference >= format::glyph::kFirstNode) {
    read_leaf(page_.field, reference, leaf);
  } else if (reference == format::glyph::kInside) {
    fill(cell);
  }
  if (leaf.count == 0) {
    return;
  }
  Block block = cell;
  for (block.top = cell.top; block.top < cell.bottom;
       block.top = block.bottom) {
    block.bottom = lesser(block.top + kMaxSide, cell.bottom);
    for (block.left = cell.left; block.left < cell.right;
         block.left = block.right) {
      block.right = lesser(block.left + kMaxSide, cell.right);
      draw_block(leaf, block);
    }
  }
}

// Where the children of a node begin; false if it is none.
struct Nodes {
  const GlyphField& field;
  bool is_narrow;

  explicit Nodes(const GlyphField& the_field) noexcept
      : field(the_field),
        is_narrow(the_field.kind == GlyphField::Kind::narrow_fields) {}

  uint32_t tile(uint32_t number) const noexcept {
    if (is_narrow) {
      return field.references[number];
    }
    const LinkedHeap heap(field);
    return heap.holds(number, 1) ? heap.at(number) : format::glyph::kOutside;
  }
  bool is_node(uint32_t reference) const noexcept {
    return is_narrow ? reference - format::glyph::kFirstNode < field.node_count
                     : LinkedHeap(field).is_node(reference);
  }
  uint32_t child(uint32_t node, uint32_t number) const noexcept {
    if (is_narrow) {
      return field
          .references[static_cast<uint32_t>(field.tiles_x) * field.tiles_y +
                      4 * (node - format::glyph::kFirstNode) + number];
    }
    return LinkedHeap(field).at(LinkedHeap::offset(node) + number);
  }
};

// All leaves of a tile that have a pixel, child after child.
void Cells::draw_tile(uint32_t reference, uint32_t x, uint32_t y) noexcept {
  constexpr uint32_t kMaxLog2 = 11;
  const Nodes nodes(page_.field);
  const uint32_t tile_log2 = page_.field.tile_log2;
  uint16_t path[kMaxLog2 + 1];
  uint32_t log2 = tile_log2;
  while (true) {
    Block block;
    // Nodes without a pixel are not entered: work is bounded by pixels.
    if (reference != format::glyph::kOutside && cut(x, y, log2, block)) {
      if (!nodes.is_node(reference)) {
        draw_leaf(reference, block);
      } else if (log2 > 0) {
        path[log2] = static_cast<uint16_t>(reference);
        --log2;
        reference = nodes.child(reference, 0);
        continue;
      }
    }
    // On to the next one: x first, then y, then up.
    while (log2 < tile_log2) {
      const uint32_t size = 1u << log2;
      x ^= size;
      if ((x & size) != 0) {
        break;
      }
      y ^= size;
      if ((y & size) != 0) {
        break;
      }
      ++log2;
    }
    if (log2 >= tile_log2) {
      return;
    }
    reference =
        nodes.child(path[log2 + 1], ((y >> log2) & 1) * 2 + ((x >> log2) & 1));
  }
}

void Cells::draw() noexcept {
  const Nodes nodes(page_.field);
  const uint32_t log2 = page_.field.tile_log2;
  const uint32_t first = static_cast<uint32_t>(left_q16_) >> (16 + log2);
  const uint32_t end =
      (static_cast<uint32_t>(left_q16_ + (columns() - 1) * page_.step_q16) >>
       (16 + log2)) +
      1;
  uint32_t row = static_cast<uint32_t>(top_q16_) >> (16 + log2);
  const uint32_t last =
      static_cast<uint32_t>(top_q16_ - (rows() - 1) * page_.step_q16) >>
      (16 + log2);
  for (;; --row) {
    for (uint32_t column = first; column < end; ++column) {
      draw_tile(nodes.tile(row * page_.field.tiles_x + column), column << log2,
                row << log2);
    }
    if (row == last) {
      return;
    }
  }
}

}  // namespace

void draw_by_cells(FieldPage& page, const Upright& upright) noexcept {
  Cells(page, upright).draw();
}

}  // namespace detail
}  // namespace inkcell
