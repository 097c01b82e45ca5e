// Contours as curves: where a pointer or a line meets them, and cuts.
#pragma once

#include <optional>
#include <vector>

#include "model/glyph.hpp"
#include "shape/outline.hpp"

namespace inkcell::design::editor {

using gen::Point;

/// The curves of a contour, in font units. Those of an open one are not closed.
std::vector<gen::Segment> segments_of(const PointContour& contour);

/// Whether a line is almost, but not quite, horizontal or vertical.
bool is_nearly_level(Point a, Point b);

Point point_at(const gen::Segment& segment, double t);

/// Both parts of `segment`, divided at `t`.
std::pair<gen::Segment, gen::Segment> split(const gen::Segment& segment,
                                            double t);

/// A place on a contour.
struct OnCurve {
  size_t contour = 0;
  size_t segment = 0;
  double t = 0;
  Point at;
};

/// The place of `glyph` next to `at`, if one is within `reach`.
std::optional<OnCurve> nearest_on_curve(const Glyph& glyph,
                                        Point at,
                                        double reach);

/// Where the line from `a` to `b` crosses contours, from `a` on. Neighbours in
/// the result are the ends of what the line passes through.
std::vector<OnCurve> crossings(const std::vector<PointContour>& contours,
                               Point a,
                               Point b);

/// `contour` with a point more, which does not change its shape; rounded.
PointContour with_point(const PointContour& contour, const OnCurve& place);

/// What the straight cut from `a` to `b` makes of closed contours; rounded.
/// `contours` if the line passes through nothing.
std::vector<PointContour> cut_contours(
    const std::vector<PointContour>& contours, Point a, Point b);

}  // namespace inkcell::design::editor
