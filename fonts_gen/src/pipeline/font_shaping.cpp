#include "pipeline/font_shaping.hpp"

#include <algorithm>

#include "inkcell/format/rom.hpp"
#include "shaping/shape_check.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen {
namespace {

// A script above this is told: its text costs more than drawing it.
constexpr unsigned kDearSteps = 64;

ShapeSource shape_source(const FontFile& file,
                         const GenerateRequest& request,
                         const SourceFont& font) {
  ShapeSource source = {file,
                        shape_plans(file, parse_shape_scripts(request.shapes)),
                        {{0, 0}},
                        {},
                        font.glyphs.size()};
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
  if (request.shapes.empty()) {
    return write_rom_font(content, parts);
  }
  const FontFile file(request.font, request.face.value_or(0), request.axes,
                      request.instance);
  const ShapeSource source = shape_source(file, request, font);
  content.shaping = shape_section(source);
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
