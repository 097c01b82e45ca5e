// Texts that the device will draw unshaped.
#pragma once

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Warns of each script in the texts of `request` that needs shaping, once,
/// with the first file and line, unless the font shapes it on the device.
/// Strings that are shaped are no such texts, and lists of characters are none.
void tell_of_unshaped(const GenerateRequest& request, Warnings& warnings);

}  // namespace inkcell::gen
