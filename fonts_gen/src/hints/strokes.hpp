// Pairs of edges with ink between them: bars and stems.
#pragma once

#include <vector>

#include "hints/edges.hpp"

namespace inkcell::gen {

/// A horizontal bar (positions on the y axis) or a vertical stem. [u]
struct Stroke {
  enum class Kind { plain, serif, spine };

  double low = 0;
  double high = 0;
  Kind kind = Kind::plain;
  bool is_round = false;  // both edges are ends of bends
  double lean = 0;        // of a diagonal, whose edges lean to one side
  double facing = 0;      // length along which both edges face each other
  Intervals low_pieces;   // of the edge at `low`, along the other axis
  Intervals high_pieces;

  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// What edges become.
struct Strokes {
  std::vector<Stroke> strokes;   // ascending
  std::vector<StrokeEdge> lone;  // edges without a partner, ascending
};

/// Pairs `edges`, the nearest first. Each is part of one stroke at most.
Strokes pair_edges(const std::vector<StrokeEdge>& edges);

/// Horizontal bars, and the spine of an s among them.
Strokes find_bars(const Border& border);

/// Vertical stems. Diagonals are none, nor are the straight ends of serifs and
/// bars, which are short.
std::vector<Stroke> find_stems(const Border& border);

}  // namespace inkcell::gen
