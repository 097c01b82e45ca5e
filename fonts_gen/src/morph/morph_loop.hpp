// Closed loops through an outline, along its segments and across its strokes.
#pragma once

#include <vector>

#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// A part of a segment, or a line from one contour to another.
struct LoopEdge {
  bool is_jump = false;
  int segment = 0;
  int from = 0;  // [eighths]
  int to = 8;
  MorphStop target;  // of a jump
  Point p[3];        // [u]
};

using Loop = std::vector<LoopEdge>;

/// A line or quadratic as three points. Throws GeometryError for cubics.
LoopEdge whole_edge(const Segment& segment, int number);

/// The contours that have segments, which are numbered through.
std::vector<Loop> loops_of(const Outline& outline);

/// The edge from `from` to `to` eighths of its segment.
LoopEdge part_of(const LoopEdge& edge, int from, int to);

Point point_at(const Point (&p)[3], double t);
double length_of(const Point (&p)[3]);

/// A place on a loop.
struct LoopStop {
  int edge = 0;
  int eighth = 0;
  Point at;
};

/// The beginnings of edges, and `parts` - 1 stops in long ones; 1, 2, 4 or 8.
std::vector<LoopStop> stops_of(const Loop& loop, int parts);

/// A short cut from a stop of one loop to one of another.
struct Bridge {
  LoopStop from;
  LoopStop to;
  double length = 0;
};

/// Bridges from `from` to `to`, at most 1.7 times as long as the shortest.
std::vector<Bridge> bridges_between(const Loop& from, const Loop& to);

/// One loop that goes around `a`, crosses the bridge, goes around `b`, and
/// comes back.
Loop joined(const Loop& a, const Loop& b, const Bridge& bridge);

/// The part of a loop from one stop on to another, closed by a cut.
Loop part_between(const Loop& loop, const LoopStop& from, const LoopStop& to);

/// Positive if the loop runs counter-clockwise.
double area_of(const Loop& loop);
Point centroid_of(const Loop& loop);

}  // namespace inkcell::gen
