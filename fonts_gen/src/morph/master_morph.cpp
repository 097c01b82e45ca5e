#include "morph/master_morph.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "morph/match_loops.hpp"
#include "morph/morph_check.hpp"
#include "morph/morph_loop.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

bool equal_kinds(const Segment& a, const Segment& b) {
  return a.kind == b.kind;
}

// Takes points near the border of the first master to where the same points of
// the second one are.
class Way {
 public:
  explicit Way(const Outline (&masters)[2]) {
    for (size_t c = 0; c < masters[0].contours.size(); ++c) {
      const auto& first = masters[0].contours[c].segments;
      const auto& second = masters[1].contours[c].segments;
      for (size_t s = 0; s < first.size(); ++s) {
        add(first[s], second[s]);
      }
    }
  }

  // `along`: the direction of the border, with the ink on its left. It parts
  // edges that are near to each other.
  Point operator()(const Point& at, const Point& along) const {
    // Outer contours of TrueType run clockwise.
    const double turned_u = area_ < 0 ? -12 : 12;
    double least = kInfinity;
    Point best = at;
    for (const Chords& chord : chords_) {
      const double cost = std::sqrt(chord.from.squared_distance(at)) -
                          turned_u * dot(along, direction(chord.from.d));
      if (cost < least) {
        least = cost;
        best = chord.to.at(chord.from.nearest(at));
      }
    }
    return best;
  }

 private:
  struct Chords {
    Chord from;
    Chord to;
  };

  void add(const Segment& first, const Segment& second) {
    constexpr int kChords = 16;
    const int count = first.kind == Segment::Kind::line ? 1 : kChords;
    for (int i = 0; i < count; ++i) {
      const double t[] = {static_cast<double>(i) / count,
                          static_cast<double>(i + 1) / count};
      const Point a = point_on(first, t[0]);
      const Point b = point_on(first, t[1]);
      chords_.push_back(
          {chord_between(a, b),
           chord_between(point_on(second, t[0]), point_on(second, t[1]))});
      area_ += cross(a, b);
    }
  }

  std::vector<Chords> chords_;
  double area_ = 0;  // twice that of all contours
};

LoopEdge moved(const LoopEdge& edge, const Way& way) {
  const Point middle_at = point_at(edge.p, 0.5);
  const Point chord = direction(edge.p[2] - edge.p[0]);
  const auto toward = [&chord](const Point& v) {
    return length(v) > 1e-9 ? direction(v) : chord;
  };
  LoopEdge out = edge;
  out.p[0] = way(edge.p[0], toward(edge.p[1] - edge.p[0]));
  out.p[2] = way(edge.p[2], toward(edge.p[2] - edge.p[1]));
  out.p[1] = 2.0 * way(middle_at, chord) - middle(out.p[0], out.p[2]);
  return out;
}

// The loop with lines across its gaps: where contours of a master overlap, the
// crossing is at other points of the second one, on each of both contours.
Loop closed(const Loop& loop) {
  Loop out;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Point& next = loop[(i + 1) % loop.size()].p[0];
    out.push_back(loop[i]);
    if (!(next == loop[i].p[2])) {
      out.push_back(whole_edge(line_segment(loop[i].p[2], next), 0));
    }
  }
  return out;
}

// How far a loop is from being another one. [u]
double apart(const Loop& a, const Loop& b) {
  const double areas[] = {area_of(a), area_of(b)};
  if (areas[0] * areas[1] <= 0) {
    return kInfinity;
  }
  return length(centroid_of(a) - centroid_of(b)) +
         std::abs(std::sqrt(std::abs(areas[0])) -
                  std::sqrt(std::abs(areas[1])));
}

// The partner of each loop, the nearest first. Empty: not all have one.
std::vector<size_t> partners_of(const std::vector<Loop>& first,
                                const std::vector<Loop>& second) {
  const size_t n = first.size();
  std::vector<size_t> partners(n, n);
  std::vector<bool> taken(n);
  for (size_t round = 0; round < n; ++round) {
    double least = kInfinity;
    std::pair<size_t, size_t> best;
    for (size_t i = 0; i < n; ++i) {
      for (size_t j = 0; j < n && partners[i] == n; ++j) {
        const double far =
            taken[j] ? kInfinity : apart(closed(first[i]), second[j]);
        if (far < least) {
          least = far;
          best = {i, j};
        }
      }
    }
    if (least == kInfinity) {
      return {};
    }
    partners[best.first] = best.second;
    taken[best.second] = true;
  }
  return partners;
}

// The match of a loop that was moved, with the loop as it is.
MorphContour put_back(MorphContour contour, const Loop& loop) {
  size_t edge = 0;
  while (loop[edge].segment != contour.start[0].segment) {
    ++edge;
  }
  int eighth = contour.start[0].eighth;
  Point at =
      eighth == 0 ? loop[edge].p[0] : part_of(loop[edge], 0, eighth).p[2];
  for (MorphPiece& piece : contour.pieces) {
    MorphSide& side = piece.side[0];
    if (side.move == MorphMove::stay) {
      std::fill(std::begin(side.p), std::end(side.p), at);
      continue;
    }
    const int to = side.move == MorphMove::to_end ? 8 : side.eighth;
    const LoopEdge part = part_of(loop[edge], eighth, to);
    std::copy(std::begin(part.p), std::end(part.p), std::begin(side.p));
    at = part.p[2];
    eighth = to % 8;
    edge = to == 8 ? (edge + 1) % loop.size() : edge;
  }
  return contour;
}

// How far pieces arrive from where they should. [u] A piece more is worth a u.
double slip_of(const MorphContour& contour) {
  double sum = 0;
  for (const MorphPiece& piece : contour.pieces) {
    sum += 1 + std::max(length(point_at(piece.side[0].p, 0.5) -
                               point_at(piece.side[1].p, 0.5)),
                        length(piece.side[0].p[2] - piece.side[1].p[2]));
  }
  return sum;
}

bool is_good(const MorphPair& pair) {
  const MorphQuality quality = quality_of(pair);
  return quality.is_within(kMostMasterAreaError);
}

}  // namespace

bool have_equal_points(const Outline& a, const Outline& b) {
  return correspond(a, b, equal_kinds);
}

std::optional<MorphPair> find_master_morph(const Outline& first,
                                           const Outline& second,
                                           const Outline (&masters)[2]) {
  if (!have_equal_points(masters[0], masters[1])) {
    return std::nullopt;
  }
  const std::vector<Loop> loops[] = {loops_of(first), loops_of(second)};
  if (loops[0].empty() || loops[0].size() != loops[1].size()) {
    return std::nullopt;
  }
  const Way way(masters);
  std::vector<Loop> arrived = loops[0];
  for (Loop& loop : arrived) {
    for (LoopEdge& edge : loop) {
      edge = moved(edge, way);
    }
  }
  const std::vector<size_t> partners = partners_of(arrived, loops[1]);
  if (partners.empty()) {
    return std::nullopt;
  }
  // Loops that lie on each other: what is far is wrong.
  constexpr double kFars_u[] = {60, 30, 140};
  constexpr int kParts[] = {0, 4, 8};  // 0: whole edges, if they run alike
  std::optional<MorphPair> best;
  double least = kInfinity;
  for (const double far_u : kFars_u) {
    for (const int parts : kParts) {
      MatchOptions options;
      options.by_edges = parts == 0;
      options.parts = std::max(parts, 4);
      options.far_u = far_u;
      MorphPair pair;
      double slip = 0;
      for (size_t i = 0; i < arrived.size(); ++i) {
        MorphContour contour =
            match_loops(arrived[i], loops[1][partners[i]], options).contour;
        slip += slip_of(contour);
        pair.contours.push_back(put_back(std::move(contour), loops[0][i]));
      }
      if (slip < least && is_good(pair)) {
        best = std::move(pair);
        least = slip;
      }
    }
    if (best) {
      break;
    }
  }
  return best;
}

}  // namespace inkcell::gen
