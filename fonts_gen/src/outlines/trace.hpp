// A contour for the refit: samples, and candidates for points.
#pragma once

#include <cstddef>
#include <vector>

#include "outlines/refit.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// The care that RefitOptions asks for at a place.
enum class Care : uint8_t { none, careful, exact };

/// A joint of the source, a turning point of a curve, or a point within a long
/// curve: a candidate for a point on the curve of the result.
struct Node {
  size_t at = 0;  // index into Trace::samples
  Point on_grid;  // rounded
  Point before;   // unit tangents of the source
  Point after;
  /// A turn so sharp that the result must have a corner here.
  bool hard = false;
  /// The contour turns back in x or in y here: that coordinate must not move.
  bool extreme_x = false;
  bool extreme_y = false;
  Care care = Care::none;
};

/// The part between a node and the next.
struct Stretch {
  enum class Kind : uint8_t { line, quadratic, other };

  Kind kind = Kind::line;
  Point control;  // of a quadratic
  Care care = Care::none;
};

/// A closed contour in grid units. stretches[i] leads from nodes[i] to the next
/// node, the last one back to the first. Node 0 is the sharpest turn. The last
/// sample repeats the first.
struct Trace {
  std::vector<Point> samples;
  std::vector<Node> nodes;  // at ascending; nodes[0].at = 0
  std::vector<Stretch> stretches;
};

/// Lengths of a refit in grid units.
struct RefitScale {
  explicit RefitScale(const RefitOptions& options);

  double grid_per_u;
  double tolerance;
  double careful_tolerance;
  /// The largest distance of chords from their curve.
  double chord_bound;
  /// The largest distance of an extreme of the result from that of the source.
  double extreme_tolerance;
  double reach;  // kCareRadius_u
};

/// `contour` is closed and filled on its left (see unite()).
Trace trace(const Contour& contour,
            const RefitOptions& options,
            const RefitScale& scale);

}  // namespace inkcell::gen
