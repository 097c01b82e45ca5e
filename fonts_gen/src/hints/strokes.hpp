// Pairs of edges with ink between them: bars and stems.
#pragma once

#include <vector>

#include "hints/edges.hpp"

namespace inkcell::gen {

/// Wider ones are no strokes. [u]
constexpr double kThickestStroke = 165;

/// A horizontal bar (positions on the y axis) or a vertical stem. [u]
struct Stroke {
  enum class Kind { plain, serif, spine };

  double low = 0;
  double high = 0;
  Kind kind = Kind::plain;
  bool is_round = false;  // both edges are ends of bends
  double lean = 0;        // of a diagonal: its edges lean to one side
  double facing = 0;      // length of the overlap of both edges
  Intervals low_pieces;   // of the edge at `low`, along the other axis
  Intervals high_pieces;

  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// Paired and unpaired edges.
struct Strokes {
  std::vector<Stroke> strokes;   // ascending
  std::vector<StrokeEdge> lone;  // edges without a partner, ascending
};

/// Pairs `edges`, the nearest first. An edge belongs to at most one stroke.
Strokes pair_edges(const std::vector<StrokeEdge>& edges);

/// Finds horizontal bars, including the spine of an s.
Strokes find_bars(const Border& border);

/// Finds vertical stems, without diagonals and the short straight ends of
/// serifs and bars.
std::vector<Stroke> find_stems(const Border& border);

}  // namespace inkcell::gen
