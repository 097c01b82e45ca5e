// Cells of fields in object order: every cell once, tile by tile.
#include "field_block.hpp"

#include "field_draw.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

// What a leaf names: no fields, if one does not exist.
inline LeafFields read_leaf(const GlyphField& field,
                            uint32_t reference) noexcept {
  LeafFields leaf;
  const bool is_narrow = field.kind == GlyphField::Kind::narrow_fields;
  leaf.count = static_cast<uint8_t>(
      is_narrow ? read_narrow_leaf(field, reference, leaf.units, leaf.op)
                : read_linked_leaf(field, reference, leaf.units, leaf.op));
  return leaf;
}

// The quadtrees of a glyph.
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

// The leaves of a glyph.
class Cells {
 public:
  Cells(const GlyphField& field, const Brush& brush, const Sink& sink) noexcept
      : painter_(field, brush, sink), step_q16_(brush.step_along_q16()) {}

  void place(const Brush& brush, const Placed& placed) noexcept;

  void draw() noexcept;

 private:
  int32_t pixels_before(int32_t way_q16, int32_t most) const noexcept;
  int32_t column_at(uint32_t x, int32_t end) const noexcept;
  int32_t row_below(uint32_t y, int32_t end) const noexcept;
  void draw_tile(const Nodes& nodes,
                 uint32_t reference,
                 uint32_t x,
                 uint32_t y,
                 Rect& block) noexcept;
  void draw_leaf(uint32_t reference, const Rect& cell) noexcept;

  BlockPainter painter_;
  int32_t step_q16_;
  int32_t left_q16_ = 0;  // the first pixel, from the grid's corner
  int32_t top_q16_ = 0;
  int16_t x0_ = 0;  // its pixels on the screen
  int16_t y0_ = 0;
  int16_t x1_ = 0;
  int16_t y1_ = 0;
};

// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) void Cells::place(const Brush& brush,
                                            const Placed& placed) noexcept {
  const GlyphField& field = painter_.field();
  const Upright upright =
      place_upright(field, brush, placed, painter_.sink().window);
  const FieldPosition& at = upright.at;
  const Rect& pixels = upright.pixels;
  if (is_empty(pixels)) {
    return;  // and `at` is nowhere
  }
  x0_ = static_cast<int16_t>(pixels.x0);
  y0_ = static_cast<int16_t>(pixels.y0);
  x1_ = static_cast<int16_t>(pixels.x1);
  y1_ = static_cast<int16_t>(pixels.y1);
  left_q16_ = at.x_q16 - field.x0_u * (1 << 16);
  top_q16_ = at.y_q16 - field.y0_u * (1 << 16);
  painter_.set_origin(
      {q8_of(at.x_q20) - (static_cast<uint32_t>(pixels.x0) << 8),
       q8_of(at.y_q20) + (static_cast<uint32_t>(pixels.y0) << 8)});
}

// How many pixels lie before a place `way_q16` further on, the first of them at
// 0; `most` at the most. [u]
__attribute__((noinline)) int32_t Cells::pixels_before(
    int32_t way_q16, int32_t most) const noexcept {
  if (way_q16 <= 0) {
    return 0;
  }
  // A guess from a px being 65536 u / size: right, or up to two too low.
  const uint32_t size_q6 = painter_.size_q8() >> 2;
  auto count = static_cast<int32_t>(
      ((static_cast<uint32_t>(way_q16) >> 13) * size_q6) >> 19);
  if (count >= most) {
    return most;
  }
  int32_t left = way_q16 - count * step_q16_;
  if (left > 0) {
    ++count;
    left -= step_q16_;
  }
  if (left > 0) {
    ++count;
  }
  return lesser(count, most);
}

// The first column whose centre is not to the left of a place in the grid, and
// the first row below one; `end` at the most.
inline int32_t Cells::column_at(uint32_t x, int32_t end) const noexcept {
  return x0_ +
         pixels_before(static_cast<int32_t>(x << 16) - left_q16_, end - x0_);
}
inline int32_t Cells::row_below(uint32_t y, int32_t end) const noexcept {
  return y0_ +
         pixels_before(top_q16_ + 1 - static_cast<int32_t>(y << 16), end - y0_);
}

inline void Cells::draw_leaf(uint32_t reference, const Rect& cell) noexcept {
  if (reference < format::glyph::kFirstNode) {
    painter_.fill(cell);
    return;
  }
  const LeafFields leaf = read_leaf(painter_.field(), reference);
  if (leaf.count == 0) {
    return;
  }
  Rect block = cell;
  for (; block.y0 < cell.y1; block.y0 = block.y1) {
    block.y1 = lesser(block.y0 + kMaxBlockSide, cell.y1);
    for (block.x0 = cell.x0; block.x0 < cell.x1; block.x0 = block.x1) {
      block.x1 = lesser(block.x0 + kMaxBlockSide, cell.x1);
      painter_.draw(leaf, block);
    }
  }
}

// All leaves of a tile that have a pixel, child after child: to the right, then
// up. `block` is the tile's, and at the end again.
inline void Cells::draw_tile(const Nodes& nodes,
                             uint32_t reference,
                             uint32_t x,
                             uint32_t y,
                             Rect& block) noexcept {
  // A node on the way to a square, and its borders that are not the square's.
  struct Level {
    uint16_t node;
    int16_t x;
    int16_t y;
  };
  Level path[format::glyph::kMaxTileLog2];
  const uint32_t tile_log2 = nodes.field.tile_log2;
  uint32_t log2 = tile_log2;
  while (true) {
    // Nodes without a pixel are not entered: work is bounded by pixels.
    if (reference != format::glyph::kOutside && block.x0 < block.x1 &&
        block.y0 < block.y1) {
      if (!nodes.is_node(reference)) {
        draw_leaf(reference, block);
      } else if (log2 > 0) {
        --log2;
        const uint32_t size = 1u << log2;
        path[log2] = {static_cast<uint16_t>(reference),
                      static_cast<int16_t>(block.x1),
                      static_cast<int16_t>(block.y0)};
        block.x1 = greater(column_at(x + size, block.x1), block.x0);
        block.y0 = greater(row_below(y + size, block.y1), block.y0);
        reference = nodes.child(reference, 0);
        continue;
      }
    }
    // On to the next one: x first, then y, then up.
    while (true) {
      if (log2 == tile_log2) {
        return;
      }
      const uint32_t size = 1u << log2;
      Level& level = path[log2];
      const int32_t other_x = level.x;
      const int32_t other_y = level.y;
      x ^= size;
      if ((x & size) != 0) {
        level.x = static_cast<int16_t>(block.x0);
        block.x0 = block.x1;
        block.x1 = other_x;
        break;
      }
      y ^= size;
      if ((y & size) != 0) {
        level.x = static_cast<int16_t>(block.x1);
        block.x1 = block.x0;
        block.x0 = other_x;
        level.y = static_cast<int16_t>(block.y1);
        block.y1 = block.y0;
        block.y0 = other_y;
        break;
      }
      block.x0 = other_x;
      block.y1 = other_y;
      ++log2;
    }
    reference =
        nodes.child(path[log2].node, ((y >> log2) & 1) * 2 + ((x >> log2) & 1));
  }
}

// Not inline: the painter has a frame on the stack for itself.
__attribute__((noinline)) void Cells::draw() noexcept {
  const Nodes nodes(painter_.field());
  const uint32_t log2 = nodes.field.tile_log2;
  const uint32_t first = static_cast<uint32_t>(left_q16_) >> (16 + log2);
  uint32_t row = static_cast<uint32_t>(top_q16_) >> (16 + log2);
  Rect tile;
  for (tile.y0 = y0_; tile.y0 < y1_; tile.y0 = tile.y1, --row) {
    tile.y1 = row_below(row << log2, y1_);
    uint32_t column = first;
    for (tile.x0 = x0_; tile.x0 < x1_; tile.x0 = tile.x1, ++column) {
      tile.x1 = column_at((column + 1) << log2, x1_);
      draw_tile(nodes, nodes.tile(row * nodes.field.tiles_x + column),
                column << log2, row << log2, tile);
    }
  }
}

}  // namespace

void draw_by_cells(const GlyphField& field,
                   const Brush& brush,
                   const Placed& placed,
                   const Sink& sink) noexcept {
  Cells cells(field, brush, sink);
  cells.place(brush, placed);
  cells.draw();
}

}  // namespace detail
}  // namespace inkcell
