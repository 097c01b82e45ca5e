// Text that is drawn wrongly unless it is shaped.
#pragma once

#include <hb.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace inkcell::gen {

/// Whether a character is right only in shaped text: a letter that joins its
/// neighbours (Arabic, Syriac, N'Ko, Mongolian, ...), a mark that is placed at,
/// reordered around or merged with a letter (vowels and viramas of Indic
/// scripts, Thai, Hebrew points, combining diacritics), a conjoining jamo.
/// Letters that stand side by side need none, even of those scripts.
bool needs_shaping(char32_t code_point);

/// A script of a text, and where the text first needs shaping for it.
struct UnshapedScript {
  hb_script_t script = HB_SCRIPT_COMMON;
  std::string name;  // "Arabic"
  size_t at = 0;     // index of the character
};

/// The scripts of a text that need shaping, in the order of the text. A mark
/// belongs to the script of the letters before it.
std::vector<UnshapedScript> unshaped_scripts(std::u32string_view text);

/// What to tell people of a text that is drawn unshaped: what, from which
/// character on, and the remedy.
std::string unshaped_message(const UnshapedScript& script,
                             std::u32string_view text);

}  // namespace inkcell::gen
