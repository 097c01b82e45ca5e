// Imports outlines as the contours of a glyph.
#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The commands that set the contours of the default layer's glyph to `outline`
/// [u]: set_contours, after add_glyph if there is no such glyph. The advance of
/// a new glyph makes both side bearings equal. Coordinates are rounded to 1/64
/// font unit.
std::vector<Value> commands_for_outline(const Project& project,
                                        const std::string& glyph,
                                        const gen::Outline& outline);

}  // namespace inkcell::design
