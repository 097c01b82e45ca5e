#include "morph/births.hpp"

#include <algorithm>

#include "morph/morph_check.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr size_t kMostPoints = 5;

// The middle of a chord across a stroke.
struct Middle {
  MorphStop stop[2];
  Point at;
  double depth = 0;
};

MorphPolygons polygons_of(const std::vector<Loop>& glyph) {
  MorphPolygons out;
  for (const Loop& loop : glyph) {
    std::vector<Point> polygon;
    for (const LoopEdge& edge : loop) {
      for (int i = 0; i < 5; ++i) {
        polygon.push_back(point_at(edge.p, i / 5.0));
      }
    }
    out.push_back(std::move(polygon));
  }
  return out;
}

// Chords whose middle is as deep as the ink is there.
std::vector<Middle> middles_of(const std::vector<Loop>& glyph,
                               const MorphPolygons& polygons) {
  std::vector<std::pair<MorphStop, Point>> stops;
  for (const Loop& loop : glyph) {
    for (const LoopStop& stop : stops_of(loop, 4)) {
      stops.push_back(
          {{loop[static_cast<size_t>(stop.edge)].segment, stop.eighth},
           stop.at});
    }
  }
  std::vector<Middle> out;
  for (size_t i = 0; i < stops.size(); ++i) {
    Middle best;
    for (size_t j = 0; j < i; ++j) {
      const Point at = middle(stops[i].second, stops[j].second);
      const double half = length(stops[i].second - stops[j].second) / 2;
      if (half < 8 || (best.depth > 0 && half > 1.3 * best.depth)) {
        continue;
      }
      const double depth = depth_at(polygons, at, 0.8 * half);
      if (depth > 0.8 * half && (best.depth == 0 || half < best.depth)) {
        best = {{stops[i].first, stops[j].first}, at, depth};
      }
    }
    if (best.depth > 0) {
      out.push_back(best);
    }
  }
  return out;
}

MorphContour born_at(const Middle& from, const Loop& loop, int missing) {
  MorphContour contour;
  contour.missing = missing;
  const auto lacks = static_cast<size_t>(missing);
  const auto has = 1 - lacks;
  contour.chord[0] = from.stop[0];
  contour.chord[1] = from.stop[1];
  contour.start[has] = {loop.front().segment, 0};
  for (const LoopEdge& edge : loop) {
    MorphPiece piece;
    MorphSide& side = piece.side[has];
    side.move = MorphMove::to_end;
    std::copy(std::begin(edge.p), std::end(edge.p), std::begin(side.p));
    MorphSide& point = piece.side[lacks];
    std::fill(std::begin(point.p), std::end(point.p), from.at);
    contour.pieces.push_back(piece);
  }
  return contour;
}

}  // namespace

std::vector<MorphContour> births_of(const Loop& loop,
                                    const std::vector<Loop>& glyph,
                                    int missing) {
  constexpr double kApart_u = 24;
  constexpr double kDeep = 2;  // a u of depth is worth so many of nearness
  std::vector<Middle> middles = middles_of(glyph, polygons_of(glyph));
  const Point centre = centroid_of(loop);
  std::stable_sort(middles.begin(), middles.end(),
                   [&](const Middle& a, const Middle& b) {
                     return length(a.at - centre) - kDeep * a.depth <
                            length(b.at - centre) - kDeep * b.depth;
                   });
  std::vector<MorphContour> out;
  for (const Middle& from : middles) {
    const bool is_near =
        std::any_of(out.begin(), out.end(), [&](const MorphContour& other) {
          const auto lacks = static_cast<size_t>(missing);
          return length(other.pieces.front().side[lacks].p[0] - from.at) <
                 kApart_u;
        });
    if (!is_near && out.size() < kMostPoints) {
      out.push_back(born_at(from, loop, missing));
    }
  }
  return out;
}

}  // namespace inkcell::gen
