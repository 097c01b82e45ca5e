#include "editor/glyph_set.hpp"

#include <cmath>
#include <cstdio>

#include "editor/edits.hpp"
#include "model/error.hpp"
#include "model/glyph_names.hpp"
#include "rom_file.hpp"
#include "source/char_set.hpp"

namespace inkcell::design::editor {
namespace {

// Advances of new glyphs. [em]
constexpr double kAdvance = 0.6;
constexpr double kSpace = 0.25;

// Ranges, such as A-Z,U+B0, or else the characters of the text itself.
gen::CharSet characters_of(const std::string& text) {
  gen::CharSet characters;
  try {
    gen::add_ranges(text, characters);
  } catch (const std::exception&) {
    const std::vector<char32_t> all = tools::from_utf8(text);
    characters = {all.begin(), all.end()};
  }
  return characters;
}

bool is_name(const std::string& text) {
  const size_t stop = text.find('.');
  return text.size() > 1 &&
         (text[0] == '_' || character_of_name(text) ||
          (stop != std::string::npos && stop + 1 < text.size()));
}

}  // namespace

Value add_glyphs(const Project& project, const std::string& text) {
  gen::CharSet known;
  for (const auto& [name, glyph] : project.front().glyphs) {
    known.insert(glyph->unicodes.begin(), glyph->unicodes.end());
  }
  Value order = glyph_order(project);
  std::vector<Value> commands;
  const auto add = [&](const std::string& name, double part) {
    if (project.find(name) == nullptr) {
      for (const Layer& master : project.layers) {
        commands.push_back(
            {{"do", "add_glyph"},
             {"glyph", name},
             {"layer", master.name},
             {"width", std::round(part * project.units_per_em())}});
      }
      order.push_back(name);
    }
  };
  if (is_name(text)) {
    add(text, kAdvance);
  } else {
    for (const char32_t c : characters_of(text)) {
      if (known.count(c) == 0) {
        add(name_of_character(c), c == U' ' || c == 0xa0 ? kSpace : kAdvance);
      }
    }
  }
  if (commands.empty()) {
    throw Error("'" + text +
                "': the font has these glyphs; write characters (Hano2!), "
                "ranges (A-Z,U+B0) or "
                "a name (exclam, _stem)");
  }
  commands.push_back(
      {{"do", "set_lib"}, {"key", "public.glyphOrder"}, {"value", order}});
  return batch(std::move(commands));
}

Value set_characters(const std::string& text) {
  Value unicodes = Value::array();
  for (const char32_t c : text.empty() ? gen::CharSet() : characters_of(text)) {
    unicodes.push_back(static_cast<uint32_t>(c));
  }
  return {{"do", "set_unicodes"}, {"unicodes", unicodes}};
}

Value rename_to(const std::string& name) {
  return {{"do", "rename_glyph"}, {"to", name}};
}

std::string character_list(const Glyph& glyph) {
  std::string list;
  for (const char32_t c : glyph.unicodes) {
    char buffer[16];
    std::snprintf(buffer, sizeof buffer, "U+%04X", static_cast<unsigned>(c));
    list += (list.empty() ? "" : ",") + std::string(buffer);
  }
  return list;
}

}  // namespace inkcell::design::editor
