// What contours fill by the rules of SVG, for the non-zero rule of glyphs.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// Corners of a closed polygon.
using Corners = std::vector<Point>;

/// The area that `contours` fill by `rule`, with ink on the left: no winding
/// number is below 0, so that further areas can be added. Curves stay curves
/// where contours do not cross, or cross with the rule nonzero and one
/// direction; otherwise they are chords within kFlatteningBound. [u]
///
/// Throws GeometryError.
Outline filled_area(const Outline& contours, FillRule rule);

/// The union of polygons, each of either direction, with ink on the left. [u]
Outline united_area(const std::vector<Corners>& polygons);

/// Whether two outlines fill the same under the rule nonzero, but for places
/// too narrow for a disc with the radius `slack`. [u]
///
/// Throws GeometryError.
bool fill_alike(const Outline& a, const Outline& b, double slack);

}  // namespace inkcell::gen
