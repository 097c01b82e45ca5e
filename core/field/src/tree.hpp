// The quadtrees of a glyph: from a place to the leaf that holds it.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {

// A leaf of a quadtree: nine samples, or saturated on one side.
struct FieldLeaf {
  const uint8_t* samples;  // null: saturated
  uint8_t size_log2;       // 2^size_log2 u wide
  bool is_inside;          // the side of a saturated leaf
};

// References of a glyph's tiles and nodes. Any bytes are safe: indices are
// compared with the counts, and each is read once, because flash may change
// between check and use.
struct FieldTree {
  const GlyphField& field;

  uint32_t tile_count() const noexcept {
    return static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  }
  uint32_t reference(uint32_t number) const noexcept {
    return load_u16(field.references + 2 * number);
  }
  uint32_t tile_at(uint32_t x_u, uint32_t y_u) const noexcept {
    return reference((y_u >> field.tile_log2) * uint32_t{field.tiles_x} +
                     (x_u >> field.tile_log2));
  }
  bool is_node(uint32_t reference) const noexcept {
    return reference - format::glyph::kFirstNode < field.node_count &&
           reference < format::glyph::kCellFlag;
  }
  // Child `number`, 2 * upper + right, of a node.
  uint32_t child(uint32_t node, uint32_t number) const noexcept {
    return reference(tile_count() + 4 * (node - format::glyph::kFirstNode) +
                     number);
  }
  // The samples of a leaf; null: it is saturated.
  const uint8_t* samples(uint32_t reference) const noexcept {
    const uint32_t index = reference & ~uint32_t{format::glyph::kCellFlag};
    return reference >= format::glyph::kCellFlag && index < field.cell_count
               ? field.cells + format::samples::kBytes * index
               : nullptr;
  }
  // Finds the leaf at (x_u, y_u), which are relative to the grid's corner and
  // in the grid. The bits of the coordinates choose the children, from the
  // highest bit down, so that the loop ends and compares no coordinates.
  __attribute__((always_inline)) FieldLeaf find(uint32_t x_u,
                                                uint32_t y_u) const noexcept {
    uint32_t log2 = field.tile_log2;
    uint32_t at = tile_at(x_u, y_u);
    const uint8_t* const nodes = field.references + 2 * tile_count();
    while (is_node(at) && log2 != 0) {
      --log2;
      at = load_u16(nodes + 8 * (at - format::glyph::kFirstNode) +
                    ((y_u >> log2) & 1) * 4 + ((x_u >> log2) & 1) * 2);
    }
    return {samples(at), static_cast<uint8_t>(log2),
            at == format::glyph::kInside};
  }
};

// A square of a quadtree, from the grid's corner. [u]
struct FieldSquare {
  uint32_t x;
  uint32_t y;
  uint32_t log2;
};

// Visits the squares of a tile, which `at` is, each before its children and
// these in their order. `visit(reference, square)`: whether its children are to
// be visited, which only a node of more than 1 u may ask for.
template <typename Visit>
void walk_tile(const FieldTree& tree, FieldSquare at, Visit visit) noexcept {
  const uint32_t tile_log2 = at.log2;
  uint32_t reference = tree.tile_at(at.x, at.y);
  uint16_t path[format::glyph::kMaxTileLog2 + 1];
  while (true) {
    if (visit(reference, at)) {
      path[at.log2] = static_cast<uint16_t>(reference);
      --at.log2;
      reference = tree.child(reference, 0);
      continue;
    }
    // On to the next one: x first, then y, then up.
    for (; at.log2 < tile_log2; ++at.log2) {
      const uint32_t size = 1u << at.log2;
      at.x ^= size;
      if ((at.x & size) != 0) {
        break;
      }
      at.y ^= size;
      if ((at.y & size) != 0) {
        break;
      }
    }
    if (at.log2 >= tile_log2) {
      return;
    }
    reference = tree.child(path[at.log2 + 1],
                           (at.y >> at.log2 & 1) * 2 + (at.x >> at.log2 & 1));
  }
}

// Whether a place, relative to the grid's corner, lies in the grid.
inline bool is_in_field(const GlyphField& field,
                        uint32_t x_u,
                        uint32_t y_u) noexcept {
  return x_u < uint32_t{field.tiles_x} << field.tile_log2 &&
         y_u < uint32_t{field.tiles_y} << field.tile_log2;
}

}  // namespace inkcell::detail
