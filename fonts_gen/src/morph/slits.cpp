#include "morph/slits.hpp"

#include <algorithm>
#include <cmath>

#include "morph/match_loops.hpp"
#include "morph/morph_check.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr size_t kMostSlits = 12;

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

struct Extent {
  double low = kInfinity;
  double high = -kInfinity;

  double size() const { return high - low; }
};

Extent extent_along(const Loop& hole, const Point& unit) {
  Extent extent;
  for (const LoopEdge& edge : hole) {
    extent.low = std::min(extent.low, dot(edge.p[0], unit));
    extent.high = std::max(extent.high, dot(edge.p[0], unit));
  }
  return extent;
}

// Pieces of the hole, and of the slit from `a` to `b`.
MorphContour opened(const Loop& hole,
                    const Middle& a,
                    const Middle& b,
                    int missing) {
  MorphContour contour;
  contour.missing = missing;
  const auto lacks = static_cast<size_t>(missing);
  const auto has = 1 - lacks;
  contour.slit[0] = a.stop[0];
  contour.slit[1] = a.stop[1];
  contour.slit[2] = b.stop[0];
  contour.slit[3] = b.stop[1];
  contour.start[has] = {hole.front().segment, 0};
  contour.slit_middle = middle(a.at, b.at);
  const Point along = b.at - a.at;
  const Point unit = direction(along);
  const Extent extent = extent_along(hole, unit);
  const auto eighth_of = [&](const Point& p) {
    const double part =
        extent.size() > 0 ? (dot(p, unit) - extent.low) / extent.size() : 0.5;
    return static_cast<int>(std::floor(std::min(part, 1.0) * 7 + 0.5));
  };
  const auto at = [&](int eighth) {
    return contour.slit_middle + (2 * eighth - 7) / 16.0 * along;
  };
  // The last piece ends where the first one begins.
  int from = eighth_of(hole.front().p[0]);
  for (const LoopEdge& edge : hole) {
    MorphPiece piece;
    MorphSide& side = piece.side[has];
    side.move = MorphMove::to_end;
    std::copy(std::begin(edge.p), std::end(edge.p), std::begin(side.p));
    MorphSide& slit = piece.side[lacks];
    slit.move = MorphMove::fraction;
    slit.eighth = eighth_of(edge.p[2]);
    slit.p[0] = at(from);
    slit.p[2] = at(slit.eighth);
    slit.p[1] = middle(slit.p[0], slit.p[2]);
    from = slit.eighth;
    contour.pieces.push_back(piece);
  }
  return contour;
}

bool is_open(const MorphPolygons& polygons, const Middle& a, const Middle& b) {
  const double least = 0.6 * std::min(a.depth, b.depth);
  for (int i = 1; i < 6; ++i) {
    const double t = i / 6.0;
    if (depth_at(polygons, (1 - t) * a.at + t * b.at, least) < least) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<MorphContour> slits_for(const Loop& hole,
                                    const std::vector<Loop>& glyph,
                                    int missing) {
  const MorphPolygons polygons = polygons_of(glyph);
  const std::vector<Middle> middles = middles_of(glyph, polygons);
  struct Candidate {
    double cost;
    MorphContour contour;
  };
  std::vector<Candidate> all;
  for (size_t i = 0; i < middles.size(); ++i) {
    for (size_t j = 0; j <= i; ++j) {
      const Point along = middles[j].at - middles[i].at;
      if (length(along) > extent_along(hole, direction(along)).size() ||
          (i != j && !is_open(polygons, middles[i], middles[j]))) {
        continue;
      }
      MorphContour contour = opened(hole, middles[i], middles[j], missing);
      double cost = 0;
      for (const MorphPiece& piece : contour.pieces) {
        cost += piece_cost(piece.side[0].p, piece.side[1].p, kUsualFar_u);
      }
      all.push_back({cost, std::move(contour)});
    }
  }
  std::stable_sort(
      all.begin(), all.end(),
      [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<MorphContour> out;
  for (Candidate& candidate : all) {
    const Point& at = candidate.contour.slit_middle;
    const bool is_near =
        std::any_of(out.begin(), out.end(), [&at](const MorphContour& other) {
          return length(other.slit_middle - at) < 24;
        });
    if (!is_near && out.size() < kMostSlits) {
      out.push_back(std::move(candidate.contour));
    }
  }
  return out;
}

}  // namespace inkcell::gen
