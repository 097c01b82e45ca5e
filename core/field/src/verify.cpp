#include "inkcell/field/verify.hpp"

#include "inkcell/field/glyph_field.hpp"
#include "inkcell/format/rom.hpp"
#include "tree.hpp"

namespace inkcell {
namespace {

// The tree of one tile: every leaf exists, nodes lie in the order in which one
// meets them (so that each has one parent and the tree is finite), and none
// divides a square of 1 u. `next`: the number of the next node.
bool tile_fits(const detail::FieldTree& tree,
               uint32_t tile,
               uint32_t& next) noexcept {
  namespace glyph = format::glyph;
  // References still to visit at each level: where, and how many.
  uint32_t at[glyph::kMaxTileLog2 + 1];
  uint8_t left[glyph::kMaxTileLog2 + 1];
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
    const uint32_t reference = tree.reference(at[level]);
    ++at[level];
    --left[level];
    if (tree.is_node(reference)) {
      if (reference != glyph::kFirstNode + next ||
          level == tree.field.tile_log2) {
        return false;
      }
      ++level;
      at[level] = tree.tile_count() + 4 * next;
      left[level] = 4;
      ++next;
    } else if (reference >= glyph::kFirstNode &&
               tree.samples(reference) == nullptr) {
      return false;
    }
  }
}

bool field_fits(const GlyphField& field) noexcept {
  const detail::FieldTree tree = {field};
  uint32_t next = 0;
  for (uint32_t tile = 0; tile < tree.tile_count(); ++tile) {
    if (!tile_fits(tree, tile, next)) {
      return false;
    }
  }
  return next == field.node_count;
}

}  // namespace

Status verify_fields(const Font& font) noexcept {
  INKCELL_TRY(font.verify());
  if (font.has_outlines()) {
    return Status::ok;
  }
  for (uint32_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    GlyphField field;
    INKCELL_TRY(read_field(font, static_cast<uint16_t>(glyph), field));
    if (!field_fits(field)) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
