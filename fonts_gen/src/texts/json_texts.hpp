// Translations in JSON: ARB of Flutter, and plain files.
#pragma once

#include <string>
#include <string_view>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// What the strings of a JSON file show, however deep they are, without names
/// of members. `is_arb`: members that begin with @ are not shown; @@locale is
/// the language that is returned, else nothing is. Throws Error.
std::string read_json_file(std::string_view content,
                           const std::string& file,
                           bool is_arb,
                           LocatedText& out);

}  // namespace inkcell::gen
