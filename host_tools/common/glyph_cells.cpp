#include "glyph_cells.hpp"

#include <algorithm>

#include "inkcell/format.hpp"

namespace inkcell::tools {
namespace {

constexpr uint32_t kMostBytes = 2 * format::linked::kMaxUnits;

}  // namespace

FontWorkspace::FontWorkspace(const Font& font)
    : bytes_(std::min(font.workspace_bytes(), kMostBytes)) {}

GlyphCells::GlyphCells(const Font& font, uint16_t glyph) {
  if (!font.is_packed()) {
    static_cast<void>(font.field(glyph, field_));
    return;
  }
  PackedGlyph packed;
  if (PackedGlyph::open(font, glyph, packed) != Status::ok ||
      packed.tiles_y == 0) {
    return;
  }
  bytes_.resize(kMostBytes);
  if (expand(packed, 0, packed.tiles_y, {bytes_.data(), bytes_.size()},
             field_) != Status::ok) {
    bytes_.clear();
    return;
  }
  // Smaller: the bytes stay where they are.
  bytes_.resize(size_t{2} * field_.heap_units);
}

}  // namespace inkcell::tools
