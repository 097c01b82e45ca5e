#include "pipeline/font_shaping.hpp"

#include <hb.h>

#include <algorithm>
#include <numeric>

#include "inkcell/format/rom.hpp"
#include "shaping/shape_check.hpp"
#include "source/line_shaper.hpp"
#include "source/pixel_font.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen {
namespace {

// A script above this is told: its text costs more than drawing it.
constexpr unsigned kDearSteps = 64;

// Emoji that are drawings.
void add_drawings(const SourceFont& font, ShapeSource& source) {
  std::map<char32_t, uint16_t> all;
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    for (const char32_t c : font.glyphs[i].code_points) {
      all.emplace(c, static_cast<uint16_t>(i));
      if (font.glyphs[i].face == kIconFace && is_emoji(c)) {
        source.drawings.emplace(c, static_cast<uint16_t>(i));
      }
    }
  }
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    std::vector<uint16_t> parts;
    for (const char32_t c : font.glyphs[i].sequence) {
      parts.push_back(all.at(c));
    }
    if (!parts.empty()) {
      source.sequences.emplace(parts, static_cast<uint16_t>(i));
    }
  }
}

ShapeSource shape_source(const FontFile& file,
                         const GenerateRequest& request,
                         const SourceFont& font) {
  ShapeSource source = {file,
                        shape_plans(file, parse_shape_scripts(request.shapes)),
                        {{0, 0}},
                        {},
                        font.glyphs.size()};
  add_drawings(font, source);
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    const SourceGlyph& glyph = font.glyphs[i];
    if (glyph.face != 0 || !glyph.master.empty() || glyph.source == 0 ||
        !font.is_shown(i)) {
      continue;
    }
    const auto id = static_cast<uint16_t>(i);
    source.glyphs.emplace(glyph.source, id);
    for (const char32_t c : glyph.code_points) {
      source.characters.emplace(c, id);
    }
  }
  return source;
}

// Composition and the kerning of the font alone.
Bytes composing(const FontFile& file, const RomContent& content) {
  ShapeSource source = {file, {}, {}, content.glyph_of};
  const auto space = content.glyph_of.find(U' ');
  if (space != content.glyph_of.end() && !content.kerning.empty()) {
    source.kerns_space = content.kerning.left_class[space->second] +
                             content.kerning.right_class[space->second] !=
                         0;
  }
  Bytes section = composing_section(source);
  if (!section.empty()) {
    set_shape_steps(section, kDearSteps);
  }
  return section;
}

// Tables as they are, and the glyphs of the file that the font's are.
Bytes keep_layout(const FontFile& file, const SourceFont& font) {
  constexpr hb_tag_t kKept[] = {HB_TAG('G', 'S', 'U', 'B'),
                                HB_TAG('G', 'P', 'O', 'S'),
                                HB_TAG('G', 'D', 'E', 'F')};
  const auto source_of = [&](size_t glyph) {
    const SourceGlyph& one = font.glyphs[glyph];
    const bool is_own = one.face == 0 && one.master.empty();
    return static_cast<uint16_t>(is_own && font.is_shown(glyph) ? one.source
                                                                : 0);
  };
  std::vector<uint16_t> order(font.glyphs.size());
  std::iota(order.begin(), order.end(), uint16_t{0});
  std::stable_sort(order.begin(), order.end(), [&](uint16_t a, uint16_t b) {
    return source_of(a) < source_of(b);
  });
  Bytes tables;
  Bytes out;
  put_u16(out, static_cast<unsigned>(order.size()));
  put_u16(out, 0);
  for (const hb_tag_t tag : kKept) {
    const Bytes table = file.table(tag);
    put_u32(out, tag);
    put_u32(out, static_cast<uint32_t>(format::kept_layout::kSources +
                                       4 * order.size() + tables.size()));
    put_u32(out, static_cast<uint32_t>(table.size()));
    tables.insert(tables.end(), table.begin(), table.end());
    tables.resize((tables.size() + 3) & ~size_t{3});
  }
  for (size_t i = 0; i < order.size(); ++i) {
    put_u16(out, source_of(i));
    put_u16(out, order[i]);
  }
  out.insert(out.end(), tables.begin(), tables.end());
  return out;
}

// Words of the texts that the request names.
std::vector<std::u32string> words_of(const GenerateRequest& request) {
  std::set<std::u32string> words;
  std::u32string word;
  const auto add = [&](char32_t c) {
    if (c > ' ') {
      word += c;
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  };
  for (const std::filesystem::path& file : request.text_files) {
    const std::string content = read_text_file(file, "--text-file");
    std::string_view rest = content;
    while (!rest.empty()) {
      const auto c = read_utf8(rest);
      if (!c) {
        break;
      }
      add(*c);
    }
    add(' ');
  }
  for (const std::filesystem::path& file : sources_of(request)) {
    for (const LanguageText& shown : shown_texts(file, "--strings-from")) {
      for (const LocatedCharacter& found : shown.text) {
        add(found.value);
      }
      add(' ');
    }
  }
  return {words.begin(), words.end()};
}

}  // namespace

std::vector<uint8_t> write_shaped_font(const GenerateRequest& request,
                                       const SourceFont& font,
                                       RomContent& content,
                                       PartBytes& parts,
                                       Warnings& warnings) {
  const bool composes = request.compose && !request.strike_only &&
                        request.target.coding == Coding::outline &&
                        !request.font.empty() && !is_bitmap_font(request.font);
  if (request.shapes.empty() && !composes && !request.keep_layout) {
    return write_rom_font(content, parts);
  }
  const FontFile file(request.font, request.face.value_or(0), request.axes,
                      request.instance);
  if (request.keep_layout) {
    content.kept_layout = keep_layout(file, font);
  }
  if (request.shapes.empty()) {
    if (composes) {
      content.shaping = composing(file, content);
    }
    return write_rom_font(content, parts);
  }
  const ShapeSource source = shape_source(file, request, font);
  content.shaping = shape_section(source);
  if (content.shaping.empty()) {
    throw Error(file.file_name() + ": has no rules of --shape " +
                request.shapes +
                " for the characters that are asked for; ask for those of the "
                "script with --chars, such as 0x621-0x652 for arab, or leave "
                "--shape out");
  }
  const unsigned steps =
      check_shaping(source, write_rom_font(content, parts), words_of(request));
  // Words that were not tried may take more.
  set_shape_steps(content.shaping,
                  std::min(4 * steps, unsigned{format::shaping::kMaxSteps}));
  if (steps > kDearSteps) {
    warnings.push_back({Warning::Kind::shaping_dear,
                        file.file_name() + ": --shape " + request.shapes +
                            " takes up to " + std::to_string(steps) +
                            " steps a character, more than drawing it, and " +
                            std::to_string(content.shaping.size()) +
                            " bytes; a plainer face takes less"});
  }
  return write_rom_font(content, parts);
}

}  // namespace inkcell::gen
