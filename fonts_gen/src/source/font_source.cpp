#include "source/font_source.hpp"

#include FT_TRUETYPE_TABLES_H
#include <hb-ot.h>

#include <algorithm>
#include <map>

#include "source/composites.hpp"
#include "source/font_layers.hpp"
#include "source/glyph_reader.hpp"

namespace inkcell::gen {
namespace {

// The most missing characters that a warning lists.
constexpr size_t kListedCharacters = 10;

// The most faces of a file that a warning lists.
constexpr size_t kListedFaces = 20;

// Whether the font draws the glyph by other means than an outline.
bool has_picture(const FontFile& font, uint32_t glyph) {
  hb_blob_t* png = hb_ot_color_glyph_reference_png(font.hb(), glyph);
  hb_blob_t* svg = hb_ot_color_glyph_reference_svg(font.hb_face(), glyph);
  const bool found = hb_blob_get_length(png) + hb_blob_get_length(svg) != 0 ||
                     has_layers(font, glyph);
  hb_blob_destroy(png);
  hb_blob_destroy(svg);
  return found;
}

// Whether a contour can enclose an area. Emoji fonts mark the corners of their
// pictures by contours of a single point.
bool has_area(const Outline& outline) {
  return std::any_of(
      outline.contours.begin(), outline.contours.end(),
      [](const Contour& contour) { return contour.segments.size() > 1; });
}

// Glyphs that a warning is about.
struct GlyphNames {
  size_t count = 0;
  std::string text;

  void add(const SourceGlyph& glyph) {
    if (count <= kListedCharacters) {
      text += count == 0 ? "" : ", ";
      text += count < kListedCharacters ? glyph.name() : "...";
    }
    ++count;
  }
};

void warn_of_pictures(const FontFile& file,
                      const SourceFont& font,
                      Warnings& warnings) {
  GlyphNames names;
  for (const SourceGlyph& glyph : font.glyphs) {
    if (!has_area(glyph.outline) && glyph.painted.empty() &&
        has_picture(file, glyph.source)) {
      names.add(glyph);
    }
  }
  if (names.count != 0) {
    warnings.push_back(
        {Warning::Kind::no_outline,
         file.file_name() + ": " + std::to_string(names.count) +
             (names.count == 1 ? " glyph is" : " glyphs are") +
             " a bitmap or a colour picture without an outline, and left "
             "empty: " +
             names.text});
  }
}

// Sets the layers of all glyphs that have some.
void read_all_layers(const FontFile& file,
                     SourceFont& font,
                     Warnings& warnings) {
  GlyphNames faded;
  for (SourceGlyph& glyph : font.glyphs) {
    if (!glyph.code_points.empty() && read_layers(file, glyph, warnings) != 0) {
      faded.add(glyph);
    }
  }
  if (faded.count != 0) {
    warnings.push_back(
        {Warning::Kind::flat_gradients,
         file.file_name() + ": gradients of " + std::to_string(faded.count) +
             (faded.count == 1 ? " glyph" : " glyphs") +
             " become their mean, because a layer has one colour: " +
             faded.text + "; give the font flat fills to choose others"});
  }
}

void warn_of_embedding(const FontFile& font, Warnings& warnings) {
  const FT_UShort flags = FT_Get_FSType_Flags(font.ft());
  std::string meaning;
  // Where several of bits 0 to 3 are set, the least restrictive one holds.
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

// Warns if the file has several faces and none was chosen.
void warn_of_faces(const FontFile& file, Warnings& warnings) {
  const std::vector<std::string> names = file.face_names();
  if (names.size() < 2) {
    return;
  }
  std::string text =
      file.file_name() + ": holds " + std::to_string(names.size()) +
      " faces; number 0, " + names[0] +
      ", is taken; --face, or face=N after a file of --merge, takes "
      "another one:";
  for (size_t i = 1; i < std::min(names.size(), kListedFaces); ++i) {
    text += (i == 1 ? " " : ", ") + std::to_string(i) + " " + names[i];
  }
  text += names.size() > kListedFaces ? ", ..." : "";
  warnings.push_back({Warning::Kind::face_taken, text});
}

// Indices of glyphs in the font, by their ids in the file.
using KnownGlyphs = std::map<uint32_t, size_t>;

// The glyph of an id, which is added if it is new.
SourceGlyph& glyph_from(uint32_t source, KnownGlyphs& known, SourceFont& font) {
  const auto [found, is_new] = known.emplace(source, font.glyphs.size());
  if (is_new) {
    font.glyphs.emplace_back();
    font.glyphs.back().source = source;
  }
  return font.glyphs[found->second];
}

// Adds the glyphs of all characters; missing ones go to font.missing.
void add_characters(const FontFile& file,
                    const CharSet& characters,
                    KnownGlyphs& known,
                    SourceFont& font) {
  for (const char32_t c : characters) {
    const uint32_t source = file.glyph_of(c);
    if (source == 0) {
      if (is_missed(c)) {
        font.missing.push_back(c);
      }
      continue;
    }
    glyph_from(source, known, font).code_points.push_back(c);
  }
}

// Adds the glyphs of lines. A glyph that is the plain form of a character also
// gets its code point, by which hints find it.
void add_lines(const FontFile& file,
               const LineShare& lines,
               KnownGlyphs& known,
               SourceFont& font) {
  CharSet characters = lines.characters;
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const char32_t c : glyph.code_points) {
      characters.erase(c);
    }
  }
  add_characters(file, characters, known, font);
  for (const uint32_t source : lines.glyphs) {
    glyph_from(source, known, font).is_of_line = true;
  }
}

// Adds all glyphs but components. Returns how many characters brought, with
// .notdef.
size_t choose_glyphs(const FontFile& file,
                     const FontRequest& request,
                     SourceFont& font) {
  font.glyphs.emplace_back();  // .notdef
  KnownGlyphs known;
  add_characters(file, request.characters, known, font);
  const size_t asked = font.glyphs.size();
  add_lines(file, request.lines, known, font);
  if (known.empty() && !font.missing.empty()) {
    refuse_all(file, font.missing.size());
  }
  if (font.glyphs.size() > kMostGlyphs) {
    file.refuse(std::to_string(font.glyphs.size()) +
                " glyphs asked for, a font holds at most 65535; ask for less "
                "with --chars");
  }
  return asked;
}

// The first glyphs of a font, for kerning.
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
  if (!master.empty()) {
    return master;
  }
  if (!layer_of.empty()) {
    return "layer of " + layer_of;
  }
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

// Adds components that have no character of their own.
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

void refuse_all(const FontFile& file, size_t characters) {
  file.refuse("holds none of the " + std::to_string(characters) +
              (characters == 1 ? " character" : " characters") +
              " asked for; check --chars, --symbols and the files of text");
}

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
  return load_font(FontFile(request.file, request.face.value_or(0),
                            request.axes, request.instance),
                   request, jobs, warnings);
}

SourceFont load_font(const FontFile& file,
                     const FontRequest& request,
                     int jobs,
                     Warnings& warnings) {
  SourceFont font;
  font.file_name = file.file_name();
  font.name = file.full_name();
  if (!request.face) {
    warn_of_faces(file, warnings);
  }
  font.faces = {{font.file_name, file.variation()}};
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
  if (request.has_colours) {
    read_all_layers(file, font, warnings);
  }
  warn_of_pictures(file, font, warnings);
  font.kerning = read_kerning(file, kerning_glyphs(font, asked), jobs);
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
  return font;
}

}  // namespace inkcell::gen
