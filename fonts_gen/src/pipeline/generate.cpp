#include "pipeline/generate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "judge/closed_loop.hpp"
#include "judge/rom_check.hpp"
#include "pipeline/build.hpp"
#include "pipeline/font_morphs.hpp"
#include "pipeline/font_shaping.hpp"
#include "pipeline/font_strikes.hpp"
#include "pipeline/layers.hpp"
#include "pipeline/missing.hpp"
#include "pipeline/unshaped.hpp"
#include "rom/paged_font.hpp"
#include "rom/rom_font.hpp"
#include "source/faces.hpp"
#include "source/icons.hpp"
#include "source/masters.hpp"
#include "source/pixel_font.hpp"

namespace inkcell::gen {
namespace {

// What was asked for, or what was reached where that is worse. [1/255]
double promised_tolerance(const Target& asked,
                          const std::vector<GlyphErrors>& errors) {
  double tolerance = asked.tolerance;
  for (const GlyphErrors& glyph : errors) {
    tolerance = std::max(tolerance, std::ceil(glyph.promised.worst));
  }
  return std::min(tolerance, 255.0);
}

std::vector<LineText> lines_of(const std::vector<NamedString>& strings) {
  std::vector<LineText> lines;
  for (const NamedString& string : strings) {
    lines.push_back(string.line);
  }
  return lines;
}

// The characters of a list, or those asked for if it is empty, that a font
// lacks.
CharSet rest_of(const CharSet& list, CharSet& asked, const SourceFont& font) {
  asked.insert(list.begin(), list.end());
  CharSet rest = list.empty() ? asked : list;
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const char32_t c : glyph.code_points) {
      rest.erase(c);
    }
  }
  return rest;
}

// Merges a face that has such characters.
void merge_rest(SourceFont part,
                CharSet& asked,
                SourceFont& font,
                Warnings& warnings) {
  if (part.pixel_px != 0 && font.pixel_px != 0 &&
      (part.pixel_px != font.pixel_px || part.pixel_bits != font.pixel_bits)) {
    throw Error(part.file_name + ": has other pixels than " + font.file_name +
                "; merge bitmap fonts of one size and depth");
  }
  for (SourceGlyph& glyph : part.glyphs) {
    glyph.face += font.faces.size();
  }
  merge_font(std::move(part), font);
  font.missing.clear();
  for (const char32_t c : rest_of({}, asked, font)) {
    if (is_missed(c)) {
      font.missing.push_back(c);
    }
  }
  renew_missing_warning(font, warnings);
}

// A distance in the form that a run keeps.
int16_t step(int units, const NamedString& string) {
  if (units < INT16_MIN || units > INT16_MAX) {
    throw Error(string.file + ":" + std::to_string(string.line_number) +
                ": two glyphs of '" + string.name + "' are " +
                std::to_string(units) +
                " font units apart, at most 32767 are possible; shorten the "
                "blank between them");
  }
  return static_cast<int16_t>(units);
}

// The strings with the glyph ids of the finished font.
std::vector<RomString> shaped_strings(const std::vector<NamedString>& strings,
                                      const SourceFont& font) {
  std::map<std::pair<size_t, uint32_t>, uint16_t> place_of;
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    place_of.emplace(std::pair(font.glyphs[i].face, font.glyphs[i].source),
                     static_cast<uint16_t>(i));
  }
  std::vector<RomString> out;
  for (size_t i = 0; i < strings.size(); ++i) {
    const ShapedLine& line = font.lines[i];
    RomString string;
    string.name = strings[i].name;
    for (const char32_t c : strings[i].line.text) {
      string.text += to_utf8(c);
    }
    string.advance = line.advance;
    int x = 0;
    for (const LineGlyph& glyph : line.glyphs) {
      string.glyphs.push_back({place_of.at({glyph.face, glyph.source}),
                               step(glyph.x - x, strings[i]),
                               step(glyph.y, strings[i])});
      x = glyph.x;
    }
    out.push_back(std::move(string));
  }
  return out;
}

// All faces. Bitmap fonts come before outlines, unless those are the first.
SourceFont load_all(const GenerateRequest& request,
                    const FontRequest& first,
                    const std::vector<LineText>& lines,
                    Warnings& warnings) {
  std::vector<MergedFace> outlines;
  std::vector<MergedFace> pixels;
  for (const std::string& text : request.merge) {
    const MergedFace face = parse_merged_face(text);
    (is_bitmap_font(face.file) ? pixels : outlines).push_back(face);
  }
  const bool is_pixel = is_bitmap_font(first.file);
  if (!is_pixel && pixels.empty()) {
    return load_faces(first, outlines, lines, request.threads, warnings);
  }
  if (!lines.empty() || !request.morphs.empty() ||
      has_second_master(request.axes) ||
      request.target.coding != Coding::outline) {
    throw Error(
        "bitmap fonts have neither outlines nor shaping: leave --coding, "
        "--strings, --morph and --axis with two values out, or those fonts");
  }
  SourceFont font =
      is_pixel ? load_pixel_font(first, warnings)
               : load_faces(first, outlines, lines, request.threads, warnings);
  CharSet asked = first.characters;
  for (const MergedFace& face : pixels) {
    FontRequest more;
    more.file = face.file;
    more.face = face.face;
    more.characters = rest_of(face.characters, asked, font);
    merge_rest(load_pixel_font(more, warnings), asked, font, warnings);
  }
  if (is_pixel && !outlines.empty()) {
    FontRequest more;
    more.file = outlines[0].file;
    more.face = outlines[0].face;
    more.instance = outlines[0].instance;
    more.axes = outlines[0].axes;
    more.with_components = true;
    more.has_colours = first.has_colours;
    more.characters = rest_of(outlines[0].characters, asked, font);
    outlines.erase(outlines.begin());
    if (!more.characters.empty()) {
      merge_rest(load_faces(more, outlines, {}, request.threads, warnings),
                 asked, font, warnings);
    }
  }
  return font;
}

SourceFont load_source(const GenerateRequest& request,
                       const std::vector<NamedString>& strings,
                       AskedCharacters& asked,
                       Warnings& warnings) {
  const std::vector<IconFile> icons =
      find_icons(request.svg_files, request.svg_folders, shapes_emoji(request));
  SourceFont font;
  FontRequest first;
  if (request.font.empty()) {
    font = font_for_icons();
  } else {
    first.file = request.font;
    first.face = request.face;
    first.instance = request.instance;
    first.axes = request.axes;
    asked = characters_of(request);
    first.characters = asked.all;
    if (!request.shapes.empty()) {
      first.shapes = parse_shape_scripts(request.shapes);
    }
    first.keep_layout = request.keep_layout;
    first.additions =
        request.layout_glyphs ? Additions::signs : Additions::space;
    first.with_components = true;
    first.has_colours = request.has_colours;
    font = load_all(request, first, lines_of(strings), warnings);
  }
  if (!icons.empty()) {
    add_icons(icons, request.icon_place, request.has_colours, font);
    renew_missing_warning(font, warnings);
  }
  if (has_second_master(first.axes)) {
    add_masters(first, font, warnings);
  }
  make_layers(font, request.threads);
  return font;
}

// A block of a paged font holds all pairs, or none are there.
void tell_of_kerning(RomContent& content,
                     const PartBytes& parts,
                     Warnings& warnings) {
  if (!content.kerning.empty() && parts.kerning == 0) {
    warnings.push_back(
        {Warning::Kind::no_kerning,
         content.name + ": no pair kerns, because a block of " +
             std::to_string(content.block_bytes) +
             " bytes has no room for all that do; use larger blocks, or put "
             "letters into a font in mapped memory, and this one behind it as "
             "a fallback"});
    content.kerning = {};
  }
}

}  // namespace

void generate_part(const GenerateRequest& request, GlyphPart part) {
  check_request(request);
  AskedCharacters asked;
  Warnings warnings;  // generate() gives them
  const SourceFont font =
      load_source(request, strings_of(request), asked, warnings);
  build_part(font, request, part);
}

RomFont generate(const GenerateRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  check_request(request);
  RomFont rom;
  const std::vector<NamedString> strings = strings_of(request);
  AskedCharacters asked;
  SourceFont font = load_source(request, strings, asked, rom.warnings);
  tell_of_unshaped(request, rom.warnings);
  if (request.strict && !font.missing.empty()) {
    refuse_missing(request, font.file_name, font.missing);
  }
  std::vector<GlyphErrors> errors;
  RomContent content = build_content(font, request, errors);
  content.layers = rom_layers(font);
  add_morphs(request, font, content, rom.warnings);
  // A font promises what it holds.
  content.options.tolerance = promised_tolerance(request.target, errors);
  add_strikes(request, font, content);
  PartBytes parts;
  if (request.paged != 0) {
    rom.bytes = write_paged_font(content, parts);
    tell_of_kerning(content, parts, rom.warnings);
    check_paged_font(rom.bytes, content);
  } else {
    rom.bytes = write_shaped_font(request, font, content, parts, rom.warnings);
    check_rom_font(rom.bytes, content);
  }
  rom.strings = shaped_strings(strings, font);
  content.options.tolerance = request.target.tolerance;
  rom.report = make_report(font, content, errors);
  rom.report.bytes = parts;
  rom.report.languages = report_languages(font, asked, rom.report);
  tell_of_errors(rom.report, request.tolerance_is_limit, rom.warnings);
  rom.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return rom;
}

}  // namespace inkcell::gen
