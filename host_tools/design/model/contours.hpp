// Contours of points: parsing, conversion to curves of the generator,
// components.
#pragma once

#include <string>
#include <vector>

#include "model/glyph.hpp"
#include "model/project.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// Parses points of commands: [x, y, type] or [x, y, type, "smooth"]; the
/// default type is a line. Throws Error.
PointContour parse_contour(const Value& points);
Value contour_value(const PointContour& contour);

/// Throws Error for stray off-curve points: `move` must be first, no off-curve
/// point before a line or at the end of an open contour, at most two before a
/// cubic.
void check_contour(const PointContour& contour);

/// The same curve in the opposite direction, with the same first point.
PointContour reversed(const PointContour& contour);

/// The closed contours as segments, scaled by `scale`; open contours enclose
/// nothing and are left out. Implied points of a `qcurve` are added; a cubic
/// with one off-curve point is a quadratic.
gen::Contour to_segments(const PointContour& contour, double scale);

/// The contour of these segments, divided by `scale`, not rounded. On-curve
/// points are smooth where the direction turns by less than a degree; those
/// that quadratics imply are left out.
PointContour from_segments(const gen::Contour& contour, double scale);

/// All contours of an outline [u] in font units, rounded to multiples of
/// `grid`; 0: not rounded.
std::vector<PointContour> contours_of(const Project& project,
                                      const gen::Outline& outline,
                                      double grid = 1);

/// Whether contours around ink are clockwise, as in TrueType: the largest of
/// the glyph says, or that of another glyph if it has none.
bool is_clockwise(const Project& project, const Glyph& glyph);

/// Contours that are counter-clockwise around ink, in the direction of the
/// glyph's.
std::vector<PointContour> in_direction_of(const Project& project,
                                          const Glyph& glyph,
                                          std::vector<PointContour> contours);

/// Twice the enclosed area, counter-clockwise. [font units^2]
double twice_area(const PointContour& contour);

/// Whether `from` is `target` or has it as a component, at any depth.
bool reaches(const Project& project,
             size_t layer,
             const std::string& from,
             const std::string& target);

/// Appends the contours of a component. Throws Error that names a component
/// that does not exist.
void append_component(const Project& project,
                      size_t layer,
                      const ComponentUse& use,
                      std::vector<PointContour>& contours);

/// The outline of a glyph in u, with components resolved. Throws Error.
gen::Outline outline_of(const Project& project,
                        const Glyph& glyph,
                        size_t layer = 0);

}  // namespace inkcell::design
