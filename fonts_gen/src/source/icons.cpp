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
constexpr uint32_t kFirstSequence = 0x110000;  // sources behind code points

int units(double em) {
  return static_cast<int>(std::lround(em * kUnitsPerEm));
}

// Whether layers are but one outline in the colour of text.
bool is_plain(const std::vector<PaintedOutline>& layers) {
  const Paint& paint = layers[0].paint;
  return layers.size() == 1 && (paint == Paint() || paint.is_ink) &&
         paint.opacity == 255;
}

SourceGlyph make_glyph(const IconFile& icon,
                       const IconPlace& place,
                       bool has_colours,
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
  if (icon.sequence.empty()) {
    glyph.code_points = {icon.code_point};
  } else {
    glyph.is_of_line = true;
    glyph.sequence = icon.sequence;
  }
  glyph.file_name = icon.file.filename().string();
  const Affine to_u = {scale,
                       0,
                       0,
                       -scale,
                       -scale * box->x,
                       placed.bottom + placed.height + scale * box->y};
  if (has_colours) {
    glyph.painted = drawing.layers(to_u);
  }
  if (!has_colours || is_plain(glyph.painted)) {
    glyph.painted.clear();
    glyph.outline = drawing.outline(to_u);
  }
  const double advance = scale * box->width * metrics.units_per_em / kUPerEm;
  if (!(advance <= kMostAdvance)) {
    throw Error(icon.file.string() +
                ": its viewBox is too wide for its height; check it");
  }
  glyph.advance = static_cast<int>(std::lround(advance));
  return glyph;
}

// Gives the characters of an emoji glyphs, those that show nothing alone.
void add_parts(const IconFile& icon,
               std::map<char32_t, std::string>& taken,
               SourceFont& font) {
  for (const char32_t c : icon.sequence) {
    const bool is_part = c == 0x200d || c == 0x20e3 ||
                         (c >= 0x1f1e6 && c <= 0x1f1ff) ||
                         (c >= 0x1f3fb && c <= 0x1f3ff) || c >= 0xe0000;
    const std::string file_name = icon.file.filename().string();
    if (!taken.emplace(c, file_name).second) {
      continue;
    }
    if (!is_part) {
      throw Error(icon.file.string() + ": begins with or has " + describe(c) +
                  ", of which there is no glyph; add a drawing of it, or ask "
                  "for the character with --chars");
    }
    SourceGlyph part;
    part.face = kIconFace;
    part.source = c;
    part.code_points = {c};
    part.file_name = file_name;
    font.glyphs.push_back(part);
  }
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
               bool has_colours,
               SourceFont& font) {
  std::map<char32_t, std::string> taken;
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const char32_t c : glyph.code_points) {
      taken.emplace(c, glyph.file_name);
    }
  }
  CharSet missing(font.missing.begin(), font.missing.end());
  uint32_t sequences = 0;
  for (const IconFile& icon : icons) {
    if (!icon.sequence.empty()) {
      add_parts(icon, taken, font);
      font.glyphs.push_back(make_glyph(icon, place, has_colours, font.metrics));
      font.glyphs.back().source = kFirstSequence + sequences++;
      continue;
    }
    font.icons.push_back(icon);
    const auto found = taken.find(icon.code_point);
    if (found != taken.end()) {
      throw Error(icon.file.string() + ": " + describe(icon.code_point) +
                  " is a character of " + found->second +
                  " already; choose another code point, or ask for fewer "
                  "characters with --chars");
    }
    font.glyphs.push_back(make_glyph(icon, place, has_colours, font.metrics));
    taken.emplace(icon.code_point, font.glyphs.back().file_name);
    missing.erase(icon.code_point);
    for (ShapedLine& line : font.lines) {
      place_icon(icon.code_point, font.glyphs.back().advance, line);
    }
  }
  font.missing.assign(missing.begin(), missing.end());
  font.file_name += (font.file_name.empty() ? "" : ", ") +
                    std::to_string(icons.size()) +
                    (icons.size() == 1 ? " icon" : " icons");
  font.components.resize(font.glyphs.size());
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
  sort_glyphs(font);
}

}  // namespace inkcell::gen
