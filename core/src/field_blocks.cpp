// Cells of fields in object order: every cell once, tile by tile.
#include "field_block.hpp"

#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

// Draws the leaves of a glyph.
class Cells {
 public:
  Cells(FieldPage& page, const Upright& upright) noexcept
      : page_(page),
        pixels_(upright.pixels),
        left_q16_(upright.at.x_q16 - page.field.x0_u * (1 << 16)),
        top_q16_(upright.at.y_q16 - page.field.y0_u * (1 << 16)),
        painter_(page,
                 upright.pixels,
                 {q8_of(upright.at.x_q20), q8_of(upright.at.y_q20)}) {}

  void draw() noexcept;

 private:
  int32_t columns() const noexcept { return pixels_.x1 - pixels_.x0; }
  int32_t rows() const noexcept { return pixels_.y1 - pixels_.y0; }
  int32_t pixels_before(int32_t way_q16, int32_t most) const noexcept;
  bool cut(uint32_t x, uint32_t y, uint32_t log2, Block& out) const noexcept;
  void draw_tile(uint32_t reference, uint32_t x, uint32_t y) noexcept;
  void draw_leaf(uint32_t reference, const Block& cell) noexcept;

  FieldPage& page_;
  const Rect& pixels_;
  int32_t left_q16_;  // the first pixel, from the grid's corner
  int32_t top_q16_;
  BlockPainter painter_;
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

__attribute__((noinline)) void Cells::draw_leaf(uint32_t reference,
                                                const Block& cell) noexcept {
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
  for (block.top = cell.top; block.top < cell.bottom;
       block.top = block.bottom) {
    block.bottom = lesser(block.top + kMaxBlockSide, cell.bottom);
    for (block.left = cell.left; block.left < cell.right;
         block.left = block.right) {
      block.right = lesser(block.left + kMaxBlockSide, cell.right);
      painter_.draw(leaf, block);
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
__attribute__((noinline)) void Cells::draw_tile(uint32_t reference,
                                                uint32_t x,
                                                uint32_t y) noexcept {
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
