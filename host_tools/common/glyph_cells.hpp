// The cells of one glyph, whatever the coding of its font.
#pragma once

#include <cstdint>
#include <vector>

#include "inkcell/font.hpp"
#include "inkcell/packed.hpp"

namespace inkcell::tools {

/// RAM in which any glyph of the font can be expanded: none if it is direct.
/// No more than a glyph can take, whatever the font states.
class FontWorkspace {
 public:
  explicit FontWorkspace(const Font& font);

  operator Workspace() { return {bytes_.data(), bytes_.size()}; }

 private:
  std::vector<uint8_t> bytes_;  // from new: aligned to more than 2
};

/// A glyph's field, and the bytes that it was expanded into, if any.
class GlyphCells {
 public:
  /// Of a glyph that cannot be read the field is empty.
  GlyphCells(const Font& font, uint16_t glyph);

  GlyphCells(const GlyphCells&) = delete;
  GlyphCells& operator=(const GlyphCells&) = delete;
  GlyphCells(GlyphCells&&) = default;  // the bytes stay where they are
  GlyphCells& operator=(GlyphCells&&) = default;

  const GlyphField& field() const { return field_; }

  /// RAM that the glyph takes; 0 if it is read in place.
  size_t expanded_bytes() const { return bytes_.size(); }

 private:
  std::vector<uint8_t> bytes_;
  GlyphField field_;
};

}  // namespace inkcell::tools
