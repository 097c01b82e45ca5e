#include "verify/field_verify.hpp"

#include "base/bytes.hpp"
#include "cells/leaf_reader.hpp"

namespace inkcell {
namespace detail {
namespace {

uint32_t field_count(const GlyphField& field) noexcept {
  return uint32_t{field.arc_count} + field.line_count;
}

// What may stand in a leaf's place: single fields, pairs and triples.
uint32_t leaf_count(const GlyphField& field) noexcept {
  return field_count(field) + field.pair_count + field.triple_count;
}

// Whether the field that begins at `at` has a normal of unit length within
// 1/64.
bool normal_fits(const uint8_t* at) noexcept {
  namespace edges = format::edges;
  constexpr uint32_t kShortest = (1 << 14) - (1 << 8);
  constexpr uint32_t kLongest = (1 << 14) + (1 << 8);
  const int32_t nx = load_i16(at + edges::kNormalX);
  const int32_t ny = load_i16(at + edges::kNormalY);
  const uint32_t square =
      static_cast<uint32_t>(nx * nx) + static_cast<uint32_t>(ny * ny);
  return square >= kShortest * kShortest && square <= kLongest * kLongest;
}

bool normals_fit(const GlyphField& field) noexcept {
  for (uint32_t i = 0; i < field_count(field); ++i) {
    if (!normal_fits(record_of(primitive_of(field, i)))) {
      return false;
    }
  }
  return true;
}

bool combinations_fit(const GlyphField& field) noexcept {
  const uint32_t triples = 4u * field.triple_count;
  const uint32_t all = triples + 2u * field.pair_count;
  const uint8_t* at = field.references - all;
  for (uint32_t i = 0; i < all; ++i) {
    const bool is_operator = i < triples && i % 4 == 0;
    if (at[i] >= (is_operator ? 4 : field_count(field))) {
      return false;
    }
  }
  return true;
}

enum class Target : uint8_t { saturated, node, leaf, nothing };

// What is at the end of a reference; if it is a node, its number, or where it
// lies in a heap.
Target target_of(const GlyphField& field,
                 uint32_t reference,
                 uint32_t& node) noexcept {
  namespace glyph = format::glyph;
  if (reference < glyph::kFirstNode) {
    return Target::saturated;
  }
  if (field.kind == GlyphField::Kind::linked_fields) {
    const Heap heap(field);
    if (heap.is_node(reference, node)) {
      return Target::node;
    }
    PrimitiveRef parts[3];
    Csg op;
    const uint32_t count = heap.read(reference, parts, op);
    for (uint32_t i = 0; i < count; ++i) {
      if (!normal_fits(record_of(parts[i]))) {
        return Target::nothing;
      }
    }
    return count == 0 ? Target::nothing : Target::leaf;
  }
  node = reference - glyph::kFirstNode;
  if (node < field.node_count) {
    return Target::node;
  }
  const bool exists = has_fields(field)
                          ? node - field.node_count < leaf_count(field)
                          : reference >= glyph::kCellFlag &&
                                reference - glyph::kCellFlag < field.cell_count;
  return exists ? Target::leaf : Target::nothing;
}

// Where the nodes are that one has met, and where the next one must be.
class NodeOrder {
 public:
  explicit NodeOrder(const GlyphField& field) noexcept
      : is_linked_(field.kind == GlyphField::Kind::linked_fields),
        tiles_(uint32_t{field.tiles_x} * field.tiles_y),
        next_(is_linked_ ? tiles_ : 0) {}

  bool meet(uint32_t node) noexcept {
    const bool fits = is_linked_ ? node >= next_ : node == next_;
    next_ = node + (is_linked_ ? format::linked::kNodeUnits : 1);
    return fits;
  }
  // The index of the node's first reference.
  uint32_t children(uint32_t node) const noexcept {
    return is_linked_ ? node : tiles_ + 4 * node;
  }
  uint32_t tiles() const noexcept { return tiles_; }
  bool is_complete(const GlyphField& field) const noexcept {
    return is_linked_ || next_ == field.node_count;
  }

 private:
  bool is_linked_;
  uint32_t tiles_;
  uint32_t next_;
};

// The tree of one tile: every leaf exists, nodes lie in the order in which one
// meets them (so that each has one parent and the tree is finite), and none
// divides a square of 1 u.
bool tile_fits(const GlyphField& field,
               uint32_t tile,
               NodeOrder& order) noexcept {
  // References still to visit at each level: where, and how many.
  uint32_t at[format::glyph::kMaxTileLog2 + 1];
  uint8_t left[format::glyph::kMaxTileLog2 + 1];
  uint32_t level = 0;
  at[0] = tile;
  left[0] = 1;
  while (true) {
    if (left[level] == 0) {
      if (level == 0) {
        return true;
      }
      --level;
      continue;
    }
    const uint32_t reference = field.kind == GlyphField::Kind::narrow_fields
                                   ? field.references[at[level]]
                                   : load_u16(field.references + 2 * at[level]);
    uint32_t node = 0;
    const Target target = target_of(field, reference, node);
    ++at[level];
    --left[level];
    if (target == Target::nothing) {
      return false;
    }
    if (target == Target::node) {
      if (!order.meet(node) || level == field.tile_log2) {
        return false;
      }
      ++level;
      at[level] = order.children(node);
      left[level] = 4;
    }
  }
}

}  // namespace

bool field_fits(const GlyphField& field) noexcept {
  if (has_fields(field) && field.kind == GlyphField::Kind::narrow_fields) {
    // One byte says this many things.
    constexpr uint32_t kNumbers = 1 << 8;
    if (format::glyph::kFirstNode + field.node_count + leaf_count(field) >
            kNumbers ||
        !normals_fit(field) || !combinations_fit(field)) {
      return false;
    }
  }
  NodeOrder order(field);
  for (uint32_t tile = 0; tile < order.tiles(); ++tile) {
    if (!tile_fits(field, tile, order)) {
      return false;
    }
  }
  return order.is_complete(field);
}

}  // namespace detail
}  // namespace inkcell
