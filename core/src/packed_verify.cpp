// Font::verify for packed glyphs: what they expand to makes sense, and fits.
#include "field_verify.hpp"
#include "inkcell/font.hpp"
#include "inkcell/packed.hpp"
#include "packed_rows.hpp"

namespace inkcell {
namespace {

// A workspace that is too small for a glyph was stated wrongly by the font.
Status expand_stated(const PackedGlyph& glyph,
                     uint32_t first_row,
                     uint32_t row_count,
                     Workspace workspace,
                     detail::SharedFields& shared,
                     GlyphField& out) noexcept {
  const Status status =
      detail::expand_rows(glyph, first_row, row_count, workspace, shared, out);
  return status == Status::buffer_small ? Status::corrupt : status;
}

}  // namespace

Status Font::verify(Workspace workspace) const noexcept {
  INKCELL_TRY(verify());
  if (!is_packed()) {
    return Status::ok;
  }
  const Workspace whole = {workspace.data, workspace_bytes()};
  const Workspace one_row = {workspace.data, row_workspace_bytes()};
  if (workspace.size < whole.size) {
    return Status::buffer_small;
  }
  if (one_row.size > whole.size) {
    return Status::corrupt;
  }
  for (uint32_t i = 0; i < glyph_count(); ++i) {
    const auto id = static_cast<uint16_t>(i);
    GlyphField expanded;
    if (field(id, expanded) == Status::ok) {
      continue;  // read in place, and verified above
    }
    PackedGlyph glyph;
    INKCELL_TRY(PackedGlyph::open(*this, id, glyph));
    detail::SharedFields shared;
    for (uint32_t row = 0; row < glyph.tiles_y; ++row) {
      INKCELL_TRY(expand_stated(glyph, row, 1, one_row, shared, expanded));
    }
    INKCELL_TRY(
        expand_stated(glyph, 0, glyph.tiles_y, whole, shared, expanded));
    if (!detail::field_fits(expanded)) {
      return Status::corrupt;
    }
  }
  return Status::ok;
}

}  // namespace inkcell
