#include "morph/morph_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "morph/morph_loop.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace {

constexpr int kQualityChords = 5;  // of a piece

struct Chord {
  Point a;
  Point b;
  Point low;
  Point high;
  size_t contour;
  size_t piece;
};

Point mixed(const Point& a, const Point& b, double t) {
  return (1 - t) * a + t * b;
}

bool is_cut(const MorphPiece& piece, size_t side) {
  return piece.side[side].move == MorphMove::jump;
}

// A point of a piece at a progress: cuts open late and close early. `other` has
// the same point, or is the piece itself.
Point placed(const MorphPiece& piece,
             const MorphPiece& other,
             size_t i,
             double progress) {
  return mixed(piece.side[0].p[i], piece.side[1].p[i],
               cut_progress(progress, is_cut(piece, 0) || is_cut(other, 0),
                            is_cut(piece, 1) || is_cut(other, 1)));
}

// About the middle of the box of the joints, one of `chords` points each.
void resize(std::vector<Point>& polygon, size_t chords, double size) {
  Point low = polygon.front();
  Point high = low;
  for (size_t i = 0; i < polygon.size(); i += chords) {
    low = {std::min(low.x, polygon[i].x), std::min(low.y, polygon[i].y)};
    high = {std::max(high.x, polygon[i].x), std::max(high.y, polygon[i].y)};
  }
  for (Point& point : polygon) {
    point = mixed(middle(low, high), point, size);
  }
}

bool cross_each_other(const Chord& s, const Chord& t) {
  if (s.high.x < t.low.x || t.high.x < s.low.x || s.high.y < t.low.y ||
      t.high.y < s.low.y) {
    return false;
  }
  const Point u = s.b - s.a;
  const Point v = t.b - t.a;
  // Touching is not crossing.
  const double slack = std::max(1e-6 * length(u) * length(v), 1e-9);
  const auto apart = [slack](double x, double y) {
    return (x > slack && y < -slack) || (x < -slack && y > slack);
  };
  return apart(cross(u, t.a - s.a), cross(u, t.b - s.a)) &&
         apart(cross(v, s.a - t.a), cross(v, s.b - t.a));
}

double area_of(const MorphPolygons& polygons) {
  double twice = 0;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  return twice / 2;
}

void add_crossings(const MorphPolygons& polygons,
                   int step,
                   std::vector<MorphCrossing>& out) {
  std::vector<Chord> all;
  for (size_t c = 0; c < polygons.size(); ++c) {
    const auto& polygon = polygons[c];
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const Chord chord = {a,
                           b,
                           {std::min(a.x, b.x), std::min(a.y, b.y)},
                           {std::max(a.x, b.x), std::max(a.y, b.y)},
                           c,
                           i / size_t{kQualityChords}};
      if (length(chord.b - chord.a) > 1e-6) {
        all.push_back(chord);
      }
    }
  }
  // From left to right, each with those that begin before it ends.
  std::vector<size_t> order(all.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(),
            [&all](size_t i, size_t j) { return all[i].low.x < all[j].low.x; });
  std::vector<std::pair<size_t, size_t>> found;
  for (size_t k = 0; k < order.size(); ++k) {
    const Chord& chord = all[order[k]];
    for (size_t l = k + 1;
         l < order.size() && all[order[l]].low.x <= chord.high.x; ++l) {
      const auto [i, j] = std::minmax(order[k], order[l]);
      if (cross_each_other(all[i], all[j])) {
        found.emplace_back(i, j);
      }
    }
  }
  std::sort(found.begin(), found.end());
  for (const auto& [i, j] : found) {
    out.push_back(
        {step, {all[i].contour, all[j].contour}, {all[i].piece, all[j].piece}});
  }
}

// Whether two pieces run along one line in opposite directions, in both glyphs.
bool are_opposite(const MorphPiece& a, const MorphPiece& b) {
  constexpr double kSlack_u = 0.01;
  for (size_t side = 0; side < 2; ++side) {
    if (!is_cut(b, side) ||
        length(a.side[side].p[0] - b.side[side].p[2]) > kSlack_u ||
        length(a.side[side].p[2] - b.side[side].p[0]) > kSlack_u) {
      return false;
    }
  }
  return true;
}

bool has_opposite(const MorphPair& pair, const MorphPiece& piece) {
  for (const MorphContour& contour : pair.contours) {
    for (const MorphPiece& other : contour.pieces) {
      if (are_opposite(piece, other)) {
        return true;
      }
    }
  }
  return false;
}

bool is_torn(const MorphPair& pair) {
  for (const MorphContour& contour : pair.contours) {
    for (const MorphPiece& piece : contour.pieces) {
      if (is_cut(piece, 0) && is_cut(piece, 1) && !has_opposite(pair, piece)) {
        return true;
      }
    }
  }
  return false;
}

double greatest_depth(const MorphPolygons& polygons) {
  constexpr double kStep_u = 20;
  const Box box = box_of(polygons);
  double most = 0;
  for (double x = box.x0; x < box.x1; x += kStep_u) {
    for (double y = box.y0; y < box.y1; y += kStep_u) {
      most = std::max(most, depth_at(polygons, {x, y}, most));
    }
  }
  return most;
}

}  // namespace

MorphPolygons morph_polygons(const MorphPair& pair,
                             double progress,
                             int chords) {
  MorphPolygons out;
  for (const MorphContour& contour : pair.contours) {
    std::vector<Point> polygon;
    const size_t n = contour.pieces.size();
    for (size_t k = 0; k < n; ++k) {
      const MorphPiece& piece = contour.pieces[k];
      const MorphPiece& last = contour.pieces[(k + n - 1) % n];
      const MorphPiece& next = contour.pieces[(k + 1) % n];
      const Point p[3] = {placed(piece, last, 0, progress),
                          placed(piece, piece, 1, progress),
                          placed(piece, next, 2, progress)};
      for (int i = 0; i < chords; ++i) {
        polygon.push_back(point_at(p, static_cast<double>(i) / chords));
      }
    }
    const double size = born_size(contour, progress);
    if (size != 1) {
      resize(polygon, static_cast<size_t>(chords), size);
    }
    out.push_back(std::move(polygon));
  }
  return out;
}

std::vector<MorphCrossing> crossings_of(const MorphPair& pair) {
  std::vector<MorphCrossing> crossings;
  for (int step = 1; step < kMorphSteps; ++step) {
    add_crossings(morph_polygons(pair, static_cast<double>(step) / kMorphSteps,
                                 kQualityChords),
                  step, crossings);
  }
  return crossings;
}

double area_error_of(const MorphPair& pair) {
  std::vector<double> areas;
  // Half of the steps between, too: contours are half born there.
  for (int i = 0; i <= 2 * kMorphSteps; ++i) {
    areas.push_back(
        area_of(morph_polygons(pair, i / (2.0 * kMorphSteps), kQualityChords)));
  }
  const auto [least, most] = std::minmax(areas.front(), areas.back());
  double error = 0;
  for (const double area : areas) {
    error = std::max({error, least - area, area - most});
  }
  return error / std::max(most, 1.0);
}

MorphQuality quality_of(const MorphPair& pair) {
  return {crossings_of(pair), area_error_of(pair), is_torn(pair)};
}

double thickening_of(const MorphPair& pair) {
  constexpr int kChords = 3;
  const auto depth = [&pair](double progress) {
    return greatest_depth(morph_polygons(pair, progress, kChords));
  };
  const double ends = std::max({depth(0), depth(1), 1.0});
  return std::max({depth(0.25), depth(0.5), depth(0.75)}) / ends;
}

double depth_at(const MorphPolygons& polygons, const Point& at, double least) {
  bool is_inside = false;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      if ((a.y > at.y) != (b.y > at.y) &&
          at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        is_inside = !is_inside;
      }
    }
  }
  if (!is_inside) {
    return 0;
  }
  double nearest = kInfinity;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Point& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      nearest =
          std::min(nearest, squared_distance_to_segment(at, polygon[i], b));
      if (nearest < least * least) {
        return 0;
      }
    }
  }
  return std::sqrt(nearest);
}

}  // namespace inkcell::gen
