// Cells of fields in object order: every cell once, tile by tile.
#include "field_block.hpp"

#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

// Draws the leaves of a glyph.
class Cells {
 public:
  Cells(const FieldPage& page,
        const Upright& upright,
        BlockPainter& painter) noexcept
      : page_(page),
        pixels_(upright.pixels),
        left_q16_(upright.at.x_q16 - page.field.x0_u * (1 << 16)),
        top_q16_(upright.at.y_q16 - page.field.y0_u * (1 << 16)),
        painter_(painter) {}

  void draw() noexcept;

 private:
  int32_t columns() const noexcept { return pixels_.x1 - pixels_.x0; }
  int32_t rows() const noexcept { return pixels_.y1 - pixels_.y0; }
  int32_t pixels_before(int32_t way_q16, int32_t most) const noexcept;
  int32_t columns_before(uint32_t x, int32_t most) const noexcept;
  int32_t rows_before(uint32_t y, int32_t most) const noexcept;
  void draw_tile(uint32_t reference,
                 uint32_t x,
                 uint32_t y,
                 Block block) noexcept;
  void draw_leaf(uint32_t reference, const Block& cell) noexcept;

  const FieldPage& page_;
  const Rect& pixels_;
  int32_t left_q16_;  // the first pixel, from the grid's corner
  int32_t top_q16_;
  BlockPainter& painter_;
};

// How many pixels lie before a place `way_q16` further on, the first of them at
// 0; `most` at the most. [u]
int32_t Cells::pixels_before(int32_t way_q16, int32_t most) const noexcept {
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

// Columns whose centres lie to the left of a place in the grid, and rows of
// those that do not lie below one.
inline int32_t Cells::columns_before(uint32_t x, int32_t most) const noexcept {
  return pixels_before(static_cast<int32_t>(x << 16) - left_q16_, most);
}
inline int32_t Cells::rows_before(uint32_t y, int32_t most) const noexcept {
  return pixels_before(top_q16_ + 1 - static_cast<int32_t>(y << 16), most);
}

inline void Cells::draw_leaf(uint32_t reference, const Block& cell) noexcept {
  LeafFields leaf;
  leaf.count = 0;
  if (reference >= format::glyph::kFirstNode) {
    if (page_.field.kind == GlyphField::Kind::narrow_fields) {
      read_leaf<true>(page_.field, reference, leaf);
    } else {
      read_leaf<false>(page_.field, reference, leaf);
    }
  } else if (reference == format::glyph::kInside) {
    painter_.fill(cell);
  }
  if (leaf.count == 0) {
    return;
  }
  Block block = cell;
  for (; block.top < cell.bottom; block.top = block.bottom) {
    block.bottom = lesser(block.top + kMaxBlockSide, cell.bottom);
    for (block.left = cell.left; block.left < cell.right;
         block.left = block.right) {
      block.right = lesser(block.left + kMaxBlockSide, cell.right);
      LeafFields fields = leaf;
      while (!painter_.draw(fields, block)) {
        fields = leaf;
      }
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

// All leaves of a tile that have a pixel, child after child: to the right, then
// up. `block` is the tile's.
__attribute__((noinline)) void Cells::draw_tile(uint32_t reference,
                                                uint32_t x,
                                                uint32_t y,
                                                Block block) noexcept {
  // A node on the way to a square, and its borders that are not the square's.
  struct Level {
    uint16_t node;
    int16_t x;
    int16_t y;
  };
  Level path[format::glyph::kMaxTileLog2 + 1];
  const Nodes nodes(page_.field);
  const uint32_t tile_log2 = page_.field.tile_log2;
  uint32_t log2 = tile_log2;
  while (true) {
    // Nodes without a pixel are not entered: work is bounded by pixels.
    if (reference != format::glyph::kOutside && block.left < block.right &&
        block.top < block.bottom) {
      if (!nodes.is_node(reference)) {
        draw_leaf(reference, block);
      } else if (log2 > 0) {
        --log2;
        const uint32_t size = 1u << log2;
        path[log2] = {static_cast<uint16_t>(reference),
                      static_cast<int16_t>(block.right),
                      static_cast<int16_t>(block.top)};
        block.right =
            greater(columns_before(x + size, block.right), block.left);
        block.top = greater(rows_before(y + size, block.bottom), block.top);
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
        level.x = static_cast<int16_t>(block.left);
        block.left = block.right;
        block.right = other_x;
        break;
      }
      y ^= size;
      if ((y & size) != 0) {
        level.x = static_cast<int16_t>(block.right);
        block.right = block.left;
        block.left = other_x;
        level.y = static_cast<int16_t>(block.bottom);
        block.bottom = block.top;
        block.top = other_y;
        break;
      }
      block.left = other_x;
      block.bottom = other_y;
      ++log2;
    }
    reference =
        nodes.child(path[log2].node, ((y >> log2) & 1) * 2 + ((x >> log2) & 1));
  }
}

void Cells::draw() noexcept {
  const Nodes nodes(page_.field);
  const uint32_t log2 = page_.field.tile_log2;
  const uint32_t first = static_cast<uint32_t>(left_q16_) >> (16 + log2);
  uint32_t row = static_cast<uint32_t>(top_q16_) >> (16 + log2);
  Block block;
  for (block.top = 0; block.top < rows(); block.top = block.bottom, --row) {
    block.bottom = rows_before(row << log2, rows());
    uint32_t column = first;
    for (block.left = 0; block.left < columns(); block.left = block.right) {
      const uint32_t x = column << log2;
      const uint32_t tile = row * page_.field.tiles_x + column;
      ++column;
      block.right = columns_before(column << log2, columns());
      draw_tile(nodes.tile(tile), x, row << log2, block);
    }
  }
}

// The painter has a frame on the stack for itself.
__attribute__((noinline)) void draw_cells(const FieldPage& page,
                                          const Upright& upright,
                                          BlockPainter& painter) noexcept {
  Cells(page, upright, painter).draw();
}

}  // namespace

void draw_by_cells(const FieldPage& page,
                   const Upright& upright,
                   const Sink& sink) noexcept {
  BlockPainter painter(page, sink, upright.pixels,
                       {q8_of(upright.at.x_q20), q8_of(upright.at.y_q20)});
  draw_cells(page, upright, painter);
}

}  // namespace detail
}  // namespace inkcell
