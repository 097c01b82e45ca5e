#include "outlines/refit.hpp"

#include <algorithm>
#include <cmath>

#include "outlines/chain_path.hpp"
#include "outlines/contour_order.hpp"
#include "outlines/curves.hpp"
#include "outlines/expand.hpp"
#include "outlines/trace.hpp"
#include "outlines/unite.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace {

// Chains are only compared with their own part of the source, so contours may
// still cross where they are closer than the tolerance. Seen from outside they
// then deviate by more than this, and are refitted with more care. [tolerances]
constexpr double kMostStray = 1.1;
constexpr int kRefitRounds = 4;
// Contours that overlap by less fill the same pixels. [u]
constexpr double kOverlap_u = 0.05;
constexpr int kOverlapSamples = 8;

constexpr double kSmooth_cos = 0.9902681;  // 8 degrees

GridPoint grid_point(const Point& p, PointKind kind) {
  return {static_cast<int>(p.x), static_cast<int>(p.y), kind};
}

Point point_of(const GridPoint& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

bool same_place(const GridPoint& a, const GridPoint& b) {
  return a.x == b.x && a.y == b.y;
}

// Points on the curve that are marked `smooth` on entry may become so.
void set_kinds(std::vector<GridPoint>& points) {
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) {
    if (points[i].kind != PointKind::smooth) {
      continue;
    }
    const Point at = point_of(points[i]);
    const Point in = direction(at - point_of(points[(i + n - 1) % n]));
    const Point out = direction(point_of(points[(i + 1) % n]) - at);
    if (dot(in, out) < kSmooth_cos) {
      points[i].kind = PointKind::corner;
    }
  }
}

// Removes points at which the contour goes straight back.
void drop_spikes(std::vector<GridPoint>& points) {
  for (size_t i = 0; i < points.size() && points.size() > 2;) {
    const size_t n = points.size();
    const GridPoint& before = points[(i + n - 1) % n];
    const GridPoint& after = points[(i + 1) % n];
    const Point in = point_of(points[i]) - point_of(before);
    const Point out = point_of(after) - point_of(points[i]);
    const auto on_curve = [](const GridPoint& p) {
      return p.kind != PointKind::off_curve;
    };
    if (on_curve(before) && on_curve(points[i]) && on_curve(after) &&
        cross(in, out) == 0 && dot(in, out) <= 0) {
      points.erase(points.begin() + static_cast<ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
}

std::vector<GridPoint> points_of(const ChainSearch& search,
                                 const std::vector<PathStep>& path) {
  std::vector<GridPoint> points;
  for (const PathStep& step : path) {
    const bool explicit_corner = search.node(step.first).care != Care::none;
    const GridPoint start =
        grid_point(step.chain.from,
                   explicit_corner ? PointKind::corner : PointKind::smooth);
    if (points.empty() || !same_place(points.back(), start)) {
      points.push_back(start);
    }
    for (const Point& control : step.chain.controls) {
      const GridPoint p = grid_point(control, PointKind::off_curve);
      if (!same_place(points.back(), p)) {
        points.push_back(p);
      }
    }
  }
  while (points.size() > 1 && same_place(points.back(), points.front())) {
    points.pop_back();
  }
  drop_spikes(points);
  set_kinds(points);
  return points;
}

// Twice the signed area of the polygon of all points; the contour's area has
// the same sign.
double twice_area(const std::vector<GridPoint>& points) {
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    sum +=
        cross(point_of(points[i]), point_of(points[(i + 1) % points.size()]));
  }
  return sum;
}

double twice_area(const Contour& contour) {
  double sum = 0;
  for (const Segment& segment : contour.segments) {
    sum += twice_area(segment);
  }
  return sum;
}

MinimalContour refit(const Contour& contour,
                     const RefitOptions& options,
                     const RefitScale& scale,
                     RefitMemo& memo) {
  const Trace source = trace(contour, options, scale);
  const ChainSearch search(source, scale, memo);
  std::vector<PathStep> path = cheapest_path(source, search);
  drop_joints(search, path);
  MinimalContour result{points_of(search, path)};
  if (!(twice_area(result.points) * twice_area(contour) > 0)) {
    result.points.clear();  // the contour vanishes on this grid
  }
  return result;
}

// Everything that the refit of a contour depends on: segments, options, and
// places in reach.
Fingerprint fingerprint(const Contour& contour, const RefitOptions& options) {
  Fingerprint print;
  print.add(uint64_t{static_cast<unsigned>(options.units_per_em)});
  print.add(static_cast<double>(options.grid_shift));
  print.add(options.tolerance_u);
  Box box = kNoBox;
  for (const Segment& segment : contour.segments) {
    print.add(static_cast<uint64_t>(segment.kind));
    for (int i = 0; i <= degree_of(segment); ++i) {
      const Point& p = segment.p[i];
      print.add(p);
      box.add(p);
    }
  }
  for (const auto* places : {&options.careful_u, &options.exact_u}) {
    print.add(uint64_t{places == &options.exact_u});
    for (const Point& p : *places) {
      if (p.x >= box.x0 - kCareRadius_u && p.x <= box.x1 + kCareRadius_u &&
          p.y >= box.y0 - kCareRadius_u && p.y <= box.y1 + kCareRadius_u) {
        print.add(p);
      }
    }
  }
  return print;
}

MinimalContour refit_once(const Contour& contour,
                          const RefitOptions& options,
                          const RefitScale& scale,
                          RefitMemo& memo) {
  const Fingerprint print = fingerprint(contour, options);
  if (const MinimalContour* known = memo.contours.find(print)) {
    return *known;
  }
  MinimalContour result = refit(contour, options, scale, memo);
  memo.contours.add(print, result);
  return result;
}

MinimalOutline refit(const Outline& united,
                     const RefitOptions& options,
                     RefitMemo& memo) {
  const RefitScale scale(options);
  MinimalOutline result;
  double x = kInfinity;
  double y = x;
  for (const Contour& contour : united.contours) {
    for (const Segment& segment : contour.segments) {
      x = std::min(x, scale.grid_per_u * segment.p[0].x);
      y = std::min(y, scale.grid_per_u * segment.p[0].y);
    }
    MinimalContour minimal = refit_once(contour, options, scale, memo);
    if (!minimal.points.empty()) {
      result.contours.push_back(std::move(minimal));
    }
  }
  if (!result.contours.empty()) {
    order_contours(static_cast<int>(std::floor(x)),
                   static_cast<int>(std::floor(y)), result);
  }
  return result;
}

// Compares results with the source from outside.
class Judge {
 public:
  Judge(const Shape& source, const RefitOptions& options)
      : options_(options), source_(source) {}

  // The fault of `result`, 0 if it equals the source. Appends the places where
  // it deviates and where its contours overlap. [u]
  double fault(const MinimalOutline& result, std::vector<Point>& places) const {
    const Outline drawn =
        expand(result, options_.units_per_em, options_.grid_shift);
    const Shape shape(drawn);
    return std::max(find_strays(source_, shape, places),
                    find_strays(shape, source_, places)) +
           find_overlaps(drawn, shape, places);
  }

 private:
  // Adds the ends and middles of edges of `a` that are too far from the border
  // of `b`. Returns the largest distance.
  double find_strays(const Shape& a,
                     const Shape& b,
                     std::vector<Point>& places) const {
    double most = 0;
    for (const Edge& edge : a.edges()) {
      for (const Point& p : {edge.a, middle(edge.a, edge.b)}) {
        const double d = std::fabs(b.distance(p.x, p.y));
        most = std::max(most, d);
        if (d > kMostStray * options_.tolerance_u) {
          places.push_back(p);
        }
      }
    }
    return most;
  }

  // Adds points of contours that are not on the border of the filled area. If
  // there are any, the result is larger than any deviation.
  double find_overlaps(const Outline& drawn,
                       const Shape& shape,
                       std::vector<Point>& places) const {
    double most = 0;
    for (const Contour& contour : drawn.contours) {
      for (const Segment& segment : contour.segments) {
        for (int i = 0; i < kOverlapSamples; ++i) {
          const Point p =
              point_on(segment, static_cast<double>(i) / kOverlapSamples);
          const double d = std::fabs(shape.distance(p.x, p.y));
          most = std::max(most, d);
          if (d > kOverlap_u) {
            places.push_back(p);
          }
        }
      }
    }
    return most > kOverlap_u ? 10 * options_.tolerance_u + most : 0;
  }

  const RefitOptions& options_;
  const Shape& source_;
};

}  // namespace

MinimalOutline minimal_outline(const Outline& united,
                               const Shape& shape,
                               const RefitOptions& options,
                               RefitMemo& memo) {
  Outline source = united;
  const Judge judge(shape, options);
  RefitOptions wary = options;
  MinimalOutline best;
  double least = kInfinity;
  for (int round = 0; round < kRefitRounds && !shape.empty(); ++round) {
    MinimalOutline result = refit(source, wary, memo);
    std::vector<Point>& places = round == 0 ? wary.careful_u : wary.exact_u;
    const size_t before = places.size();
    const double fault = judge.fault(result, places);
    if (round + 2 == kRefitRounds) {
      // Parts nearer than the grid's resolution are united.
      source = unite(expand(result, options.units_per_em, options.grid_shift));
    }
    if (fault < least) {
      least = fault;
      best = std::move(result);
    }
    if (places.size() == before) {
      break;
    }
  }
  return best;
}

}  // namespace inkcell::gen
