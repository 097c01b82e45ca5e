// Small tables of TrueType fonts, and fontinfo in them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "export/sfnt.hpp"
#include "model/project.hpp"
#include "source/kerning.hpp"

namespace inkcell::design {

/// The glyph of each code point, in formats 4 and 12.
BigEndian cmap_table(const std::map<char32_t, unsigned>& map);

/// Kerning of all pairs of these glyphs, in their order; empty without kerning.
gen::KerningMatrix kerning_of(const FontData& font,
                              const std::vector<std::string>& glyphs);
size_t kerned_pairs(const gen::KerningMatrix& kerning);

/// The same kerning as pairs, for old readers, and as classes of the feature
/// `kern`. `kerning` is not empty.
BigEndian kern_table(const gen::KerningMatrix& kerning);
BigEndian gpos_table(const gen::KerningMatrix& kerning);

/// Texts of the font by their numbers in the table name, and by their keys in
/// fontinfo: notices and licences.
struct NameKey {
  unsigned id;
  const char* key;
};
inline constexpr NameKey kNameKeys[] = {{0, "copyright"},
                                        {7, "trademark"},
                                        {8, "openTypeNameManufacturer"},
                                        {9, "openTypeNameDesigner"},
                                        {10, "openTypeNameDescription"},
                                        {11, "openTypeNameManufacturerURL"},
                                        {12, "openTypeNameDesignerURL"},
                                        {13, "openTypeNameLicense"},
                                        {14, "openTypeNameLicenseURL"}};

/// Kerning between two glyphs as in UFO 3: pairs of glyphs before pairs of
/// groups (public.kern1.*, public.kern2.*). [font units] Refers to the font.
class KerningLookup {
 public:
  explicit KerningLookup(const FontData& font);

  double value(const std::string& left, const std::string& right) const;
  /// The entry of kerning that decides: glyphs or groups. Without one, that of
  /// both groups, or of a glyph where it has none.
  std::pair<std::string, std::string> entry(const std::string& left,
                                            const std::string& right) const;
  /// The group of a glyph on the left or on the right of pairs; may be "".
  std::string left_group(const std::string& glyph) const;
  std::string right_group(const std::string& glyph) const;

 private:
  const FontData& font_;
  std::map<std::string, std::string> left_group_;
  std::map<std::string, std::string> right_group_;
};

}  // namespace inkcell::design
