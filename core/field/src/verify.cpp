#include "inkcell/field/verify.hpp"

#include "inkcell/field/glyph_field.hpp"
#include "inkcell/format/rom.hpp"
#include "tree.hpp"

namespace inkcell {
namespace {

// Every leaf exists, nodes lie in the order in which one meets them (so that
// each has one parent and trees are finite), and none divides a square of 1 u.
bool field_fits(const GlyphField& field) noexcept {
  constexpr uint32_t kFirst = format::glyph::kFirstNode;
  const detail::FieldTree tree = {field};
  uint32_t next = kFirst;  // node
  bool fits = true;
  const auto visit = [&](uint32_t reference,
                         const detail::FieldSquare& square) noexcept {
    if (!tree.is_node(reference)) {
      fits = fits && (reference < kFirst || tree.samples(reference) != nullptr);
      return false;
    }
    fits = fits && reference == next && square.log2 != 0;
    ++next;
    return fits;
  };
  const uint32_t log2 = field.tile_log2;
  for (uint32_t y = 0; y < uint32_t{field.tiles_y} && fits; ++y) {
    for (uint32_t x = 0; x < uint32_t{field.tiles_x} && fits; ++x) {
      walk_tile(tree, {x << log2, y << log2, log2}, visit);
    }
  }
  return fits && next == kFirst + field.node_count;
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
