// Strokes in the editor: points of a path and a nib.
#pragma once

#include <optional>
#include <vector>

#include "fit/curve_fitter.hpp"
#include "model/value.hpp"
#include "stroke/sweep.hpp"

namespace inkcell::design {

/// A point of a path, and changes of the nib there.
struct StrokePoint {
  Point at;  // [u]
  std::optional<double> width;
  std::optional<double> height;
  std::optional<double> angle;  // [radians]
  bool is_corner = false;       // of a smooth stroke
};

struct Stroke {
  Nib nib;
  bool is_smooth = false;  // goes through all points: smooth_path()
  std::vector<StrokePoint> points;
};

/// A stroke as commands have it, with lengths times `scale`. Throws Error.
Stroke parse_stroke(const Value& value, double scale);

/// The nib at every point: what points set, interpolated along the path.
std::vector<Nib> nibs_of(const Stroke& stroke);

/// Whether a path has a corner at `at`: it turns by more than 60 degrees.
bool turns_sharply(const Point& before, const Point& at, const Point& after);

/// The path through the points. If the stroke is not smooth_path(): smoothly
/// joined cubics (Schneider) within `tolerance` of them [u], with corners where
/// it turns_sharply().
NibPath fit_path(const Stroke& stroke, double tolerance);

/// The area of a stroke, as polygons within kSweepBound_u. Along a smooth
/// stroke nibs change without kinks.
std::vector<std::vector<Point>> polygons_of(const Stroke& stroke,
                                            double path_tolerance);

/// Polygons as contours of lines.
gen::Outline outline_of_polygons(
    const std::vector<std::vector<Point>>& polygons);

/// Polygons as the fewest lines and cubics within `tolerance`. [u]
gen::Outline fit_polygons(const std::vector<std::vector<Point>>& polygons,
                          double tolerance);

}  // namespace inkcell::design
