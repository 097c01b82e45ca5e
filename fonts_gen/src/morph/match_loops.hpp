// Two loops piece by piece: which part of one becomes which part of the other.
#pragma once

#include <optional>
#include <vector>

#include "morph/morph_loop.hpp"

namespace inkcell::gen {

/// A move as far as this costs as much as vanishing.
inline constexpr double kUsualFar_u = 250;

struct MatchOptions {
  int parts = 4;         // of a long edge, see stops_of()
  bool by_edges = true;  // loops whose edges run alike, see match_loops()
  double far_u = kUsualFar_u;
  double turning = 0;  // price of an edge that grows askew out of a point
  /// Stops of both loops where pieces shall not begin, with their price.
  struct Penalty {
    int stop[2];
    double cost;
  };
  std::vector<Penalty> penalties;
};

struct LoopMatch {
  double cost = 0;
  MorphContour contour;
};

/// The pieces with the least sum of costs (dynamic programming over the stops
/// of both loops). A piece is dear if its parts are far apart, or differ in
/// length or direction. Loops whose edges run alike, as those of two boxes, are
/// matched edge by edge, however far these are, if the options say so.
LoopMatch match_loops(const Loop& a,
                      const Loop& b,
                      const MatchOptions& options);

/// Edge by edge. None: not all of them run alike.
std::optional<LoopMatch> match_edges(const Loop& a,
                                     const Loop& b,
                                     double far_u);

/// Paths instead of loops: the ends of one become those of the other.
LoopMatch match_paths(const Loop& a,
                      const Loop& b,
                      const MatchOptions& options);

/// The side of a piece along an edge, from one eighth to another.
MorphSide side_to(const LoopEdge& edge, int from, int to);

/// The cost of a piece, without penalties.
double piece_cost(const Point (&a)[3], const Point (&b)[3], double far_u);

}  // namespace inkcell::gen
