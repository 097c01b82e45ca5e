// The functions of pens.lua, which every script has.
#pragma once

namespace inkcell::design {

/// The text of pens.lua; the build makes it.
extern const char* const kPensScript;

}  // namespace inkcell::design
