// Space beside the ink of glyphs.
#pragma once

#include <optional>

#include "model/project.hpp"

namespace inkcell::design {

/// Left of the ink, from the origin, and right of it, to the advance. [font
/// units]
struct Bearings {
  double left = 0;
  double right = 0;
};

/// Nothing if the glyph has no ink.
std::optional<Bearings> bearings_of(const Project& project,
                                    const Glyph& glyph,
                                    size_t layer = 0);

}  // namespace inkcell::design
