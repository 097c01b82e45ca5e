// The halves on one side of the axes are matched, and mirrored.
//
// An axis crosses a loop twice: at the beginning of an edge or in the middle of
// one. That edge is cut there, or it is a piece of its own, which mirrors
// itself.
#include "morph/match_mirrored.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Where an axis crosses a loop.
struct Crossing {
  size_t edge = 0;
  bool is_middle = false;  // of the edge, or else at its beginning
  Point at;
};

// An axis of a loop: edge i is the image of edge `sum` - i.
struct Mirror {
  bool is_upright = false;
  double twice = 0;  // where the axis is, twice
  size_t sum = 0;
  Crossing crossings[2];  // the one farther along the axis first

  Point image(const Point& p) const {
    return is_upright ? Point{twice - p.x, p.y} : Point{p.x, twice - p.y};
  }
};

bool is_image(const Loop& loop, const Mirror& mirror) {
  constexpr double kSlack_u = 1.5;  // corners are rounded
  const size_t n = loop.size();
  for (size_t i = 0; i < n; ++i) {
    const LoopEdge& edge = loop[i];
    const LoopEdge& other = loop[(mirror.sum + n - i) % n];
    if (edge.is_jump != other.is_jump || edge.from != 8 - other.to) {
      return false;
    }
    for (size_t k = 0; k < 3; ++k) {
      if (length(mirror.image(edge.p[k]) - other.p[2 - k]) > kSlack_u) {
        return false;
      }
    }
  }
  return true;
}

std::optional<Mirror> mirror_of(const Loop& loop, bool is_upright) {
  const auto across = [&](const Point& p) { return is_upright ? p.x : p.y; };
  const auto along = [&](const Point& p) { return is_upright ? p.y : p.x; };
  double low = kInfinity;
  double high = -kInfinity;
  for (const LoopEdge& edge : loop) {
    for (const Point& p : {edge.p[0], point_at(edge.p, 0.5)}) {
      low = std::min(low, across(p));
      high = std::max(high, across(p));
    }
  }
  Mirror mirror;
  mirror.is_upright = is_upright;
  mirror.twice = low + high;
  const size_t n = loop.size();
  while (mirror.sum < n && !is_image(loop, mirror)) {
    ++mirror.sum;
  }
  if (mirror.sum == n) {
    return std::nullopt;
  }
  size_t count = 0;
  for (size_t i = 0; i < n; ++i) {
    if (2 * i % n == mirror.sum % n) {
      mirror.crossings[count++] = {i, true, point_at(loop[i].p, 0.5)};
    }
    if (2 * i % n == (mirror.sum + 1) % n) {
      mirror.crossings[count++] = {i, false, loop[i].p[0]};
    }
  }
  if (along(mirror.crossings[0].at) < along(mirror.crossings[1].at)) {
    std::swap(mirror.crossings[0], mirror.crossings[1]);
  }
  return mirror;
}

// A half of a loop, from one crossing to the other.
struct Half {
  Loop edges;
  std::vector<size_t> of_loop;  // the numbers of the edges
  bool is_whole[2];             // the edge at a crossing is not in it
};

Half half_of(const Loop& loop, const Mirror& mirror, unsigned whole) {
  Half half;
  const size_t n = loop.size();
  const Crossing& first = mirror.crossings[0];
  const Crossing& last = mirror.crossings[1];
  half.is_whole[0] = (whole & 1) != 0;
  half.is_whole[1] = (whole & 2) != 0;
  const auto add = [&](size_t i, const LoopEdge& edge) {
    half.edges.push_back(edge);
    half.of_loop.push_back(i);
  };
  if (first.is_middle && !half.is_whole[0]) {
    add(first.edge, part_of(loop[first.edge], 4, loop[first.edge].to));
  }
  size_t i = first.is_middle ? (first.edge + 1) % n : first.edge;
  for (; i != last.edge; i = (i + 1) % n) {
    add(i, loop[i]);
  }
  if (last.is_middle && !half.is_whole[1]) {
    add(last.edge, part_of(loop[last.edge], loop[last.edge].from, 4));
  }
  return half;
}

// The ways in which a half may begin and end.
std::vector<Half> halves_of(const Loop& loop, const Mirror& mirror) {
  std::vector<Half> halves;
  for (unsigned whole = 0; whole < 4; ++whole) {
    bool is_possible = true;
    for (unsigned k = 0; k < 2; ++k) {
      const Crossing& crossing = mirror.crossings[k];
      const bool is_whole = (whole >> k & 1) != 0;
      is_possible =
          is_possible &&
          (crossing.is_middle ? is_whole || !loop[crossing.edge].is_jump
                              : !is_whole);
    }
    if (is_possible) {
      halves.push_back(half_of(loop, mirror, whole));
      if (halves.back().edges.empty() || halves.back().edges[0].is_jump) {
        halves.pop_back();
      }
    }
  }
  return halves;
}

// A side of a piece at a crossing: the whole edge, or nothing.
MorphSide side_at(const Loop& loop,
                  const Mirror& mirror,
                  const Half& half,
                  size_t crossing) {
  const Crossing& at = mirror.crossings[crossing];
  if (half.is_whole[crossing]) {
    const LoopEdge& edge = loop[at.edge];
    return side_to(edge, edge.from, edge.to);
  }
  MorphSide none;
  std::fill(std::begin(none.p), std::end(none.p), at.at);
  return none;
}

struct Sides {
  const Loop& loop;
  const Mirror& mirror;
  const Half& half;

  // The image of a side that begins at the stop.
  MorphSide image(const MorphSide& side, const LoopStop& stop) const {
    const size_t n = loop.size();
    const size_t i = half.of_loop[static_cast<size_t>(stop.edge)];
    const LoopEdge& edge = loop[(mirror.sum + n - i) % n];
    if (side.move == MorphMove::jump) {
      return side_to(edge, edge.from, edge.to);
    }
    if (side.move != MorphMove::stay) {
      const int end = side.move == MorphMove::to_end ? 8 : side.eighth;
      return side_to(edge, 8 - end, 8 - stop.eighth);
    }
    MorphSide out;
    std::fill(std::begin(out.p), std::end(out.p), mirror.image(side.p[0]));
    return out;
  }
};

// The half, the piece at its end, the image of the half, and the piece at its
// beginning.
LoopMatch assembled(const Sides (&sides)[2], const MatchOptions& options) {
  LoopMatch match =
      match_paths(sides[0].half.edges, sides[1].half.edges, options);
  MorphContour& contour = match.contour;
  const std::vector<MorphPiece> way = contour.pieces;
  match.cost *= 2;
  std::vector<LoopStop> stops[2];
  for (size_t k = 0; k < 2; ++k) {
    const LoopEdge& first = sides[k].half.edges.front();
    contour.start[k] = {first.segment, first.from};
    stops[k] = stops_of(sides[k].half.edges, options.parts);
  }
  const auto add_at = [&](size_t crossing) {
    if (!sides[0].half.is_whole[crossing] &&
        !sides[1].half.is_whole[crossing]) {
      return;
    }
    MorphPiece piece;
    for (size_t k = 0; k < 2; ++k) {
      piece.side[k] =
          side_at(sides[k].loop, sides[k].mirror, sides[k].half, crossing);
    }
    match.cost += piece_cost(piece.side[0].p, piece.side[1].p, options.far_u);
    contour.pieces.push_back(piece);
  };
  add_at(1);
  for (size_t i = way.size(); i-- > 0;) {
    MorphPiece piece = way[i];
    for (size_t k = 0; k < 2; ++k) {
      // One that stays may be at the end.
      const auto at = static_cast<size_t>(way[i].stop[k]);
      piece.side[k] = sides[k].image(
          way[i].side[k], stops[k][std::min(at, stops[k].size() - 1)]);
    }
    contour.pieces.push_back(piece);
  }
  add_at(0);
  return match;
}

}  // namespace

std::optional<LoopMatch> match_mirrored(const Loop& a,
                                        const Loop& b,
                                        const MatchOptions& options) {
  std::optional<LoopMatch> best;
  for (const bool is_upright : {false, true}) {
    const std::optional<Mirror> first = mirror_of(a, is_upright);
    const std::optional<Mirror> second =
        first ? mirror_of(b, is_upright) : std::nullopt;
    if (!second) {
      continue;
    }
    if (options.by_edges) {
      if (std::optional<LoopMatch> match = match_edges(a, b, options.far_u)) {
        return match;
      }
    }
    const std::vector<Half> others = halves_of(b, *second);
    for (const Half& half : halves_of(a, *first)) {
      for (const Half& other : others) {
        LoopMatch match =
            assembled({{a, *first, half}, {b, *second, other}}, options);
        if (!best || match.cost < best->cost) {
          best = std::move(match);
        }
      }
    }
  }
  return best;
}

}  // namespace inkcell::gen
