// Converts SVG's fill rules to the non-zero rule of glyphs.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// Corners of a closed polygon.
using Corners = std::vector<Point>;

/// The area that `contours` fill by `rule`, with ink on the left. No winding
/// number is below 0, so further areas can be added. Curves stay curves if
/// contours do not cross, or if they cross with the rule nonzero and one
/// direction; otherwise they become chords within kFlatteningBound. [u]
///
/// Throws GeometryError.
Outline filled_area(const Outline& contours, FillRule rule);

/// The union of polygons of any direction, with ink on the left. [u]
Outline united_area(const std::vector<Corners>& polygons);

/// Whether two outlines fill the same area under the rule nonzero. Ignores
/// differences that are too narrow for a disc of radius `slack`. [u]
///
/// Throws GeometryError.
bool fill_alike(const Outline& a, const Outline& b, double slack);

}  // namespace inkcell::gen
