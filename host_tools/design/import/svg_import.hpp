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

/// What an SVG file draws in one colour, in u, y up, by gen::SvgDrawing: filled
/// by the winding number, ink on the left. Throws Error that names the file.
gen::Outline read_svg(const std::filesystem::path& file,
                      const DrawingPlace& place);

}  // namespace inkcell::design
