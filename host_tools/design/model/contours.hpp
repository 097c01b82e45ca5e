// Contours of points: in commands, as curves of the generator, through
// components.
#pragma once

#include <string>
#include <vector>

#include "model/glyph.hpp"
#include "model/project.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

/// Points as commands say them: [x, y, type] or [x, y, type, "smooth"]; the
/// type may be left out of a line. Throws Error.
PointContour parse_contour(const Value& points);
Value contour_value(const PointContour& contour);

/// Throws Error unless off-curve points belong to a curve: `move` first only,
/// no off-curve point before a line or at the end of an open contour, at most
/// two before a cubic.
void check_contour(const PointContour& contour);

/// The same curve in the opposite direction, beginning at the same point.
PointContour reversed(const PointContour& contour);

/// The closed contours as segments, `scale` times as large; open contours
/// enclose nothing and are left out. Implied points between off-curve points of
/// a `qcurve` are found; a cubic with one off-curve point is a quadratic.
gen::Contour to_segments(const PointContour& contour, double scale);

/// The contour whose segments these are, divided by `scale`, coordinates as
/// they come out. The on-curve points are smooth where the direction turns by
/// less than a degree.
PointContour from_segments(const gen::Contour& contour, double scale);

/// All contours of an outline [u] in font units, rounded to 1/64 of one.
std::vector<PointContour> contours_of(const Project& project,
                                      const gen::Outline& outline);

/// Whether `from` is `target` or has it as a component, at any depth.
bool reaches(const Project& project,
             size_t layer,
             const std::string& from,
             const std::string& target);

/// Appends the contours that a component stands for. Throws Error that names a
/// component that does not exist.
void append_component(const Project& project,
                      size_t layer,
                      const ComponentUse& use,
                      std::vector<PointContour>& contours);

/// All of a glyph in u, components in place. Throws Error.
gen::Outline outline_of(const Project& project,
                        const Glyph& glyph,
                        size_t layer = 0);

}  // namespace inkcell::design
