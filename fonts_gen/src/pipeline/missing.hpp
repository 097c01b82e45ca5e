// Characters that were asked for and are not in the font.
#pragma once

#include <string>
#include <vector>

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Throws Error that names each of `missing`, up to ten, with the file and the
/// line, or the option, that asks for it, and what can be done. `font` is the
/// name of the font's file.
[[noreturn]] void refuse_missing(const GenerateRequest& request,
                                 const std::string& font,
                                 const std::vector<char32_t>& missing);

}  // namespace inkcell::gen
