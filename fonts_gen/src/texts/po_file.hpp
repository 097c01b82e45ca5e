// Files of gettext: .po and .pot.
#pragma once

#include <string>
#include <string_view>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// What a .po file shows, and the language that its header says, or nothing.
/// Messages without a translation, or with one that is marked fuzzy, are shown
/// as msgid, as gettext does. Throws Error.
std::string read_po_file(std::string_view content,
                         const std::string& file,
                         LocatedText& out);

}  // namespace inkcell::gen
