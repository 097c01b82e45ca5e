// Outlines from elsewhere as the contours of a glyph.
#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The commands that make `outline` [u] all contours of the default layer's
/// glyph: set_contours, and add_glyph before it if there is no such glyph; its
/// advance is then the right edge of the outline and as much room as there is
/// at the left. Coordinates are rounded to 1/64 font unit.
std::vector<Value> commands_for_outline(const Project& project,
                                        const std::string& glyph,
                                        const gen::Outline& outline);

}  // namespace inkcell::design
