// Drawings of other programs as outlines.
#pragma once

#include <filesystem>

#include "fit/vectors.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// Where a drawing's glyph lies.
struct DrawingPlace {
  double px_per_em = 1024;  // user units that an em is wide
  Point origin;             // the glyph's, in user units, y down
};

/// The filled paths of an SVG file in u, y up, with the transforms of paths and
/// groups. What is filled stays so, by the winding number, filled on the left;
/// contours that are filled by fill-rule evenodd must not cross each other.
///
/// Throws Error that names the file: for elements that are drawn and are no
/// path, for path data that is wrong, and if there is no filled path.
gen::Outline read_svg(const std::filesystem::path& file,
                      const DrawingPlace& place);

}  // namespace inkcell::design
