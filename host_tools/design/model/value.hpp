// Data with a structure that other programs define: libraries, font
// information, commands.
#pragma once

#include <nlohmann/json.hpp>

namespace inkcell::design {

/// A tree of dictionaries, arrays, strings and numbers. Dictionaries are sorted
/// by key, so equal data gives equal bytes. Data elements of a property list
/// are binary; its dates are binary of the subtype kDateSubtype.
using Value = nlohmann::json;

inline constexpr uint8_t kDateSubtype = 1;

}  // namespace inkcell::design
