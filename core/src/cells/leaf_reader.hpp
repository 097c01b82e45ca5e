// From a place in a glyph to the leaf that holds it, on any bytes.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "cells/leaf.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

// Whether a glyph is made of primitives. An empty one may be of any kind.
inline bool has_fields(const GlyphField& field) noexcept {
  return INKCELL_EDGE_CELLS != 0 &&
         (INKCELL_SAMPLE_CELLS == 0 || field.kind != GlyphField::Kind::samples);
}

// Finds the leaf at (x, y), in u from the grid's corner, in the grid. Each step
// down a tree spends one bit of the coordinates, so that loops end; whatever is
// read is read once, as flash may change between check and use.
void find_leaf(const GlyphField& field,
               uint32_t x,
               uint32_t y,
               Leaf& leaf) noexcept;

// Where primitive `number` of an indexed record lies.
inline PrimitiveRef primitive_of(const GlyphField& field,
                                 uint32_t number) noexcept {
  using format::edges::kArcBytes;
  using format::edges::kLineBytes;
  const uint32_t arcs = field.arc_count;
  return number < arcs ? field.cells + kArcBytes * number + 1
                       : field.cells + (kArcBytes - kLineBytes) * arcs +
                             kLineBytes * number;
}

// The units of 2 bytes of a heap, and whether they exist.
class Heap {
 public:
  explicit Heap(const GlyphField& field) noexcept
      : data_(field.cells), units_(field.heap_units) {}

  bool holds(uint32_t unit, uint32_t count) const noexcept {
    return unit + count <= units_;
  }
  // `unit` must exist.
  uint32_t at(uint32_t unit) const noexcept {
    return load_u16(data_ + 2 * unit);
  }
  // Whether all of a node exists. Its tag is the least, so that one comparison
  // tells nodes.
  bool is_node(uint32_t reference, uint32_t& node) const noexcept {
    namespace linked = format::linked;
    node = reference - (linked::kNode << linked::kOffsetBits);
    return node <= linked::kOffsetMask && holds(node, linked::kNodeUnits);
  }
  // Reads what a reference that is no node names: the number of primitives, 0
  // if one of them leaves the heap.
  uint32_t read(uint32_t reference, PrimitiveRef* out, Csg& op) const noexcept;

 private:
  // Null: it leaves the heap.
  PrimitiveRef primitive(uint32_t unit) const noexcept;

  const uint8_t* data_;
  uint32_t units_;
};

// The quadtrees of a glyph of samples.
struct SamplesTree {
  const GlyphField& field;

  uint32_t tile(uint32_t number) const noexcept {
    return load_u16(field.references + 2 * number);
  }
  bool is_node(uint32_t reference) const noexcept {
    return reference - format::glyph::kFirstNode < field.node_count &&
           reference < format::glyph::kCellFlag;
  }
  uint32_t child(uint32_t node, uint32_t number) const noexcept {
    return tile(static_cast<uint32_t>(field.tiles_x) * field.tiles_y +
                4 * (node - format::glyph::kFirstNode) + number);
  }
  // Of a cell; null if the leaf is saturated.
  const uint8_t* samples(uint32_t reference) const noexcept {
    const uint32_t index = reference & ~uint32_t{format::glyph::kCellFlag};
    return reference >= format::glyph::kCellFlag && index < field.cell_count
               ? field.cells + format::samples::kBytes * index
               : nullptr;
  }
};

}  // namespace detail
}  // namespace inkcell
