// Strokes in the editor: points of a path and a nib.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fit/curve_fitter.hpp"
#include "stroke/sweep.hpp"

namespace inkcell::design {

/// A point of a path, and changes of the nib there.
struct StrokePoint {
  Point at;  // [u]
  std::optional<double> width;
  std::optional<double> height;
  std::optional<double> angle;  // [radians]
};

struct Stroke {
  Nib nib;
  std::vector<StrokePoint> points;
};

/// Reads strokes: "x y [width [height [angle]]]" on each line, in u and
/// degrees, "-" for no change. An empty line ends a stroke, # begins a comment.
/// Throws Error that names file and line.
std::vector<Stroke> read_strokes(const std::filesystem::path& file,
                                 const Nib& nib);

/// The path through the points: smoothly joined cubics (Schneider) within
/// `tolerance` of them [u], with corners where the path turns by more than 60
/// degrees.
NibPath fit_path(const Stroke& stroke, double tolerance);

/// The area of a stroke, as polygons within kSweepBound_u.
std::vector<std::vector<Point>> polygons_of(const Stroke& stroke,
                                            double path_tolerance);

/// Polygons as contours of lines.
gen::Outline outline_of_polygons(
    const std::vector<std::vector<Point>>& polygons);

/// Polygons as the fewest lines and cubics within `tolerance`. [u]
gen::Outline fit_polygons(const std::vector<std::vector<Point>>& polygons,
                          double tolerance);

}  // namespace inkcell::design
