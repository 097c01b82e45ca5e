#include "morph/morph_loop.hpp"

#include <algorithm>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr int kChordsOfEdge = 5;

Point blossom(const Point (&p)[3], double s, double t) {
  const auto mix = [](const Point& a, const Point& b, double at) {
    return (1 - at) * a + at * b;
  };
  return mix(mix(p[0], p[1], s), mix(p[1], p[2], s), t);
}

Loop from_stop(const Loop& loop, const LoopStop& stop) {
  Loop out;
  const size_t n = loop.size();
  const auto first = static_cast<size_t>(stop.edge);
  const LoopEdge& cut = loop[first];
  const bool is_inside = stop.eighth > cut.from;
  out.push_back(is_inside ? part_of(cut, stop.eighth, cut.to) : cut);
  for (size_t i = 1; i < n; ++i) {
    out.push_back(loop[(first + i) % n]);
  }
  if (is_inside) {
    out.push_back(part_of(cut, cut.from, stop.eighth));
  }
  return out;
}

LoopEdge jump(const LoopStop& from, const LoopStop& to, const Loop& loop) {
  LoopEdge edge;
  edge.is_jump = true;
  edge.target = {loop[static_cast<size_t>(to.edge)].segment, to.eighth};
  edge.p[0] = from.at;
  edge.p[1] = middle(from.at, to.at);
  edge.p[2] = to.at;
  return edge;
}

}  // namespace

LoopEdge whole_edge(const Segment& segment, int number) {
  if (segment.kind == Segment::Kind::cubic) {
    throw GeometryError(GeometryError::Kind::too_complex,
                        "a morph takes lines and quadratic curves");
  }
  LoopEdge edge;
  edge.segment = number;
  const bool is_line = segment.kind == Segment::Kind::line;
  edge.p[0] = segment.p[0];
  edge.p[1] = is_line ? middle(segment.p[0], segment.p[1]) : segment.p[1];
  edge.p[2] = is_line ? segment.p[1] : segment.p[2];
  return edge;
}

std::vector<Loop> loops_of(const Outline& outline) {
  std::vector<Loop> loops;
  int number = 0;
  for (const Contour& contour : outline.contours) {
    Loop loop;
    for (const Segment& segment : contour.segments) {
      loop.push_back(whole_edge(segment, number++));
    }
    if (!loop.empty()) {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

LoopEdge part_of(const LoopEdge& edge, int from, int to) {
  LoopEdge part = edge;
  part.from = from;
  part.to = to;
  const double span = edge.to - edge.from;
  const double t0 = (from - edge.from) / span;
  const double t1 = (to - edge.from) / span;
  part.p[0] = blossom(edge.p, t0, t0);
  part.p[1] = blossom(edge.p, t0, t1);
  part.p[2] = blossom(edge.p, t1, t1);
  return part;
}

Point point_at(const Point (&p)[3], double t) {
  return blossom(p, t, t);
}

double length_of(const Point (&p)[3]) {
  double sum = 0;
  Point last = p[0];
  for (int i = 1; i <= 4; ++i) {
    const Point next = point_at(p, i / 4.0);
    sum += length(next - last);
    last = next;
  }
  return sum;
}

std::vector<LoopStop> stops_of(const Loop& loop, int parts) {
  constexpr double kLong_u = 60;
  constexpr double kMedium_u = 25;
  std::vector<LoopStop> stops;
  for (size_t i = 0; i < loop.size(); ++i) {
    const LoopEdge& edge = loop[i];
    const auto at = static_cast<int>(i);
    stops.push_back({at, edge.from, edge.p[0]});
    const double size = length_of(edge.p);
    const int count = edge.is_jump       ? 1
                      : size > kLong_u   ? parts
                      : size > kMedium_u ? std::min(parts, 2)
                                         : 1;
    const int step = 8 / count;
    for (int eighth = (edge.from / step + 1) * step; eighth < edge.to;
         eighth += step) {
      stops.push_back({at, eighth, part_of(edge, edge.from, eighth).p[2]});
    }
  }
  return stops;
}

std::vector<Bridge> bridges_between(const Loop& from, const Loop& to) {
  constexpr double kMostLength = 1.7;  // times the shortest
  constexpr double kApart_u = 30;
  const std::vector<LoopStop> ends = stops_of(from, 8);
  std::vector<Bridge> all;
  for (const LoopStop& begin : stops_of(to, 4)) {
    if (to[static_cast<size_t>(begin.edge)].is_jump) {
      continue;
    }
    Bridge best;
    best.length = kInfinity;
    for (const LoopStop& end : ends) {
      const double size = length(begin.at - end.at);
      if (size < best.length && !from[static_cast<size_t>(end.edge)].is_jump) {
        best = {end, begin, size};
      }
    }
    if (best.length < kInfinity) {
      all.push_back(best);
    }
  }
  double least = kInfinity;
  for (const Bridge& bridge : all) {
    least = std::min(least, bridge.length);
  }
  std::vector<Bridge> kept;
  for (const Bridge& bridge : all) {
    const bool is_near =
        std::any_of(kept.begin(), kept.end(), [&bridge](const Bridge& other) {
          return length(other.to.at - bridge.to.at) < kApart_u;
        });
    if (bridge.length <= kMostLength * least && !is_near) {
      kept.push_back(bridge);
    }
  }
  return kept;
}

Loop joined(const Loop& a, const Loop& b, const Bridge& bridge) {
  Loop out = from_stop(a, bridge.from);
  const Loop around = from_stop(b, bridge.to);
  out.push_back(jump(bridge.from, bridge.to, b));
  out.insert(out.end(), around.begin(), around.end());
  out.push_back(jump(bridge.to, bridge.from, a));
  return out;
}

Loop part_between(const Loop& loop, const LoopStop& from, const LoopStop& to) {
  Loop out;
  const size_t n = loop.size();
  const auto last = static_cast<size_t>(to.edge);
  for (auto i = static_cast<size_t>(from.edge); i != last; i = (i + 1) % n) {
    const bool is_cut = out.empty() && from.eighth > loop[i].from;
    out.push_back(is_cut ? part_of(loop[i], from.eighth, loop[i].to) : loop[i]);
  }
  if (to.eighth > loop[last].from) {
    out.push_back(part_of(loop[last], loop[last].from, to.eighth));
  }
  out.push_back(jump(to, from, loop));
  return out;
}

double area_of(const Loop& loop) {
  double twice = 0;
  for (const LoopEdge& edge : loop) {
    Point last = edge.p[0];
    for (int i = 1; i <= kChordsOfEdge; ++i) {
      const Point next = point_at(edge.p, i / double{kChordsOfEdge});
      twice += cross(last, next);
      last = next;
    }
  }
  return twice / 2;
}

Point centroid_of(const Loop& loop) {
  double twice = 0;
  Point sum;
  for (const LoopEdge& edge : loop) {
    Point last = edge.p[0];
    for (int i = 1; i <= kChordsOfEdge; ++i) {
      const Point next = point_at(edge.p, i / double{kChordsOfEdge});
      const double weight = cross(last, next);
      twice += weight;
      sum = sum + weight / 3 * (last + next);
      last = next;
    }
  }
  return twice == 0 ? loop.front().p[0] : 1 / twice * sum;
}

}  // namespace inkcell::gen
