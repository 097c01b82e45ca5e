#include "source/font_source.hpp"
#include "source/composites.hpp"

#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include <hb-ot.h>

#include <algorithm>
#include <map>
#include <set>

namespace inkcell::gen {
namespace {

constexpr double kUnitsOfU = 1024;

// FreeType finds the implied points of quadratic curves by halving sums of
// whole numbers; coordinates walk shifted by this much, so that nothing is
// lost. [bits]
constexpr int kWalkShift = 6;

// Missing characters that a warning lists.
constexpr size_t kListedCharacters = 10;

// Receives the pieces of an outline from FreeType.
class OutlineBuilder {
 public:
  explicit OutlineBuilder(int units_per_em)
      : scale_(kUnitsOfU / (units_per_em << kWalkShift)) {}

  Outline build(FT_Outline& source) {
    FT_Outline_Funcs functions = {};
    functions.shift = kWalkShift;
    functions.move_to = [](const FT_Vector* to, void* self) {
      return static_cast<OutlineBuilder*>(self)->move(*to);
    };
    functions.line_to = [](const FT_Vector* to, void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(Segment::Kind::line,
                                                       {to});
    };
    functions.conic_to = [](const FT_Vector* control, const FT_Vector* to,
                            void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(Segment::Kind::quadratic,
                                                       {control, to});
    };
    functions.cubic_to = [](const FT_Vector* control1,
                            const FT_Vector* control2, const FT_Vector* to,
                            void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(
          Segment::Kind::cubic, {control1, control2, to});
    };
    ok_ = FT_Outline_Decompose(&source, &functions, this) == 0;
    return std::move(outline_);
  }

  bool ok() const { return ok_; }

 private:
  Point to_u(const FT_Vector& v) const {
    return {static_cast<double>(v.x) * scale_,
            static_cast<double>(v.y) * scale_};
  }

  int move(const FT_Vector& to) {
    outline_.contours.emplace_back();
    at_ = to_u(to);
    return 0;
  }

  int curve(Segment::Kind kind, std::initializer_list<const FT_Vector*> rest) {
    Segment segment;
    segment.kind = kind;
    segment.p[0] = at_;
    size_t count = 1;
    for (const FT_Vector* point : rest) {
      segment.p[count++] = to_u(*point);
    }
    at_ = segment.p[count - 1];
    outline_.contours.back().segments.push_back(segment);
    return 0;
  }

  double scale_;
  Point at_;
  Outline outline_;
  bool ok_ = false;
};

// "glyph 36 (U+0041 'A')".
std::string name_of(uint32_t glyph, const std::string& character) {
  return "glyph " + std::to_string(glyph) + " (" + character + ")";
}

// Loads a glyph into FreeType's slot, in font units; FreeType's error.
FT_Error load_outline(const FontFile& font, uint32_t glyph) {
  const FT_Error error =
      FT_Load_Glyph(font.ft(), glyph,
                    FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  const bool is_outline =
      error == 0 && font.ft()->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
  return is_outline || error != 0 ? error : FT_Err_Invalid_Glyph_Format;
}

// Advance of the glyph that is in FreeType's slot. [font units] HarfBuzz knows
// HVAR, but what is beyond 16 bits with a sign comes out of it negative.
int advance_of(const FontFile& font, uint32_t glyph) {
  const int advance = hb_font_get_glyph_h_advance(font.hb(), glyph);
  return advance >= 0 ? advance
                      : static_cast<int>(font.ft()->glyph->metrics.horiAdvance);
}

void read_glyph(const FontFile& font, SourceGlyph& glyph, Warnings& warnings) {
  const std::string name = name_of(glyph.source, glyph.name());
  const FT_Error error = load_outline(font, glyph.source);
  if (error != 0) {
    font.refuse(
        name + " cannot be read (FreeType error " + std::to_string(error) +
        "); the font is damaged there: " + glyph.remedy("get the font anew"));
  }
  OutlineBuilder builder(font.units_per_em());
  glyph.outline = builder.build(font.ft()->glyph->outline);
  if (!builder.ok()) {
    font.refuse(name + " has a malformed outline; " +
                glyph.remedy("repair the font"));
  }
  const int advance = advance_of(font, glyph.source);
  glyph.advance = std::clamp(advance, 0, 65535);
  if (glyph.advance != advance) {
    warnings.push_back({Warning::Kind::measure,
                        font.file_name() + ": " + name + ": advance " +
                            std::to_string(advance) + " is out of range, " +
                            std::to_string(glyph.advance) + " is used"});
  }
}

// Highest point of a character in font units; 0 if the font does not have it,
// or has it damaged.
int top_of(const FontFile& font, char32_t code_point, Warnings& warnings) {
  const uint32_t glyph = font.glyph_of(code_point);
  if (glyph == 0) {
    return 0;
  }
  if (load_outline(font, glyph) != 0) {
    warnings.push_back(
        {Warning::Kind::measure,
         font.file_name() + ": " + name_of(glyph, describe(code_point)) +
             " cannot be read, so that its height is not known: 0 is used"});
    return 0;
  }
  FT_BBox box;
  FT_Outline_Get_CBox(&font.ft()->glyph->outline, &box);
  return static_cast<int>(box.yMax);
}

SourceMetrics read_metrics(const FontFile& font, Warnings& warnings) {
  const auto measure = [&](hb_ot_metrics_tag_t tag, int otherwise) {
    hb_position_t value = 0;
    return hb_ot_metrics_get_position(font.hb(), tag, &value) ? value
                                                              : otherwise;
  };
  const auto clamp = [](int value) { return std::clamp(value, -32768, 32767); };
  SourceMetrics m;
  m.units_per_em = font.units_per_em();
  m.ascender = clamp(
      measure(HB_OT_METRICS_TAG_HORIZONTAL_ASCENDER, font.ft()->ascender));
  m.descender = clamp(
      measure(HB_OT_METRICS_TAG_HORIZONTAL_DESCENDER, font.ft()->descender));
  m.line_gap = clamp(measure(HB_OT_METRICS_TAG_HORIZONTAL_LINE_GAP, 0));
  m.x_height = clamp(measure(HB_OT_METRICS_TAG_X_HEIGHT, 0));
  m.cap_height = clamp(measure(HB_OT_METRICS_TAG_CAP_HEIGHT, 0));
  // Old OS/2 tables do not have these two, and some fonts leave them zero.
  if (m.x_height <= 0) {
    m.x_height = clamp(top_of(font, U'x', warnings));
  }
  if (m.cap_height <= 0) {
    m.cap_height = clamp(top_of(font, U'H', warnings));
  }
  return m;
}

// Whether the font has a picture of the glyph that is no plain outline.
bool has_picture(const FontFile& font, uint32_t glyph) {
  hb_blob_t* png = hb_ot_color_glyph_reference_png(font.hb(), glyph);
  hb_blob_t* svg = hb_ot_color_glyph_reference_svg(font.hb_face(), glyph);
  const bool found = hb_blob_get_length(png) + hb_blob_get_length(svg) != 0 ||
                     hb_ot_color_glyph_get_layers(font.hb_face(), glyph, 0,
                                                  nullptr, nullptr) != 0;
  hb_blob_destroy(png);
  hb_blob_destroy(svg);
  return found;
}

// Whether a contour can enclose anything. Emoji fonts mark the corners of
// their pictures by contours of a single point.
bool has_area(const Outline& outline) {
  return std::any_of(
      outline.contours.begin(), outline.contours.end(),
      [](const Contour& contour) { return contour.segments.size() > 1; });
}

void warn_of_pictures(const FontFile& file,
                      const SourceFont& font,
                      Warnings& warnings) {
  std::string names;
  size_t count = 0;
  for (const SourceGlyph& glyph : font.glyphs) {
    if (!has_area(glyph.outline) && has_picture(file, glyph.source)) {
      if (count < kListedCharacters) {
        names += (count == 0 ? "" : ", ") + glyph.name();
      }
      ++count;
    }
  }
  if (count != 0) {
    warnings.push_back(
        {Warning::Kind::no_outline,
         file.file_name() + ": " + std::to_string(count) +
             (count == 1 ? " glyph is" : " glyphs are") +
             " a bitmap or a colour picture without an outline, and left "
             "empty: " +
             names + (count > kListedCharacters ? ", ..." : "")});
  }
}

void warn_of_embedding(const FontFile& font, Warnings& warnings) {
  const FT_UShort flags = FT_Get_FSType_Flags(font.ft());
  std::string meaning;
  // Bits 0 to 3: the least restrictive one holds if there are several.
  if ((flags & FT_FSTYPE_EDITABLE_EMBEDDING) != 0) {
    meaning = "editable embedding: may be part of a document that is edited";
  } else if ((flags & FT_FSTYPE_PREVIEW_AND_PRINT_EMBEDDING) != 0) {
    meaning = "preview and print embedding: read-only documents only";
  } else if ((flags & FT_FSTYPE_RESTRICTED_LICENSE_EMBEDDING) != 0) {
    meaning =
        "restricted licence: must not be embedded, modified or exchanged "
        "without the owner's permission";
  }
  if ((flags & FT_FSTYPE_NO_SUBSETTING) != 0) {
    meaning += meaning.empty() ? "" : "; ";
    meaning += "no subsetting: only the whole font may be embedded";
  }
  if ((flags & FT_FSTYPE_BITMAP_EMBEDDING_ONLY) != 0) {
    meaning += meaning.empty() ? "" : "; ";
    meaning += "bitmap embedding only: no outlines may be embedded";
  }
  if (!meaning.empty()) {
    warnings.push_back({Warning::Kind::embedding,
                        font.file_name() + ": fsType " + std::to_string(flags) +
                            ", " + meaning +
                            ". Check the font's licence before you ship it"});
  }
}

// Places of glyphs in a font, by their ids in the file.
using KnownGlyphs = std::map<uint32_t, size_t>;

// Adds the glyphs of all characters; what is missing goes to font.missing.
void add_characters(const FontFile& file,
                    const CharSet& characters,
                    KnownGlyphs& known,
                    SourceFont& font) {
  for (const char32_t c : characters) {
    const uint32_t source = file.glyph_of(c);
    if (source == 0) {
      font.missing.push_back(c);
      continue;
    }
    const auto [found, is_new] = known.emplace(source, font.glyphs.size());
    if (is_new) {
      font.glyphs.emplace_back();
      font.glyphs.back().source = source;
    }
    font.glyphs[found->second].code_points.push_back(c);
  }
}

// The characters of lines whose own glyphs lines show.
CharSet characters_of_lines(const FontFile& file,
                            const std::vector<LineText>& lines,
                            const std::set<uint32_t>& shown) {
  CharSet characters;
  for (const LineText& line : lines) {
    for (const char32_t c : line.text) {
      const uint32_t glyph = file.glyph_of(c);
      if (glyph != 0 && shown.count(glyph) != 0) {
        characters.insert(c);
      }
    }
  }
  return characters;
}

// Shapes the lines, and adds the glyphs that they show. One that is what its
// character looks like alone gets its code point, too: hints are found by them.
void add_lines(const FontFile& file,
               const std::vector<LineText>& lines,
               KnownGlyphs& known,
               SourceFont& font) {
  std::set<uint32_t> shown;
  std::set<char32_t> missing(font.missing.begin(), font.missing.end());
  for (const LineText& line : lines) {
    font.lines.push_back(shape_line(file, line));
    for (const LineGlyph& glyph : font.lines.back().glyphs) {
      if (glyph.source != 0) {
        shown.insert(glyph.source);
      }
    }
    missing.insert(font.lines.back().missing.begin(),
                   font.lines.back().missing.end());
  }
  font.missing.assign(missing.begin(), missing.end());
  CharSet characters = characters_of_lines(file, lines, shown);
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const char32_t c : glyph.code_points) {
      characters.erase(c);
    }
  }
  add_characters(file, characters, known, font);
  for (const uint32_t source : shown) {
    const auto [found, is_new] = known.emplace(source, font.glyphs.size());
    if (is_new) {
      font.glyphs.emplace_back();
      font.glyphs.back().source = source;
    }
    font.glyphs[found->second].is_of_line = true;
  }
}

// Finds all glyphs but components; the number of those that characters asked
// for, with .notdef.
size_t choose_glyphs(const FontFile& file,
                     const FontRequest& request,
                     SourceFont& font) {
  font.glyphs.emplace_back();  // .notdef
  KnownGlyphs known;
  add_characters(file, request.characters, known, font);
  const size_t asked = font.glyphs.size();
  add_lines(file, request.lines, known, font);
  if (known.empty() && !font.missing.empty()) {
    file.refuse("holds none of the " + std::to_string(font.missing.size()) +
                (font.missing.size() == 1 ? " character" : " characters") +
                " asked for; check --chars, --symbols and the files of text");
  }
  if (font.glyphs.size() > kMostGlyphs) {
    file.refuse(std::to_string(font.glyphs.size()) +
                " glyphs asked for, a font holds at most 65535; ask for less "
                "with --chars");
  }
  return asked;
}

// The first glyphs of a font for the purpose of kerning.
std::vector<KerningGlyph> kerning_glyphs(const SourceFont& font, size_t count) {
  hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
  std::vector<KerningGlyph> glyphs;
  for (size_t i = 0; i < count; ++i) {
    const SourceGlyph& glyph = font.glyphs[i];
    hb_script_t script = HB_SCRIPT_COMMON;
    if (!glyph.code_points.empty()) {
      script = hb_unicode_script(unicode, glyph.code_points.front());
    }
    if (script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN) {
      script = HB_SCRIPT_COMMON;
    }
    glyphs.push_back({glyph.source, script});
  }
  return glyphs;
}

}  // namespace

std::string SourceGlyph::name() const {
  if (!code_points.empty()) {
    return describe(code_points.front());
  }
  return source == 0
             ? ".notdef"
             : (is_of_line ? "glyph " : "component ") + std::to_string(source);
}

std::string SourceGlyph::remedy(const std::string& repair) const {
  return code_points.empty() ? repair : repair + " or leave the character out";
}

namespace {

// Adds the parts of other glyphs that have no character of their own.
void add_components(const FontFile& file, SourceFont& font) {
  std::vector<uint32_t> ids;
  for (const SourceGlyph& glyph : font.glyphs) {
    ids.push_back(glyph.source);
  }
  for (const uint32_t id : missing_components(file, ids)) {
    if (font.glyphs.size() == kMostGlyphs) {
      break;
    }
    SourceGlyph glyph;
    glyph.source = id;
    font.glyphs.push_back(glyph);
    ids.push_back(id);
  }
  font.components = source_composites(file, ids);
}

}  // namespace

CharSet missing_in_lines(const SourceFont& font) {
  CharSet missing;
  for (const ShapedLine& line : font.lines) {
    missing.insert(line.missing.begin(), line.missing.end());
  }
  return missing;
}

void renew_missing_warning(const SourceFont& font, Warnings& warnings) {
  warnings.erase(std::remove_if(warnings.begin(), warnings.end(),
                                [](const Warning& warning) {
                                  return warning.kind ==
                                         Warning::Kind::missing_characters;
                                }),
                 warnings.end());
  if (font.missing.empty()) {
    return;
  }
  std::string text =
      font.file_name + ": " + std::to_string(font.missing.size()) +
      (font.missing.size() == 1 ? " character is" : " characters are") +
      " not in the font: ";
  for (size_t i = 0; i < std::min(font.missing.size(), kListedCharacters);
       ++i) {
    text += (i == 0 ? "" : ", ") + describe(font.missing[i]);
  }
  if (font.missing.size() > kListedCharacters) {
    text += ", ...";
  }
  warnings.push_back({Warning::Kind::missing_characters, text});
}

SourceFont load_font(const FontRequest& request, int jobs, Warnings& warnings) {
  const FontFile file(request.file, request.face, request.axes);
  SourceFont font;
  font.file_name = file.file_name();
  font.name = file.full_name();
  const size_t asked = choose_glyphs(file, request, font);
  warn_of_embedding(file, warnings);
  renew_missing_warning(font, warnings);
  font.metrics = read_metrics(file, warnings);
  if (request.with_components) {
    add_components(file, font);
  }
  for (SourceGlyph& glyph : font.glyphs) {
    glyph.file_name = font.file_name;
    read_glyph(file, glyph, warnings);
  }
  warn_of_pictures(file, font, warnings);
  font.kerning = read_kerning(file, kerning_glyphs(font, asked), jobs);
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
  return font;
}

CharSet characters_in(const FontRequest& request) {
  const FontFile file(request.file, request.face, request.axes);
  CharSet found;
  for (const char32_t c : request.characters) {
    if (file.glyph_of(c) != 0) {
      found.insert(c);
    }
  }
  return found;
}

}  // namespace inkcell::gen
