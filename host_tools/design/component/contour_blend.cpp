// The edge of the blend is followed by its distance. Where that is the distance
// of the nearer shape alone, the edge of the union takes its place.
#include "component/contour_blend.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "component/blend_field.hpp"
#include "component/contour_csg.hpp"
#include "fit/cubic_fit.hpp"
#include "fit/curve_fitter.hpp"
#include "fit/loop.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "outlines/curves.hpp"
#include "shape/flatten.hpp"
#include "trace/contour_walk.hpp"

namespace inkcell::design {
namespace {

constexpr double kFilletFit_u = 0.3;        // of fillets
constexpr double kLeastSwell_u = 1.0 / 32;  // of a fillet beyond the union
constexpr double kLeastRun_u = 3;  // shorter pieces join their neighbours
constexpr double kChordBound_u = 1.0 / 32;

// A place on the edge of the union.
struct Place {
  size_t contour = 0;
  size_t segment = 0;
  double t = 0;
  Point at;
  double distance = INFINITY;
};

// A row of points of a loop, which may pass its end.
struct Run {
  size_t first = 0;
  size_t count = 0;
  bool is_fillet = false;
};

gen::Outline outline_of(const std::vector<PointContour>& contours,
                        double scale) {
  gen::Outline outline;
  for (const PointContour& contour : contours) {
    outline.contours.push_back(to_segments(contour, scale));
  }
  return outline;
}

class Blender {
 public:
  Blender(const std::vector<PointContour>& a,
          const std::vector<PointContour>& b,
          double radius,
          double u_per_unit)
      : scale_(u_per_unit),
        a_(outline_of(a, scale_)),
        b_(outline_of(b, scale_)),
        field_(a_, b_, radius * scale_),
        union_(combined(a, b, "union")) {
    for (const PointContour& contour : union_) {
      edges_.push_back(to_segments(contour, scale_));
    }
  }

  std::vector<PointContour> run() {
    if (a_.empty() || b_.empty()) {
      return union_;
    }
    std::vector<PointContour> result;
    const auto distance = [this](const Point& p) { return field_.distance(p); };
    for (Loop& loop : walk_contours(distance, field_.box())) {
      CornerOptions corners;
      corners.distance = distance;
      find_corners(corners, loop);
      result.push_back(contour_of(loop));
    }
    return result;
  }

 private:
  PointContour contour_of(const Loop& loop) {
    const std::vector<Run> runs = runs_of(loop);
    if (runs.empty()) {
      return union_[nearest(loop.points[0]).contour];
    }
    gen::Contour contour;
    if (runs.size() == 1) {
      FitOptions options;
      options.tolerance = kFilletFit_u;
      contour = fit_loop(loop, options);
      return rounded(contour);
    }
    std::vector<bool> is_kept;
    for (size_t i = 0; i < runs.size(); ++i) {
      const Run& run = runs[i];
      if (run.is_fillet) {
        add_fillet(loop, run, contour);
      } else {
        add_edge(loop, run, contour, is_kept);
      }
      is_kept.resize(contour.segments.size());
    }
    // Pieces meet at places of the union.
    const size_t count = contour.segments.size();
    for (size_t i = 0; i < count; ++i) {
      const size_t next = (i + 1) % count;
      gen::Segment& one = contour.segments[i];
      gen::Segment& other = contour.segments[next];
      const Point joint = is_kept[next] || !is_kept[i]
                              ? other.p[0]
                              : one.p[gen::degree_of(one)];
      one.p[gen::degree_of(one)] = joint;
      other.p[0] = joint;
    }
    return rounded(contour);
  }

  // Fillets and pieces of the union in turns; one run if all is fillet, none if
  // nothing is.
  std::vector<Run> runs_of(const Loop& loop) const {
    const size_t count = loop.points.size();
    std::vector<bool> swells(count);
    for (size_t i = 0; i < count; ++i) {
      swells[i] = field_.swell(loop.points[i]) > kLeastSwell_u;
    }
    for (const bool is_fillet : {false, true}) {
      join_short(loop, is_fillet, swells);
    }
    if (std::find(swells.begin(), swells.end(), true) == swells.end()) {
      return {};
    }
    size_t start = 0;
    while (start < count &&
           swells[start] == swells[(start + count - 1) % count]) {
      ++start;
    }
    if (start == count) {
      return {{0, count, true}};
    }
    std::vector<Run> runs;
    for (size_t i = 0; i < count; ++i) {
      const size_t at = (start + i) % count;
      if (runs.empty() || runs.back().is_fillet != swells[at]) {
        runs.push_back({at, 0, swells[at]});
      }
      ++runs.back().count;
    }
    return runs;
  }

  // Turns rows of `value` that are short into their neighbours' value.
  static void join_short(const Loop& loop,
                         bool value,
                         std::vector<bool>& swells) {
    const size_t count = swells.size();
    const auto other = std::find(swells.begin(), swells.end(), !value);
    if (other == swells.end()) {
      return;
    }
    const auto start = static_cast<size_t>(other - swells.begin());
    for (size_t i = 0; i < count; ++i) {
      size_t end = i;
      double size = 0;
      while (end < count && swells[(start + end) % count] == value) {
        size += length(loop.points[(start + end + 1) % count] -
                       loop.points[(start + end) % count]);
        ++end;
      }
      if (end > i && size < kLeastRun_u) {
        for (size_t k = i; k < end; ++k) {
          swells[(start + k) % count] = !value;
        }
      }
      i = std::max(i, end);
    }
  }

  // Cubics through the points of a run, smooth but at corners.
  void add_fillet(const Loop& loop,
                  const Run& run,
                  gen::Contour& contour) const {
    const size_t count = loop.points.size();
    std::vector<Point> points;
    std::vector<std::optional<Point>> tangents;
    for (size_t i = 0; i < run.count; ++i) {
      const size_t at = (run.first + i) % count;
      const bool is_corner =
          std::binary_search(loop.corners.begin(), loop.corners.end(), at);
      points.push_back(loop.points[at]);
      tangents.push_back(is_corner ? std::nullopt
                                   : std::optional(loop.tangents[at]));
    }
    size_t from = 0;
    for (size_t i = 1; i < points.size(); ++i) {
      if (i + 1 == points.size() || !tangents[i]) {
        fit(points, tangents, from, i, contour);
        from = i;
      }
    }
  }

  // Schneider 1990: halves what one cubic does not fit.
  static void fit(const std::vector<Point>& points,
                  const std::vector<std::optional<Point>>& tangents,
                  size_t from,
                  size_t to,
                  gen::Contour& contour) {
    const std::vector<double> lengths = arc_lengths(points);
    const FittedCubic fitted =
        fit_cubic({&points[from], &lengths[from], to - from + 1, tangents[from],
                   tangents[to]},
                  kFilletFit_u);
    constexpr size_t kFewPoints = 8;
    if (fitted.worst <= kFilletFit_u || to - from < kFewPoints) {
      contour.segments.push_back(fitted.segment);
      return;
    }
    const size_t middle = (from + to) / 2;
    fit(points, tangents, from, middle, contour);
    fit(points, tangents, middle, to, contour);
  }

  // The edge of the union between two fillets.
  void add_edge(const Loop& loop,
                const Run& run,
                gen::Contour& contour,
                std::vector<bool>& is_kept) const {
    const size_t count = loop.points.size();
    const Place from = nearest(loop.points[run.first]);
    const Place to = nearest(loop.points[(run.first + run.count - 1) % count]);
    if (from.contour != to.contour) {
      throw Error(
          "the shapes could not be blended; change the radius a little");
    }
    const std::vector<gen::Segment>& list = edges_[from.contour].segments;
    is_kept.resize(contour.segments.size());
    size_t at = from.segment;
    double t = from.t;
    for (size_t i = 0; i <= list.size(); ++i) {
      const bool is_last = at == to.segment && (i > 0 || to.t >= from.t);
      const double end = is_last ? to.t : 1;
      if (end > t) {
        contour.segments.push_back(gen::part_of(list[at], t, end));
        is_kept.push_back(true);
      }
      if (is_last) {
        return;
      }
      at = (at + 1) % list.size();
      t = 0;
    }
  }

  Place nearest(const Point& p) const {
    Place best;
    for (size_t c = 0; c < edges_.size(); ++c) {
      for (size_t s = 0; s < edges_[c].segments.size(); ++s) {
        const gen::Segment& segment = edges_[c].segments[s];
        const int count = gen::chord_count(segment, kChordBound_u);
        for (int i = 0; i < count; ++i) {
          const double t = static_cast<double>(i) / count;
          const Point a = gen::point_on(segment, t);
          const Point b =
              gen::point_on(segment, static_cast<double>(i + 1) / count);
          const double d = distance_to_piece(p, a, b);
          if (d < best.distance) {
            const double square = dot(b - a, b - a);
            const double part =
                square == 0 ? 0
                            : std::clamp(dot(p - a, b - a) / square, 0.0, 1.0);
            best = {c, s, t + part / count, a + part * (b - a), d};
          }
        }
      }
    }
    return best;
  }

  // In whole font units, as the points of the union are.
  PointContour rounded(const gen::Contour& contour) const {
    gen::Contour result;
    for (gen::Segment segment : contour.segments) {
      for (Point& p : segment.p) {
        p = {std::round(p.x / scale_) + 0.0, std::round(p.y / scale_) + 0.0};
      }
      const bool is_point =
          same(segment.p[0], segment.p[gen::degree_of(segment)]);
      if (!is_point || gen::degree_of(segment) > 1) {
        result.segments.push_back(segment);
      }
    }
    return from_segments(result, 1);
  }

  double scale_;
  gen::Shape a_;
  gen::Shape b_;
  BlendField field_;
  std::vector<PointContour> union_;
  std::vector<gen::Contour> edges_;
};

}  // namespace

std::vector<PointContour> blended(const std::vector<PointContour>& a,
                                  const std::vector<PointContour>& b,
                                  double radius,
                                  double u_per_unit) {
  return Blender(a, b, radius, u_per_unit).run();
}

}  // namespace inkcell::design
