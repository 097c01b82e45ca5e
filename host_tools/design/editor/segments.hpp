// Contours as curves: nearest places, crossings and cuts.
#pragma once

#include <optional>
#include <vector>

#include "model/glyph.hpp"
#include "shape/outline.hpp"

namespace inkcell::design::editor {

using gen::Point;

/// The curves of a contour, in font units. An open contour is not closed.
std::vector<gen::Segment> segments_of(const PointContour& contour);

/// Whether a line is almost, but not quite, horizontal or vertical.
bool is_nearly_level(Point a, Point b);

Point point_at(const gen::Segment& segment, double t);

/// Both parts of `segment`, split at `t`.
std::pair<gen::Segment, gen::Segment> split(const gen::Segment& segment,
                                            double t);

/// A place on a contour.
struct OnCurve {
  size_t contour = 0;
  size_t segment = 0;
  double t = 0;
  Point at;
};

/// The place on `glyph` nearest to `at`, if one is within `reach`.
std::optional<OnCurve> nearest_on_curve(const Glyph& glyph,
                                        Point at,
                                        double reach);

/// The crossings of the line from `a` to `b` with contours, from `a` on. Each
/// pair of neighbours in the result encloses what the line passes through.
std::vector<OnCurve> crossings(const std::vector<PointContour>& contours,
                               Point a,
                               Point b);

/// `contour` with an added point that does not change its shape; rounded.
PointContour with_point(const PointContour& contour, const OnCurve& place);

/// Closed contours after a straight cut from `a` to `b`; rounded. `contours` if
/// the line crosses nothing.
std::vector<PointContour> cut_contours(
    const std::vector<PointContour>& contours, Point a, Point b);

/// Whether a place is inside closed contours, by the even-odd rule.
bool is_inside(const std::vector<PointContour>& contours, Point at);

}  // namespace inkcell::design::editor
