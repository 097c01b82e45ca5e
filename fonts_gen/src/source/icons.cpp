#include "source/icons.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "source/faces.hpp"
#include "svg/svg_drawing.hpp"

namespace inkcell::gen {
namespace {

constexpr int kUnitsPerEm = 1024;
constexpr double kCapHeight_em = 0.7;
constexpr int kMostAdvance = 65535;

int units(double em) {
  return static_cast<int>(std::lround(em * kUnitsPerEm));
}

SourceGlyph make_glyph(const IconFile& icon,
                       const IconPlace& place,
                       const SourceMetrics& metrics) {
  const SvgDrawing drawing(icon.file);
  const std::optional<ViewBox> box = drawing.view_box();
  if (!box) {
    throw Error(icon.file.string() +
                ": <svg> has neither a viewBox nor width and height, so that "
                "its size is not known; add a viewBox");
  }
  const IconBox placed = icon_box(place, metrics);
  const double scale = placed.height / box->height;
  SourceGlyph glyph;
  glyph.face = kIconFace;
  glyph.source = icon.code_point;
  glyph.code_points = {icon.code_point};
  glyph.file_name = icon.file.filename().string();
  glyph.outline =
      drawing.outline({scale, 0, 0, -scale, -scale * box->x,
                       placed.bottom + placed.height + scale * box->y});
  const double advance = scale * box->width * metrics.units_per_em / kUPerEm;
  if (!(advance <= kMostAdvance)) {
    throw Error(icon.file.string() +
                ": its viewBox is too wide for its height; check it");
  }
  glyph.advance = static_cast<int>(std::lround(advance));
  return glyph;
}

}  // namespace

SourceFont font_for_icons() {
  SourceFont font;
  font.name = "icons";
  font.metrics.units_per_em = kUnitsPerEm;
  font.metrics.cap_height = units(kCapHeight_em);
  font.metrics.ascender = units((kCapHeight_em + 1) / 2);
  font.metrics.descender = font.metrics.ascender - kUnitsPerEm;
  font.glyphs.emplace_back();  // .notdef
  font.kerning.left_class = {0};
  font.kerning.right_class = {0};
  return font;
}

void add_icons(const std::vector<IconFile>& icons,
               const IconPlace& place,
               SourceFont& font) {
  std::map<char32_t, std::string> taken;
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const char32_t c : glyph.code_points) {
      taken.emplace(c, glyph.file_name);
    }
  }
  CharSet missing(font.missing.begin(), font.missing.end());
  for (const IconFile& icon : icons) {
    const auto found = taken.find(icon.code_point);
    if (found != taken.end()) {
      throw Error(icon.file.string() + ": " + describe(icon.code_point) +
                  " is a character of " + found->second +
                  " already; choose another code point, or ask for fewer "
                  "characters with --chars");
    }
    font.glyphs.push_back(make_glyph(icon, place, font.metrics));
    missing.erase(icon.code_point);
    for (ShapedLine& line : font.lines) {
      place_icon(icon.code_point, font.glyphs.back().advance, line);
    }
  }
  font.missing.assign(missing.begin(), missing.end());
  font.icons.insert(font.icons.end(), icons.begin(), icons.end());
  font.file_name += (font.file_name.empty() ? "" : ", ") +
                    std::to_string(icons.size()) +
                    (icons.size() == 1 ? " icon" : " icons");
  font.components.resize(font.glyphs.size());
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
  sort_glyphs(font);
}

}  // namespace inkcell::gen
