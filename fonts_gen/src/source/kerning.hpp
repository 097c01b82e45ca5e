// The kerning of a font, asked from HarfBuzz for each pair, as a class matrix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "source/font_file.hpp"

namespace inkcell::gen {

/// Pair kerning of the glyphs 0..n-1; equal rows and equal columns are stored
/// once. All values in font units.
struct KerningMatrix {
  /// The class of each glyph on the left and on the right; class 0 never kerns.
  std::vector<uint16_t> left_class;
  std::vector<uint16_t> right_class;
  int left_classes = 0;  // without class 0
  int right_classes = 0;
  /// Value of left class l + 1 and right class r + 1 at
  /// l * right_classes + r.
  std::vector<int16_t> values;

  bool empty() const { return values.empty(); }
  int value(size_t left, size_t right) const;
};

/// A glyph, for kerning.
struct KerningGlyph {
  uint32_t source = 0;  // id in the font file
  hb_script_t script = HB_SCRIPT_COMMON;
};

/// Joins equal rows and equal columns of a square matrix. `rows` has n values
/// for each glyph of `rows_of`; all other rows are zero.
KerningMatrix join_classes(size_t glyph_count,
                           const std::vector<size_t>& rows_of,
                           const std::vector<std::vector<int16_t>>& rows);

/// The kerning of all pairs of `glyphs` by the `kern` feature of GPOS, or else
/// the kern table, for text from left to right; no other feature takes part.
/// Glyphs of different scripts do not kern, as a shaping engine never sees them
/// in one run.
///
/// Only pairs that the font's kerning mentions are shaped, so glyphs without
/// kerning cost nothing.
KerningMatrix read_kerning(const FontFile& font,
                           const std::vector<KerningGlyph>& glyphs,
                           int jobs);

}  // namespace inkcell::gen
