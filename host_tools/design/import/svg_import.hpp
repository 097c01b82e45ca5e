// Imports SVG drawings as outlines.
#pragma once

#include <filesystem>

#include "fit/vectors.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// The position of a drawing's glyph.
struct DrawingPlace {
  double px_per_em = 1024;  // user units that an em is wide
  Point origin;             // the glyph's, in user units, y down
};

/// The drawing of an SVG file in one colour, in u, y up, by gen::SvgDrawing:
/// filled by the winding number, ink on the left. Throws Error that names the
/// file.
gen::Outline read_svg(const std::filesystem::path& file,
                      const DrawingPlace& place);

}  // namespace inkcell::design
