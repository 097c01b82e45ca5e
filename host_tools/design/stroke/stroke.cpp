#include "stroke/stroke.hpp"

#include <algorithm>
#include <cmath>

#include "model/error.hpp"
#include "outlines/curves.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "stroke/smooth_path.hpp"

namespace inkcell::design {
namespace {

// A path has a corner where it turns by more.
constexpr double kPathCorner = 60 * gen::kDegree;

// Polygons that stand for a curve turn by less over a short distance.
constexpr double kPolygonCorner = 0.2;
constexpr double kPolygonReach_u = 0.8;
constexpr double kPolygonSpacing_u = 1.5;

// A value of the nib at every point, interpolated between points that set it.
std::vector<double> spread(const Stroke& stroke,
                           std::optional<double> StrokePoint::*member,
                           double otherwise) {
  const std::vector<StrokePoint>& points = stroke.points;
  std::vector<Point> places;
  for (const StrokePoint& point : points) {
    places.push_back(point.at);
  }
  const std::vector<double> lengths = arc_lengths(places);
  std::vector<double> values(points.size(), otherwise);
  std::optional<size_t> last;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].*member)) {
      if (last) {
        values[i] = values[*last];
      }
      continue;
    }
    values[i] = *(points[i].*member);
    const size_t from = last.value_or(0);
    if (!last) {
      std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i),
                values[i]);
    }
    for (size_t k = from + 1; last && k < i; ++k) {
      const double span = lengths[i] - lengths[from];
      const double f = span == 0 ? 1 : (lengths[k] - lengths[from]) / span;
      values[k] = values[from] + f * (values[i] - values[from]);
    }
    last = i;
  }
  return values;
}

// A value at the knots of a path, and between them a monotone cubic through
// them without kinks (Fritsch and Carlson 1980).
class Easing {
 public:
  Easing(std::vector<double> values, const std::vector<double>& lengths)
      : values_(std::move(values)), lengths_(lengths) {
    const size_t pieces = lengths_.size();
    for (size_t i = 0; i <= pieces; ++i) {
      const double in = rise(i == 0 ? 0 : i - 1);
      const double out = rise(std::min(i, pieces - 1));
      if (in * out <= 0) {
        slopes_.push_back(0);
        continue;
      }
      // The harmonic mean, by the lengths of both sides.
      const double before = lengths_[i == 0 ? 0 : i - 1];
      const double after = lengths_[std::min(i, pieces - 1)];
      slopes_.push_back(
          3 * (before + after) /
          ((2 * after + before) / in + (after + 2 * before) / out));
    }
  }

  // At the parameter `t` of a piece.
  double at(size_t piece, double t) const {
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * values_[piece] +
           t * t * (1 + 2 * s) * values_[piece + 1] +
           lengths_[piece] * s * t *
               (s * slopes_[piece] - t * slopes_[piece + 1]);
  }

 private:
  double rise(size_t piece) const {
    return (values_[piece + 1] - values_[piece]) / lengths_[piece];
  }

  std::vector<double> values_;
  const std::vector<double>& lengths_;  // of pieces; above 0
  std::vector<double> slopes_;
};

// The same path in more pieces, along which nibs change almost smoothly.
NibPath with_eased_nibs(const NibPath& path) {
  constexpr int kParts = 8;
  std::vector<double> lengths;
  for (const gen::Segment& piece : path.pieces) {
    lengths.push_back(length(gen::point_on(piece, 1) - piece.p[0]));
  }
  const auto easing = [&](double Nib::*member) {
    std::vector<double> values;
    for (const Nib& nib : path.nibs) {
      values.push_back(nib.*member);
    }
    return Easing(std::move(values), lengths);
  };
  const Easing width = easing(&Nib::width);
  const Easing height = easing(&Nib::height);
  const Easing angle = easing(&Nib::angle);
  NibPath result;
  result.nibs.push_back(path.nibs[0]);
  for (size_t i = 0; i < path.pieces.size(); ++i) {
    const Nib& from = path.nibs[i];
    const Nib& to = path.nibs[i + 1];
    const bool changes = from.width != to.width || from.height != to.height ||
                         from.angle != to.angle;
    const int parts = changes ? kParts : 1;
    for (int k = 0; k < parts; ++k) {
      const double end = static_cast<double>(k + 1) / parts;
      result.pieces.push_back(
          parts == 1 ? path.pieces[i]
                     : gen::part_of(path.pieces[i],
                                    static_cast<double>(k) / parts, end));
      result.nibs.push_back(k + 1 == parts
                                ? to
                                : Nib{to.kind, width.at(i, end),
                                      height.at(i, end), angle.at(i, end)});
    }
  }
  return result;
}

StrokePoint point_of(const Value& value, double scale) {
  const bool ok = value.is_array() && value.size() >= 2 && value.size() <= 6 &&
                  value[0].is_number() && value[1].is_number() &&
                  (value.size() < 6 || value[5] == "corner");
  if (!ok) {
    throw Error(
        "points of a stroke are [x, y, width, height, angle, \"corner\"], the "
        "nib's numbers null or left out where nothing changes, not " +
        value.dump());
  }
  StrokePoint point;
  point.at = {scale * value[0].get<double>(), scale * value[1].get<double>()};
  const auto change = [&value](size_t i, double unit_size) {
    return i < value.size() && value[i].is_number()
               ? std::optional<double>(unit_size * value[i].get<double>())
               : std::nullopt;
  };
  point.width = change(2, scale);
  point.height = change(3, scale);
  point.angle = change(4, gen::kDegree);
  point.is_corner = value.size() > 5;
  return point;
}

}  // namespace

Stroke parse_stroke(const Value& value, double scale) {
  const bool ok = value.is_object() && value.contains("nib") &&
                  value["nib"].is_string() && value.contains("points") &&
                  value["points"].is_array() &&
                  value.value("smooth", Value(false)).is_boolean();
  if (!ok) {
    throw Error(
        "strokes are { \"nib\": \"ellipse:80,30,45\", \"points\": [...], "
        "\"smooth\": true }, the last false or left out unless the path goes "
        "through all points");
  }
  Stroke stroke;
  stroke.nib = parse_nib(value["nib"].get<std::string>());
  stroke.nib.width *= scale;
  stroke.nib.height *= scale;
  stroke.is_smooth = value.value("smooth", false);
  for (const Value& point : value["points"]) {
    stroke.points.push_back(point_of(point, scale));
  }
  return stroke;
}

std::vector<Nib> nibs_of(const Stroke& stroke) {
  const std::vector<double> width =
      spread(stroke, &StrokePoint::width, stroke.nib.width);
  const std::vector<double> height =
      spread(stroke, &StrokePoint::height, stroke.nib.height);
  const std::vector<double> angle =
      spread(stroke, &StrokePoint::angle, stroke.nib.angle);
  std::vector<Nib> nibs;
  for (size_t i = 0; i < stroke.points.size(); ++i) {
    nibs.push_back({stroke.nib.kind, width[i], height[i], angle[i]});
  }
  return nibs;
}

bool turns_sharply(const Point& before, const Point& at, const Point& after) {
  return std::fabs(turn(at - before, after - at)) > kPathCorner;
}

NibPath fit_path(const Stroke& stroke, double tolerance) {
  const std::vector<Nib> all = nibs_of(stroke);
  std::vector<StrokePoint> knots;
  std::vector<Point> points;
  std::vector<Nib> nibs;
  for (size_t i = 0; i < stroke.points.size(); ++i) {
    if (!points.empty() && length(points.back() - stroke.points[i].at) == 0) {
      continue;
    }
    knots.push_back(stroke.points[i]);
    points.push_back(stroke.points[i].at);
    nibs.push_back(all[i]);
  }
  NibPath path;
  if (points.size() == 1) {
    path.pieces = {gen::line_segment(points[0], points[0])};
    path.nibs = {nibs[0], nibs[0]};
    return path;
  }
  if (stroke.is_smooth) {
    return {smooth_path(knots), nibs};
  }
  size_t first = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    const bool is_corner =
        i + 1 == points.size() ||
        turns_sharply(points[i - 1], points[i], points[i + 1]);
    if (!is_corner) {
      continue;
    }
    const std::vector<Point> piece(
        points.begin() + static_cast<std::ptrdiff_t>(first),
        points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    std::vector<size_t> ends;
    for (const gen::Segment& segment : fit_open(piece, tolerance, ends)) {
      path.pieces.push_back(segment);
    }
    if (path.nibs.empty()) {
      path.nibs.push_back(nibs[first]);
    }
    for (const size_t end : ends) {
      path.nibs.push_back(nibs[first + end]);
    }
    first = i;
  }
  return path;
}

std::vector<std::vector<Point>> polygons_of(const Stroke& stroke,
                                            double path_tolerance) {
  const NibPath path = fit_path(stroke, path_tolerance);
  const bool eases = stroke.is_smooth && path.nibs.size() > 2;
  return sweep(places_on(eases ? with_eased_nibs(path) : path));
}

gen::Outline outline_of_polygons(
    const std::vector<std::vector<Point>>& polygons) {
  gen::Outline outline;
  for (const std::vector<Point>& polygon : polygons) {
    gen::Contour contour;
    for (size_t i = 0; i < polygon.size(); ++i) {
      contour.segments.push_back(
          gen::line_segment(polygon[i], polygon[(i + 1) % polygon.size()]));
    }
    outline.contours.push_back(std::move(contour));
  }
  return outline;
}

gen::Outline fit_polygons(const std::vector<std::vector<Point>>& polygons,
                          double tolerance) {
  CornerOptions corners;
  corners.reach = kPolygonReach_u;
  corners.turn = kPolygonCorner;
  corners.is_exact = true;
  std::vector<Loop> loops;
  for (const std::vector<Point>& polygon : polygons) {
    loops.push_back(sample_polygon(polygon, kPolygonSpacing_u));
    find_corners(corners, loops.back());
  }
  FitOptions options;
  options.tolerance = tolerance;
  return fit_loops(loops, options);
}

}  // namespace inkcell::design
