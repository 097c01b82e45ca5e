// The path data of SVG.
#pragma once

#include <string_view>

#include "shape/outline.hpp"

namespace inkcell::design {

/// The contours of the attribute `d` of a path (SVG 1.1, section 8.3), in its
/// own coordinates, y down. Arcs become cubics of at most 45 degrees, which are
/// off by 1/200000 of their radius. Each contour is closed by a line, if need
/// be.
///
/// Throws Error that says where the data is wrong.
gen::Outline parse_svg_path(std::string_view data);

}  // namespace inkcell::design
