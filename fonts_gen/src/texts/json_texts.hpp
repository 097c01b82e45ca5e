// Translations in JSON.
#pragma once

#include <string>
#include <string_view>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// What the strings of a JSON file show, however deep they are, without names
/// of members. Throws Error.
void read_json_file(std::string_view content,
                    const std::string& file,
                    LocatedText& out);

}  // namespace inkcell::gen
