// A contour as the refit sees it: samples, and the places for points.
#pragma once

#include <cstddef>
#include <vector>

#include "outlines/refit.hpp"
#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// How much care a place in RefitOptions asks for.
enum class Care : uint8_t { none, careful, exact };

/// A joint of the source, a turning point of a curve, or a place within a long
/// curve: where the result may have a point on the curve.
struct Node {
  size_t at = 0;  // index into Trace::samples
  Point on_grid;  // rounded
  Point before;   // unit tangents of the source
  Point after;
  /// The source turns by so much that no curve can go round.
  bool hard = false;
  /// The contour turns back here in x or in y: that coordinate must not move.
  bool extreme_x = false;
  bool extreme_y = false;
  Care care = Care::none;
};

/// What lies between a node and the next.
struct Stretch {
  enum class Kind : uint8_t { line, quadratic, other };

  Kind kind = Kind::line;
  Point control;  // of a quadratic
  Care care = Care::none;
};

/// A closed contour in grid units. stretches[i] leads from nodes[i] to the
/// next node, the last one to the first, which is where the contour turns most.
/// Samples are closed as well: the last is the first.
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
  /// Curves are chords within this.
  double chord_bound;
  /// How far an extreme of the result may be from that of the source.
  double extreme_tolerance;
  double reach;  // kCareRadius_u
};

/// `contour` is closed and filled on its left (see unite()).
Trace trace(const Contour& contour,
            const RefitOptions& options,
            const RefitScale& scale);

}  // namespace gen
}  // namespace inkcell
