// Projects as TrueType fonts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// What a font has of its project.
struct TtfReport {
  size_t glyphs = 0;
  size_t undrawn = 0;  // of them, spaces apart
  size_t kerned_pairs = 0;
  std::vector<std::string> left_out;  // glyphs
  std::vector<std::string> open;      // glyphs with contours that are open
  bool has_features = false;          // features.fea, which is left out

  /// "95 glyphs, 3 of them empty, 1204 pairs of kerning; left out: ..."
  std::string text() const;
};

/// The bytes of a TrueType font: head, hhea, maxp, OS/2, hmtx, cmap (4 and 12),
/// loca, glyf, name, post, and kern and GPOS if the project has kerning.
/// Contours keep their points; components stay components if the table can hold
/// them (glyf_components.hpp); cubics become quadratics (glyf.hpp). The first
/// glyph is .notdef; a box is drawn if the project has none. Glyphs whose names
/// begin with '_', and those without a code point that no component needs, are
/// left out.
///
/// Throws Error that names the glyph.
std::vector<uint8_t> write_ttf(const Project& project,
                               TtfReport* report = nullptr);

}  // namespace inkcell::design
