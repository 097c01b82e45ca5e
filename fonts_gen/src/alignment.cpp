// Edges, bars and stems of one glyph.
#include "alignment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace inkcell::gen {
namespace {

// Pieces of the border steeper than this are no horizontal edge.
constexpr double kSteepest = 0.2;

// Shorter edges say nothing. [u]
constexpr double kLeastEdge = 24;
constexpr double kLeastFacing = 30;

// What rises by less is flat, and what is longer is a flat part of a run.
constexpr double kFlat = 0.01;
constexpr double kLeastFlat = 24;  // [u]

// What is thicker is no stroke. [u]
constexpr double kThickest = 230;
constexpr double kThinnest = 8;

// Between two strokes. [u]
constexpr double kLeastGap = 10;

// Pieces of one edge differ by no more. [u]
constexpr double kSameEdge = 6;

// The ends of pieces that meet are equal.
using Place = std::pair<double, double>;

// A run of pieces of the border that go in one direction. The filled side is
// on its left.
struct Run {
  double first_y = 0;
  double last_y = 0;
  double low = 0;
  double high = 0;
  double x0 = 0;
  double x1 = 0;
  double flat_length = 0;  // of its flat pieces
  double flat_y = 0;       // their mean, times that length
  double weight = 0;       // of all pieces, most that of the flattest ones
  double weight_y = 0;
  bool goes_right = false;
};

bool is_horizontal(const Edge& edge) {
  return std::abs(edge.b.y - edge.a.y) <=
             kSteepest * std::abs(edge.b.x - edge.a.x) &&
         edge.a.x != edge.b.x;
}

void take(Run& run, const Edge& edge) {
  run.last_y = edge.b.y;
  run.low = std::min({run.low, edge.a.y, edge.b.y});
  run.high = std::max({run.high, edge.a.y, edge.b.y});
  run.x0 = std::min({run.x0, edge.a.x, edge.b.x});
  run.x1 = std::max({run.x1, edge.a.x, edge.b.x});
  const double length = std::abs(edge.b.x - edge.a.x);
  const double slope = std::abs(edge.b.y - edge.a.y) / length;
  const double y = (edge.a.y + edge.b.y) / 2;
  if (slope < kFlat) {
    run.flat_length += length;
    run.flat_y += length * y;
  }
  const double weight =
      length * (1 - slope / kSteepest) * (1 - slope / kSteepest);
  run.weight += weight;
  run.weight_y += weight * y;
}

// Where a run lies: at its end if it bends back, where it is flat, or where it
// is flattest.
double height_of(const Run& run) {
  const double bulge_up = run.high - std::max(run.first_y, run.last_y);
  const double bulge_down = std::min(run.first_y, run.last_y) - run.low;
  if (std::max(bulge_up, bulge_down) > 0.5) {
    return bulge_up > bulge_down ? run.high : run.low;
  }
  return run.flat_length >= kLeastFlat ? run.flat_y / run.flat_length
                                       : run.weight_y / run.weight;
}

std::vector<Run> find_runs(const std::vector<Edge>& edges) {
  std::map<Place, size_t> starts;
  std::map<Place, size_t> ends;
  for (size_t i = 0; i < edges.size(); ++i) {
    if (is_horizontal(edges[i])) {
      starts.emplace(Place(edges[i].a.x, edges[i].a.y), i);
      ends.emplace(Place(edges[i].b.x, edges[i].b.y), i);
    }
  }
  const auto goes_right = [&](size_t i) { return edges[i].b.x > edges[i].a.x; };
  std::vector<Run> runs;
  for (size_t i = 0; i < edges.size(); ++i) {
    const auto before = ends.find(Place(edges[i].a.x, edges[i].a.y));
    if (!is_horizontal(edges[i]) ||
        (before != ends.end() && goes_right(before->second) == goes_right(i))) {
      continue;
    }
    const Edge& first = edges[i];
    Run run;
    run.first_y = first.a.y;
    run.low = first.a.y;
    run.high = first.a.y;
    run.x0 = first.a.x;
    run.x1 = first.a.x;
    run.goes_right = goes_right(i);
    for (size_t at = i;;) {
      take(run, edges[at]);
      const auto next = starts.find(Place(edges[at].b.x, edges[at].b.y));
      if (next == starts.end() || goes_right(next->second) != run.goes_right) {
        break;
      }
      at = next->second;
    }
    runs.push_back(run);
  }
  return runs;
}

std::vector<FlatEdge> find_flat_edges(const std::vector<Edge>& border) {
  std::vector<FlatEdge> found;
  for (const Run& run : find_runs(border)) {
    FlatEdge edge;
    edge.x0 = run.x0;
    edge.x1 = run.x1;
    edge.is_top = !run.goes_right;
    edge.is_flat = run.high - run.low < 1;
    edge.y = height_of(run);
    if (edge.length() >= kLeastEdge) {
      found.push_back(edge);
    }
  }
  return found;
}

double facing(const FlatEdge& a, const FlatEdge& b) {
  return std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
}

// Pairs of edges with ink between them, none over another. The upper edge faces
// at least this share of the lower one.
std::vector<Stroke> find_strokes(const std::vector<FlatEdge>& edges,
                                 double least_share) {
  std::vector<Stroke> all;
  for (const FlatEdge& bottom : edges) {
    if (bottom.is_top) {
      continue;
    }
    Stroke stroke;
    for (const FlatEdge& top : edges) {
      const double thickness = top.y - bottom.y;
      const double length = facing(bottom, top);
      if (!top.is_top || thickness < kThinnest || thickness > kThickest ||
          length < kLeastFacing || length < least_share * bottom.length()) {
        continue;
      }
      // The nearest one, or the longest of several pieces at about its height.
      const double nearer = stroke.high - top.y;
      if (stroke.length == 0 || nearer > kSameEdge ||
          (nearer >= -kSameEdge && length > stroke.length)) {
        stroke = {bottom.y, top.y, length};
      }
    }
    if (stroke.length > 0.5 * (stroke.high - stroke.low)) {
      all.push_back(stroke);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.length > b.length;
  });
  std::vector<Stroke> strokes;
  for (const Stroke& stroke : all) {
    const bool is_free =
        std::all_of(strokes.begin(), strokes.end(), [&](const Stroke& other) {
          return stroke.low > other.high + kLeastGap ||
                 stroke.high < other.low - kLeastGap;
        });
    if (is_free) {
      strokes.push_back(stroke);
    }
  }
  std::sort(strokes.begin(), strokes.end(),
            [](const auto& a, const auto& b) { return a.low < b.low; });
  return strokes;
}

// Turned so that stems become bars: a quarter to the left and then mirrored
// would swap the sides, so the border is walked backwards.
std::vector<Edge> swapped(const std::vector<Edge>& border) {
  std::vector<Edge> out;
  for (const Edge& edge : border) {
    out.push_back({{edge.b.y, edge.b.x}, {edge.a.y, edge.a.x}});
  }
  return out;
}

}  // namespace

GlyphEdges find_edges(const Shape& shape) {
  GlyphEdges found;
  found.edges = find_flat_edges(shape.edges());
  // The lower edge of a foot is much longer than the upper ones: no bar.
  found.bars = find_strokes(found.edges, 0.4);
  // Stems are longer than feet are wide, and not much shorter than others.
  constexpr double kLeastStem = 100;
  const std::vector<Stroke> upright =
      find_strokes(find_flat_edges(swapped(shape.edges())), 0.2);
  double longest = 0;
  for (const Stroke& stem : upright) {
    longest = std::max(longest, stem.length);
  }
  for (const Stroke& stem : upright) {
    if (stem.length >= std::max(kLeastStem, 0.4 * longest)) {
      found.stems.push_back(stem);
    }
  }
  return found;
}

}  // namespace inkcell::gen
