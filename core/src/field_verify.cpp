#include "field_verify.hpp"

#include "field_cell.hpp"

namespace inkcell {
namespace detail {
namespace {

bool has_fields(const GlyphField& field) noexcept {
  return INKCELL_FIELD_CELLS != 0 && field.kind != GlyphField::Kind::samples;
}

uint32_t field_count(const GlyphField& field) noexcept {
  return uint32_t{field.arc_count} + field.line_count;
}

// What may stand in a leaf's place: single fields, pairs and triples.
uint32_t leaf_count(const GlyphField& field) noexcept {
  return field_count(field) + field.pair_count + field.triple_count;
}

enum class Target : uint8_t { saturated, node, leaf, nothing };

// What reference number `index` names; if it is a node, its number.
Target target_of(const GlyphField& field,
                 uint32_t index,
                 uint32_t& node) noexcept {
  namespace glyph = format::glyph;
  const bool fields = has_fields(field);
  const uint32_t reference = fields
                                 ? Units(field).at(static_cast<int32_t>(index))
                                 : load_u16(field.references + 2 * index);
  if (reference < glyph::kFirstNode) {
    return Target::saturated;
  }
  node = reference - glyph::kFirstNode;
  if (node < field.node_count) {
    return Target::node;
  }
  const bool exists = fields
                          ? node - field.node_count < leaf_count(field)
                          : reference >= glyph::kCellFlag &&
                                reference - glyph::kCellFlag < field.cell_count;
  return exists ? Target::leaf : Target::nothing;
}

// The tree of one tile: every leaf exists, nodes are numbered in the order in
// which one meets them (so that each has one parent and the tree is finite),
// and none divides a square of 1 u. `next_node` is the number that comes next.
bool tile_fits(const GlyphField& field,
               uint32_t tile,
               uint32_t& next_node) noexcept {
  const uint32_t tiles = uint32_t{field.tiles_x} * field.tiles_y;
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
    uint32_t node = 0;
    const Target target = target_of(field, at[level], node);
    ++at[level];
    --left[level];
    if (target == Target::nothing) {
      return false;
    }
    if (target == Target::node) {
      if (node != next_node || level == field.tile_log2) {
        return false;
      }
      ++next_node;
      ++level;
      at[level] = tiles + 4 * node;
      left[level] = 4;
    }
  }
}

// Normals are of unit length within 1/64.
bool normals_fit(const GlyphField& field) noexcept {
  namespace fields = format::fields;
  constexpr uint32_t kShortest = (1 << 14) - (1 << 8);
  constexpr uint32_t kLongest = (1 << 14) + (1 << 8);
  const uint8_t* at = field.cells;
  for (uint32_t i = 0; i < field_count(field); ++i) {
    const int32_t nx = load_i16(at + fields::kNormalX);
    const int32_t ny = load_i16(at + fields::kNormalY);
    const uint32_t square =
        static_cast<uint32_t>(nx * nx) + static_cast<uint32_t>(ny * ny);
    if (square < kShortest * kShortest || square > kLongest * kLongest) {
      return false;
    }
    at += i < field.arc_count ? fields::kArcBytes : fields::kLineBytes;
  }
  return true;
}

bool combinations_fit(const GlyphField& field) noexcept {
  const Units units(field);
  const int32_t triples = 4 * field.triple_count;
  const int32_t all = triples + 2 * field.pair_count;
  for (int32_t i = 0; i < all; ++i) {
    const bool is_operator = i < triples && i % 4 == 0;
    const uint32_t limit = is_operator ? 4 : field_count(field);
    if (units.at(i - all) >= limit) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool field_fits(const GlyphField& field) noexcept {
  if (has_fields(field)) {
    const uint32_t numbers =
        field.kind == GlyphField::Kind::narrow_fields ? 1u << 8 : 1u << 16;
    if (format::glyph::kFirstNode + field.node_count + leaf_count(field) >
            numbers ||
        !normals_fit(field) || !combinations_fit(field)) {
      return false;
    }
  }
  const uint32_t tiles = uint32_t{field.tiles_x} * field.tiles_y;
  uint32_t next_node = 0;
  for (uint32_t tile = 0; tile < tiles; ++tile) {
    if (!tile_fits(field, tile, next_node)) {
      return false;
    }
  }
  return next_node == field.node_count;
}

}  // namespace detail
}  // namespace inkcell
