// Parts of a glyph's border that run along an axis.
#pragma once

#include <vector>

#include "hints/border.hpp"

namespace inkcell::gen {

/// An edge that can be placed on the pixel grid. [u]
struct StrokeEdge {
  double position = 0;
  bool ink_beyond = false;  // ink lies at larger positions, else at smaller
  bool is_round = false;    // the end of a bend
  double lean = 0;          // of a slanted line: the rise from end to end
  Intervals pieces;         // along the other axis

  double length() const { return total_length(pieces); }
};

/// Edges with positions on `axis`, ascending: runs of chords that are nearly
/// parallel to the edge. Parts on the same side at nearly the same position
/// form one edge.
std::vector<StrokeEdge> find_edges(const Border& border, Axis axis);

/// Long slanted runs that are flattest in the middle: the edges of the spine of
/// an s.
std::vector<StrokeEdge> find_spine_edges(const Border& border, Axis axis);

}  // namespace inkcell::gen
