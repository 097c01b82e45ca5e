// Small tables of TrueType fonts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "export/sfnt.hpp"
#include "model/project.hpp"

namespace inkcell::design {

/// The glyph of each code point, in formats 4 and 12.
BigEndian cmap_table(const std::map<char32_t, unsigned>& map);

/// Kerning of all pairs of these glyphs, in their order; empty without kerning.
BigEndian kern_table(const FontData& font,
                     const std::vector<std::string>& glyphs);

/// Kerning between two glyphs as in UFO 3: pairs of glyphs before pairs of
/// groups (public.kern1.*, public.kern2.*). [font units] Refers to the font.
class KerningLookup {
 public:
  explicit KerningLookup(const FontData& font);

  double value(const std::string& left, const std::string& right) const;

 private:
  const FontData& font_;
  std::map<std::string, std::string> left_group_;
  std::map<std::string, std::string> right_group_;
};

}  // namespace inkcell::design
