#include "cells/leaf_reader.hpp"

namespace inkcell {
namespace detail {
namespace {

constexpr auto kLastOperator =
    static_cast<uint32_t>(Csg::union_of_intersection);

uint32_t tile_of(const GlyphField& field, uint32_t x, uint32_t y) noexcept {
  return (y >> field.tile_log2) * uint32_t{field.tiles_x} +
         (x >> field.tile_log2);
}

// Reads a leaf of an indexed record: `number` is that of its reference behind
// those of nodes. Outside, if it names what does not exist.
__attribute__((always_inline)) inline void read_indexed(const GlyphField& field,
                                                        uint32_t number,
                                                        Leaf& leaf) noexcept {
  namespace edges = format::edges;
  const uint32_t primitives = uint32_t{field.arc_count} + field.line_count;
  const uint8_t* const arcs = field.cells + 1;
  const uint32_t arc_count = field.arc_count;
  const uint8_t* const lines =
      field.cells + (edges::kArcBytes - edges::kLineBytes) * arc_count;
  // primitive_of()
  const auto at = [=](uint32_t i) __attribute__((always_inline)) {
    return i < arc_count ? arcs + edges::kArcBytes * i
                         : lines + edges::kLineBytes * i;
  };
  if (number < primitives) {
    leaf.parts[0] = at(number);
    leaf.combine(1, Csg::intersection);
    return;
  }
  number -= primitives;
  // References follow the pairs, pairs the triples.
  const uint8_t* record =
      field.references - edges::kPairUnits * field.pair_count;
  if (number < field.pair_count) {
    record += edges::kPairUnits * number;
    const uint32_t f0 = record[0];
    const uint32_t f1 = record[1];
    if (__builtin_expect(f0 >= primitives || f1 >= primitives, 0)) {
      leaf.saturate(false);
      return;
    }
    leaf.parts[0] = at(f0);
    leaf.parts[1] = at(f1);
    leaf.combine(__builtin_expect(f0 == f1, 0) ? 1 : 2,
                 f0 > f1 ? Csg::union_ : Csg::intersection);
    return;
  }
  // Less than 0, if it is one.
  const auto triple = static_cast<int32_t>(number) -
                      (int32_t{field.pair_count} + field.triple_count);
  if (__builtin_expect(triple >= 0, 0)) {
    leaf.saturate(false);
    return;
  }
  record += static_cast<int32_t>(edges::kTripleUnits) * triple;
  const uint8_t op = record[0];
  const uint32_t f0 = record[1];
  const uint32_t f1 = record[2];
  const uint32_t f2 = record[3];
  if (__builtin_expect(op > kLastOperator || f0 >= primitives ||
                           f1 >= primitives || f2 >= primitives,
                       0)) {
    leaf.saturate(false);
    return;
  }
  leaf.parts[0] = at(f0);
  leaf.parts[1] = at(f1);
  leaf.parts[2] = at(f2);
  leaf.combine(3, static_cast<Csg>(op));
}

// Of a reference that is no node.
bool is_saturated(uint32_t reference, uint32_t log2, Leaf& leaf) noexcept {
  leaf.size_log2 = static_cast<uint8_t>(log2);
  if (__builtin_expect(reference >= format::glyph::kFirstNode, 1)) {
    return false;
  }
  leaf.saturate(reference == format::glyph::kInside);
  return true;
}

}  // namespace

// Not static: their parameters are those of find_leaf() then, which need not be
// moved.
void find_in_heap(const GlyphField& field,
                  uint32_t x,
                  uint32_t y,
                  Leaf& leaf) noexcept;
void find_samples(const GlyphField& field,
                  uint32_t x,
                  uint32_t y,
                  Leaf& leaf) noexcept;

__attribute__((noinline)) void find_in_heap(const GlyphField& field,
                                            uint32_t x,
                                            uint32_t y,
                                            Leaf& leaf) noexcept {
  const Heap heap(field);
  const uint32_t tile = tile_of(field, x, y);
  uint32_t log2 = field.tile_log2;
  uint32_t reference = format::glyph::kOutside;
  if (heap.holds(tile, 1)) {
    reference = heap.at(tile);
    uint32_t node;
    while (heap.is_node(reference, node)) {
      if (log2 == 0) {
        reference = format::glyph::kOutside;
        break;
      }
      --log2;
      reference = heap.at(node + ((y >> log2) & 1) * 2 + ((x >> log2) & 1));
    }
  }
  if (!is_saturated(reference, log2, leaf)) {
    Csg op = Csg::intersection;
    const uint32_t count = heap.read(reference, leaf.parts, op);
    leaf.combine(count, op);
  }
}

__attribute__((noinline)) void find_samples(const GlyphField& field,
                                            uint32_t x,
                                            uint32_t y,
                                            Leaf& leaf) noexcept {
  const SamplesTree tree = {field};
  uint32_t log2 = field.tile_log2;
  uint32_t reference = tree.tile(tile_of(field, x, y));
  const uint8_t* const nodes =
      field.references +
      2 * (static_cast<uint32_t>(field.tiles_x) * field.tiles_y);
  // SamplesTree::child()
  while (tree.is_node(reference) && log2 != 0) {
    --log2;
    const uint32_t child = ((y >> log2) & 1) * 2 + ((x >> log2) & 1);
    reference = load_u16(
        nodes + 2 * (4 * (reference - format::glyph::kFirstNode) + child));
  }
  leaf.size_log2 = static_cast<uint8_t>(log2);
  leaf.saturate(reference == format::glyph::kInside);
  const uint8_t* const samples = tree.samples(reference);
  if (samples != nullptr) {
    leaf.parts[0] = samples;
    leaf.count = Leaf::kSamples;
    leaf.sign = 0;
  }
}

// Not inline: the compiler has registers for this or for the loops that draw,
// not for both.
__attribute__((noinline)) void find_leaf(const GlyphField& field,
                                         uint32_t x,
                                         uint32_t y,
                                         Leaf& leaf) noexcept {
  if constexpr (!kHasPrimitives) {
    find_samples(field, x, y, leaf);
    return;
  }
  if (__builtin_expect(field.kind != GlyphField::Kind::narrow_fields, 0)) {
    if (has_fields(field)) {
      find_in_heap(field, x, y, leaf);
    } else {
      find_samples(field, x, y, leaf);
    }
    return;
  }
  const uint8_t* const nodes =
      field.references + static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  uint32_t reference = field.references[tile_of(field, x, y)];
  int32_t log2 = field.tile_log2;
  uint32_t node = reference - format::glyph::kFirstNode;
  while (node < field.node_count) {
    if (--log2 < 0) {
      leaf.size_log2 = 0;
      leaf.saturate(false);
      return;
    }
    const uint8_t* const row = nodes + 4 * node + ((y >> log2) & 1) * 2;
    reference = row[(x >> log2) & 1];
    node = reference - format::glyph::kFirstNode;
  }
  if (!is_saturated(reference, static_cast<uint32_t>(log2), leaf)) {
    read_indexed(field, node - field.node_count, leaf);
  }
}

PrimitiveRef Heap::primitive(uint32_t unit) const noexcept {
  namespace linked = format::linked;
  const uint32_t offset = unit & linked::kOffsetMask;
  const bool is_arc = (unit & linked::kArcField) != 0;
  return holds(offset, is_arc ? linked::kArcUnits : linked::kLineUnits)
             ? data_ + 2 * offset + (is_arc ? 1 : 0)
             : nullptr;
}

uint32_t Heap::read(uint32_t reference,
                    PrimitiveRef* out,
                    Csg& op) const noexcept {
  namespace linked = format::linked;
  const uint32_t kind = reference >> linked::kOffsetBits;
  uint32_t from = reference & linked::kOffsetMask;
  op = Csg::intersection;
  if (kind == linked::kLine || kind == linked::kArc) {
    out[0] = primitive(kind == linked::kArc ? from | linked::kArcField : from);
    return out[0] != nullptr ? 1 : 0;
  }
  uint32_t count = 2;
  if (kind == linked::kTriple) {
    if (!holds(from, linked::kTripleUnits)) {
      return 0;
    }
    const uint32_t number = at(from++);
    if (number > kLastOperator) {
      return 0;
    }
    op = static_cast<Csg>(number);
    count = 3;
  } else if ((kind != linked::kMinPair && kind != linked::kMaxPair) ||
             !holds(from, linked::kPairUnits)) {
    return 0;
  }
  for (uint32_t i = 0; i < count; ++i) {
    out[i] = primitive(at(from + i));
    if (out[i] == nullptr) {
      return 0;
    }
  }
  if (count == 2 && out[0] == out[1]) {
    return 1;  // a pair of one primitive is that primitive
  }
  if (kind == linked::kMaxPair) {
    op = Csg::union_;
  }
  return count;
}

}  // namespace detail
}  // namespace inkcell
