#include "morph/match_loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr double kPieceCost = 6;  // so that there are few
constexpr double kStopCost = 3;   // of a stop within an edge

// The directions of an edge at its ends, or of a loop before and behind a stop.
struct Directions {
  double first = 0;  // [radians]
  double last = 0;
  double turn = 0;
};

// A way on from a stop: nothing, to a later stop of the edge, or to its end.
struct Advance {
  int stops = 0;
  MorphSide side;
  double length = 0;
  Directions directions;
  bool is_cut = false;
};

double direction_at(const Point (&p)[3], bool is_end) {
  Point d = is_end ? p[2] - p[1] : p[1] - p[0];
  d = length(d) > 1e-6 ? d : p[2] - p[0];
  return std::atan2(d.y, d.x);
}

double turn_between(double first, double last) {
  const double turn = std::abs(last - first);
  return std::min(turn, 2 * kPi - turn);
}

Directions directions_between(double first, double last) {
  return {first, last, turn_between(first, last)};
}

using Advances = std::vector<std::vector<Advance>>;

Advances advances_of(const Loop& loop, const std::vector<LoopStop>& stops) {
  Advances all(stops.size());
  const size_t n = stops.size();
  for (size_t i = 0; i < n; ++i) {
    Advance none;
    std::fill(std::begin(none.side.p), std::end(none.side.p), stops[i].at);
    all[i].push_back(none);
    const LoopEdge& edge = loop[static_cast<size_t>(stops[i].edge)];
    for (size_t k = 1;; ++k) {
      const bool is_end = i + k == n || stops[i + k].edge != stops[i].edge;
      Advance next;
      next.stops = static_cast<int>(k);
      next.side = side_to(edge, stops[i].eighth,
                          is_end ? edge.to : stops[i + k].eighth);
      next.length = length_of(next.side.p);
      next.directions = directions_between(direction_at(next.side.p, false),
                                           direction_at(next.side.p, true));
      next.is_cut = !is_end;
      all[i].push_back(next);
      if (is_end) {
        break;
      }
    }
  }
  return all;
}

std::vector<Directions> corners_of(const Loop& loop,
                                   const std::vector<LoopStop>& stops) {
  std::vector<Directions> corners;
  for (const LoopStop& stop : stops) {
    const auto k = static_cast<size_t>(stop.edge);
    const LoopEdge& edge = loop[k];
    const bool is_begin = stop.eighth == edge.from;
    const LoopEdge in = is_begin ? loop[(k + loop.size() - 1) % loop.size()]
                                 : part_of(edge, edge.from, stop.eighth);
    const LoopEdge out = is_begin ? edge : part_of(edge, stop.eighth, edge.to);
    corners.push_back(directions_between(direction_at(in.p, true),
                                         direction_at(out.p, false)));
  }
  return corners;
}

// What an edge turns, where it grows out of a corner of the other loop, beyond
// that corner: times its length, as that of the spike. [u]
double askew(const Directions& corner, const Advance& grown) {
  if (grown.length < 1e-6) {
    return 0;
  }
  return grown.length * (turn_between(corner.first, grown.directions.first) +
                         turn_between(grown.directions.last, corner.last) +
                         grown.directions.turn - corner.turn);
}

size_t most_advances(const Advances& all) {
  size_t most = 0;
  for (const auto& list : all) {
    most = std::max(most, list.size());
  }
  return most;
}

double cost_of(const Point (&a)[3],
               const Point (&b)[3],
               double length_a,
               double length_b,
               double far_u) {
  Point d[3];
  for (size_t i = 0; i < 3; ++i) {
    d[i] = a[i] - b[i];
  }
  // The integrals of the squares of a quadratic and of its derivative.
  const double apart =
      (dot(d[0], d[0]) + dot(d[2], d[2])) / 5 + dot(d[1], d[1]) * 2 / 15 +
      (dot(d[0], d[1]) + dot(d[1], d[2])) / 5 + dot(d[0], d[2]) / 15;
  const Point e0 = 2.0 * (d[1] - d[0]);
  const Point e1 = 2.0 * (d[2] - d[1]);
  const double bent = (dot(e0, e0) + dot(e0, e1) + dot(e1, e1)) / 3;
  const double size = (length_a + length_b) / 2 + 1;
  // Opposite directions collapse in the middle.
  const double along = dot(a[2] - a[0], b[2] - b[0]);
  const double turned = along < 0 ? 2 * std::sqrt(-along) : 0;
  return apart * size / (far_u * far_u) + bent / size + turned;
}

// The table of the least costs, for one pair of starts after the other.
class Matcher {
 public:
  Matcher(const Loop& a, const Loop& b, const MatchOptions& options)
      : loops_{&a, &b},
        stops_{stops_of(a, options.parts), stops_of(b, options.parts)},
        advances_{advances_of(a, stops_[0]), advances_of(b, stops_[1])},
        corners_{corners_of(a, stops_[0]), corners_of(b, stops_[1])},
        n_{stops_[0].size(), stops_[1].size()},
        end_{n_[0], n_[1]},
        most_{most_advances(advances_[0]), most_advances(advances_[1])} {
    costs_.resize(n_[0] * n_[1] * most_[0] * most_[1]);
    for (size_t i = 0; i < n_[0]; ++i) {
      for (size_t j = 0; j < n_[1]; ++j) {
        fill(i, j, options);
      }
    }
    for (const MatchOptions::Penalty& penalty : options.penalties) {
      punish(penalty);
    }
  }

  LoopMatch find() {
    set_least_costs();
    set_rest(0, 0);
    best_.cost = kInfinity;
    // A good start first: others are soon known to be worse.
    size_t nearest = n_[1];
    double least = kInfinity;
    for (size_t j = 0; j < n_[1]; ++j) {
      const double away = length(stops_[1][j].at - stops_[0][0].at);
      if (may_start(j) && away < least) {
        nearest = j;
        least = away;
      }
    }
    if (nearest < n_[1]) {
      try_start(nearest);
    }
    for (size_t j = 0; j < n_[1]; ++j) {
      if (j != nearest && may_start(j)) {
        try_start(j);
      }
    }
    return best_;
  }

  // Of loops that the last edge closes: all but this edge.
  LoopMatch find_open() {
    set_least_costs();
    set_rest(0, 0);
    best_.cost = kInfinity;
    --end_[0];
    --end_[1];
    try_start(0);
    return best_;
  }

 private:
  bool may_start(size_t j) const {
    const LoopStop& stop = stops_[1][j];
    const LoopEdge& edge = (*loops_[1])[static_cast<size_t>(stop.edge)];
    return !edge.is_jump && (stop.eighth == edge.from || j % 2 == 0);
  }

  float* costs(size_t i, size_t j) {
    return costs_.data() + (i * n_[1] + j) * most_[0] * most_[1];
  }

  void fill(size_t i, size_t j, const MatchOptions& options) {
    float* const at = costs(i, j);
    for (size_t x = 0; x < advances_[0][i].size(); ++x) {
      for (size_t y = 0; y < advances_[1][j].size(); ++y) {
        const Advance& a = advances_[0][i][x];
        const Advance& b = advances_[1][j][y];
        at[x * most_[1] + y] = static_cast<float>(
            cost_of(a.side.p, b.side.p, a.length, b.length, options.far_u) +
            (x == 0 ? options.turning * askew(corners_[0][i], b) : 0) +
            (y == 0 ? options.turning * askew(corners_[1][j], a) : 0) +
            kPieceCost + (a.is_cut ? kStopCost : 0) +
            (b.is_cut ? kStopCost : 0));
      }
    }
  }

  void punish(const MatchOptions::Penalty& penalty) {
    const auto i = static_cast<size_t>(penalty.stop[0]) % n_[0];
    const auto j = static_cast<size_t>(penalty.stop[1]) % n_[1];
    float* const at = costs(i, j);
    for (size_t k = 0; k < most_[0] * most_[1]; ++k) {
      at[k] += static_cast<float>(penalty.cost);
    }
  }

  // The least cost of each advance in one loop, over all of the other.
  void set_least_costs() {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    least_[0].assign(n_[0] * most_[0], kFar);
    least_[1].assign(n_[1] * most_[1], kFar);
    for (size_t i = 0; i < n_[0]; ++i) {
      for (size_t j = 0; j < n_[1]; ++j) {
        const float* at = costs(i, j);
        for (size_t x = 0; x < advances_[0][i].size(); ++x) {
          float& least = least_[0][i * most_[0] + x];
          for (size_t y = 0; y < advances_[1][j].size(); ++y) {
            const float cost = at[x * most_[1] + y];
            least = std::min(least, cost);
            float& other = least_[1][j * most_[1] + y];
            other = std::min(other, cost);
          }
        }
      }
    }
  }

  // The least cost from each stop of a loop to its end.
  void set_rest(size_t k, size_t start) {
    const size_t n = n_[k];
    rest_[k].assign(n + 1, std::numeric_limits<float>::infinity());
    rest_[k][n] = 0;
    for (size_t i = n; i-- > 0;) {
      const size_t at = (i + start) % n;
      const size_t count = std::min(advances_[k][at].size(), n - i + 1);
      for (size_t x = 1; x < count; ++x) {
        rest_[k][i] = std::min(rest_[k][i],
                               least_[k][at * most_[k] + x] + rest_[k][i + x]);
      }
    }
  }

  void try_start(size_t start) {
    const size_t n = n_[0];
    const size_t m = n_[1];
    const size_t width = m + 1;
    const float far = static_cast<float>(best_.cost);
    sums_.assign((n + 1) * width, std::numeric_limits<float>::infinity());
    from_.assign((n + 1) * width, 0);
    sums_[0] = 0;
    set_rest(1, start);
    for (size_t i = 0; i <= n; ++i) {
      for (size_t j = 0; j <= m; ++j) {
        const float sum = sums_[i * width + j];
        if (sum + std::max(rest_[0][i], rest_[1][j]) >= far) {
          continue;
        }
        const size_t a = i % n;
        const size_t b = (j + start) % m;
        const float* const prices = costs(a, b);
        const size_t ways_a = i == n ? 1 : advances_[0][a].size();
        const size_t ways_b = j == m ? 1 : advances_[1][b].size();
        // Not beyond the start of the second loop.
        const size_t most_b = std::min(ways_b, m - j + 1);
        for (size_t x = 0; x < ways_a; ++x) {
          const size_t row = (i + x) * width + j;
          const float* const of_x = prices + x * most_[1];
          for (size_t y = x == 0 ? 1 : 0; y < most_b; ++y) {
            const float price = sum + of_x[y];
            if (price < sums_[row + y]) {
              sums_[row + y] = price;
              from_[row + y] = static_cast<uint16_t>(x * 256 + y);
            }
          }
        }
      }
    }
    const float sum = sums_[end_[0] * width + end_[1]];
    if (sum < far) {
      keep(sum, start);
    }
  }

  void keep(double cost, size_t start) {
    best_.cost = cost;
    MorphContour& contour = best_.contour;
    contour = MorphContour();
    for (size_t k = 0; k < 2; ++k) {
      const LoopStop& stop = stops_[k][k == 0 ? 0 : start];
      contour.start[k] = {(*loops_[k])[static_cast<size_t>(stop.edge)].segment,
                          stop.eighth};
    }
    size_t i = end_[0];
    size_t j = end_[1];
    while (i + j != 0) {
      const size_t way = from_[i * (n_[1] + 1) + j];
      i -= way / 256;
      j -= way % 256;
      const size_t a = i % n_[0];
      const size_t b = (j + start) % n_[1];
      MorphPiece piece;
      piece.side[0] = advances_[0][a][way / 256].side;
      piece.side[1] = advances_[1][b][way % 256].side;
      piece.stop[0] = static_cast<int>(a);
      piece.stop[1] = static_cast<int>(b);
      contour.pieces.push_back(piece);
    }
    std::reverse(contour.pieces.begin(), contour.pieces.end());
  }

  const Loop* loops_[2];
  std::vector<LoopStop> stops_[2];
  Advances advances_[2];
  std::vector<Directions> corners_[2];
  size_t n_[2];
  size_t end_[2];  // where the match is complete
  size_t most_[2];
  std::vector<float> costs_;
  std::vector<float> least_[2];
  std::vector<float> rest_[2];
  std::vector<float> sums_;
  std::vector<uint16_t> from_;
  LoopMatch best_;
};

// Whether two curves begin and end in about the same directions.
bool run_alike(const LoopEdge& a, const LoopEdge& b) {
  constexpr double kLeastCosine = 0.97;  // 14 degrees
  const auto alike = [](const Point& u, const Point& v) {
    return dot(u, v) >= kLeastCosine * length(u) * length(v);
  };
  return !a.is_jump && !b.is_jump && alike(a.p[1] - a.p[0], b.p[1] - b.p[0]) &&
         alike(a.p[2] - a.p[1], b.p[2] - b.p[1]);
}

// A path as a loop: an edge closes it.
Loop loop_of(const Loop& path) {
  Loop loop = path;
  LoopEdge edge;
  edge.is_jump = true;
  edge.p[0] = path.back().p[2];
  edge.p[2] = path.front().p[0];
  edge.p[1] = middle(edge.p[0], edge.p[2]);
  loop.push_back(edge);
  return loop;
}

}  // namespace

MorphSide side_to(const LoopEdge& edge, int from, int to) {
  MorphSide side;
  const LoopEdge part = edge.is_jump ? edge : part_of(edge, from, to);
  std::copy(std::begin(part.p), std::end(part.p), std::begin(side.p));
  if (edge.is_jump) {
    side.move = MorphMove::jump;
    side.target = edge.target;
  } else if (to == 8) {
    side.move = MorphMove::to_end;
  } else {
    side.move = MorphMove::to_stop;
    side.eighth = to;
  }
  return side;
}

double piece_cost(const Point (&a)[3], const Point (&b)[3], double far_u) {
  return kPieceCost + cost_of(a, b, length_of(a), length_of(b), far_u);
}

std::optional<LoopMatch> match_edges(const Loop& a,
                                     const Loop& b,
                                     double far_u) {
  const size_t n = a.size();
  std::optional<LoopMatch> best;
  for (size_t start = 0; start < n && n == b.size(); ++start) {
    LoopMatch match;
    match.contour.start[0] = {a.front().segment, a.front().from};
    match.contour.start[1] = {b[start].segment, b[start].from};
    for (size_t i = 0; i < n; ++i) {
      const size_t j = (start + i) % n;
      if (!run_alike(a[i], b[j])) {
        break;
      }
      MorphPiece piece;
      piece.side[0] = side_to(a[i], a[i].from, a[i].to);
      piece.side[1] = side_to(b[j], b[j].from, b[j].to);
      piece.stop[0] = static_cast<int>(i);
      piece.stop[1] = static_cast<int>(j);
      match.cost += piece_cost(a[i].p, b[j].p, far_u);
      match.contour.pieces.push_back(piece);
    }
    if (match.contour.pieces.size() == n &&
        (!best || match.cost < best->cost)) {
      best = std::move(match);
    }
  }
  return best;
}

LoopMatch match_paths(const Loop& a,
                      const Loop& b,
                      const MatchOptions& options) {
  const Loop loops[] = {loop_of(a), loop_of(b)};
  return Matcher(loops[0], loops[1], options).find_open();
}

LoopMatch match_loops(const Loop& a,
                      const Loop& b,
                      const MatchOptions& options) {
  if (options.by_edges && options.penalties.empty()) {
    if (std::optional<LoopMatch> match = match_edges(a, b, options.far_u)) {
      return *match;
    }
  }
  return Matcher(a, b, options).find();
}

}  // namespace inkcell::gen
