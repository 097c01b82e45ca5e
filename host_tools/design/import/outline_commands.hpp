// Imports outlines as the contours of a glyph.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/project.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The treatment of an outline.
struct OutlineUse {
  bool replaces = false;            // the glyph's contours; else it is added
  double grid = 1;                  // of coordinates [font units]; 0: none
  std::optional<char32_t> unicode;  // of a new glyph [what its name says]
};

/// The commands that give the default layer's glyph the contours of `outline`
/// [u], in the direction of its others: set_contours, after add_glyph if there
/// is no such glyph. The advance of a new glyph makes both side bearings equal.
std::vector<Value> commands_for_outline(const Project& project,
                                        const std::string& glyph,
                                        const gen::Outline& outline,
                                        const OutlineUse& use);

}  // namespace inkcell::design
