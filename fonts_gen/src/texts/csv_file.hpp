// Tables of translations: a column a language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// The columns of a CSV file that have the name of a language in the first
/// line, in upper or lower case; the first column holds keys, and others are
/// not read. Cells are separated by commas, semicolons or tabs, whichever the
/// first line has most of, and may stand in quotation marks. Escapes of C are
/// read. Throws Error.
std::vector<LanguageText> read_csv_file(std::string_view content,
                                        const std::string& file);

}  // namespace inkcell::gen
