#include "stroke/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr double kClipperUnits_per_u = 65536;

// The most halvings of a piece of a path.
constexpr int kMostHalvings = 12;

IntPoint to_clipper(const Point& p) {
  if (!(std::fabs(p.x) <= gen::kCoordinateLimit &&
        std::fabs(p.y) <= gen::kCoordinateLimit)) {
    throw gen::GeometryError(gen::GeometryError::Kind::bad_coordinates,
                             "a stroke leaves the plane of 14 em");
  }
  return {std::llround(p.x * kClipperUnits_per_u),
          std::llround(p.y * kClipperUnits_per_u)};
}

// Exact: coordinates have 30 bits, products 62.
ClipperLib::cInt area(const IntPoint& o, const IntPoint& a, const IntPoint& b) {
  return (a.X - o.X) * (b.Y - o.Y) - (a.Y - o.Y) * (b.X - o.X);
}

// Andrew's monotone chain; counter-clockwise.
Path hull(Path points) {
  std::sort(points.begin(), points.end(),
            [](const IntPoint& a, const IntPoint& b) {
              return a.X != b.X ? a.X < b.X : a.Y < b.Y;
            });
  Path result(2 * points.size() + 1);
  size_t n = 0;
  for (const IntPoint& p : points) {
    while (n >= 2 && area(result[n - 2], result[n - 1], p) <= 0) {
      --n;
    }
    result[n++] = p;
  }
  const size_t lower = n + 1;
  for (size_t i = points.size() - 1; i-- > 0;) {
    while (n >= lower && area(result[n - 2], result[n - 1], points[i]) <= 0) {
      --n;
    }
    result[n++] = points[i];
  }
  result.resize(n > 1 ? n - 1 : n);
  return result;
}

Paths unite(const Paths& a, const Paths& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(a, ClipperLib::ptSubject, true);
  clipper.AddPaths(b, ClipperLib::ptSubject, true);
  Paths result;
  bool done = false;
  try {
    done = clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero,
                           ClipperLib::pftNonZero);
  } catch (const ClipperLib::clipperException&) {
    done = false;
  }
  if (!done) {
    throw gen::GeometryError(gen::GeometryError::Kind::not_united,
                             "the parts of a stroke could not be united");
  }
  return result;
}

// Unites halves first, so that covered parts disappear early.
Paths unite_range(const Paths& hulls, size_t first, size_t count) {
  if (count == 1) {
    return {hulls[first]};
  }
  return unite(unite_range(hulls, first, count / 2),
               unite_range(hulls, first + count / 2, count - count / 2));
}

double half(double size) {
  return std::max(size, kLeastNib_u) / 2;
}

// The part beside the line `at` in x or y, on the side of `sign`.
std::vector<Point> clip(const std::vector<Point>& polygon,
                        double Point::*axis,
                        double at,
                        double sign) {
  std::vector<Point> result;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a.*axis - at);
    const double db = sign * (b.*axis - at);
    if (da >= 0) {
      result.push_back(a);
    }
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      result.push_back(a + da / (da - db) * (b - a));
    }
  }
  return result;
}

// Divides each polygon at the lines. The parts overlap a little, so that
// rounding leaves no gap.
std::vector<std::vector<Point>> divide(
    const std::vector<std::vector<Point>>& parts,
    double Point::*axis,
    const std::array<double, 2>& lines) {
  constexpr double kOverlap = 1e-3;
  std::vector<std::vector<Point>> result = parts;
  for (const double line : lines) {
    if (!(std::fabs(line) < 1)) {
      continue;
    }
    std::vector<std::vector<Point>> divided;
    for (const std::vector<Point>& part : result) {
      for (const double sign : {-1.0, 1.0}) {
        std::vector<Point> side =
            clip(part, axis, line - sign * kOverlap, sign);
        if (side.size() >= 3) {
          divided.push_back(std::move(side));
        }
      }
    }
    result = std::move(divided);
  }
  return result;
}

// Lines across a nib of size 2 x 2, in its coordinates.
struct StillLines {
  std::array<double, 2> x;
  std::array<double, 2> y;
};

// The points of a turning nib that stand still between a and b.
StillLines still_lines(const NibPlace& a, const NibPlace& b) {
  const double turned = b.nib.angle - a.nib.angle;
  const double angle = (a.nib.angle + b.nib.angle) / 2;
  const Point along = {std::cos(angle), std::sin(angle)};
  const Point step = b.at - a.at;
  const double forth = dot(step, along);
  const double aside = cross(along, step);
  const double wider = half(b.nib.width) - half(a.nib.width);
  const double higher = half(b.nib.height) - half(a.nib.height);
  const double width = (half(a.nib.width) + half(b.nib.width)) / 2;
  const double height = (half(a.nib.height) + half(b.nib.height)) / 2;
  const double x = -1 / (turned * width);
  const double y = 1 / (turned * height);
  return {{x * (aside + higher), x * (aside - higher)},
          {y * (forth + wider), y * (forth - wider)}};
}

// The hull of a turning nib is too large near the point that stands still: one
// end of the nib moves forwards, the other backwards. So the nib is divided
// there. `profile` is the nib of size 2 x 2.
std::vector<std::vector<Point>> parts_of_turn(
    const NibPlace& a, const NibPlace& b, const std::vector<Point>& profile) {
  if (b.nib.angle == a.nib.angle) {
    return {profile};
  }
  const StillLines lines = still_lines(a, b);
  return divide(divide({profile}, &Point::x, lines.x), &Point::y, lines.y);
}

IntPoint placed(const NibPlace& place, const Point& p) {
  const Point along = {std::cos(place.nib.angle), std::sin(place.nib.angle)};
  const Point across = {-along.y, along.x};
  return to_clipper(place.at + half(place.nib.width) * p.x * along +
                    half(place.nib.height) * p.y * across);
}

void add_hulls(const NibPlace& a,
               const NibPlace& b,
               const std::vector<Point>& profile,
               Paths& hulls) {
  for (const std::vector<Point>& part : parts_of_turn(a, b, profile)) {
    Path both;
    for (const Point& p : part) {
      both.push_back(placed(a, p));
      both.push_back(placed(b, p));
    }
    hulls.push_back(hull(std::move(both)));
  }
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

// How far the still lines move on the nib between t0 and t1. [u] On a fast nib
// that turns slowly they cross it within a small part of a step, perhaps near
// an end. So this compares the lines of both ends, which are those of very
// short steps, and the lines of both halves.
double shift_of_lines(const NibPath& path, size_t piece, double t0, double t1) {
  constexpr double kShort = 1.0 / 1024;
  const NibPlace a = place_on(path, piece, t0);
  const NibPlace middle = place_on(path, piece, mix(t0, t1, 0.5));
  const NibPlace b = place_on(path, piece, t1);
  const std::array<StillLines, 4> lines = {
      still_lines(a, place_on(path, piece, mix(t0, t1, kShort))),
      still_lines(a, middle), still_lines(middle, b),
      still_lines(place_on(path, piece, mix(t0, t1, 1 - kShort)), b)};
  const double width = std::max(half(a.nib.width), half(b.nib.width));
  const double height = std::max(half(a.nib.height), half(b.nib.height));
  const auto shift = [&](std::array<double, 2> StillLines::*axis, size_t i) {
    double low = 1;
    double high = -1;
    for (const StillLines& line : lines) {
      const double at = std::clamp((line.*axis)[i], -1.0, 1.0);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    return high - low;
  };
  double most = 0;
  for (size_t i = 0; i < 2; ++i) {
    most = std::max({most, width * shift(&StillLines::x, i),
                     height * shift(&StillLines::y, i)});
  }
  return most;
}

// The hull of two ellipses contains wider ones than those with axes in between:
// an upper bound of the difference, in the middle. [u]
double excess_of_ellipses(const Nib& a, const Nib& b) {
  constexpr int kDirections = 16;
  double most = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 1.5707963267948966 * i / (kDirections - 1);
    const auto support = [angle](double width, double height) {
      return std::hypot(width * std::cos(angle), height * std::sin(angle));
    };
    const double between = support((half(a.width) + half(b.width)) / 2,
                                   (half(a.height) + half(b.height)) / 2);
    most = std::max(most, (support(half(a.width), half(a.height)) +
                           support(half(b.width), half(b.height))) /
                                  2 -
                              between);
  }
  return most;
}

// The distance of the corners of a nib from their chords if it changes as it
// turns.
double bend_of_corners(const Nib& a, const Nib& b) {
  const double radius =
      std::hypot(std::max(a.width, b.width), std::max(a.height, b.height)) / 2;
  const double turned = std::fabs(b.angle - a.angle);
  const double grown = std::hypot(half(b.width) - half(a.width),
                                  half(b.height) - half(a.height));
  return radius * (1 - std::cos(std::min(turned, 3.0) / 2)) +
         grown * turned / 4;
}

// Whether the nibs between t0 and t1 are near the hull of both ends. Also
// checks the quarters, as a curve with two bends crosses its chord in the
// middle.
bool is_near(const NibPath& path, size_t piece, double t0, double t1) {
  const NibPlace a = place_on(path, piece, t0);
  const NibPlace b = place_on(path, piece, t1);
  double sagitta = 0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const Point at = place_on(path, piece, mix(t0, t1, part)).at;
    sagitta = std::max(sagitta, length(at - a.at - part * (b.at - a.at)));
  }
  double error = sagitta + bend_of_corners(a.nib, b.nib);
  if (a.nib.kind == Nib::Kind::ellipse) {
    error += excess_of_ellipses(a.nib, b.nib);
  }
  const double turned = std::fabs(b.nib.angle - a.nib.angle);
  if (error >= kSweepBound_u / 2) {
    return false;
  }
  // A side tilts by turned / 2 from its mean, about a line that moves by up to
  // the shift: the hull is too large by half of the product.
  return turned == 0 ||
         turned / 2 * shift_of_lines(path, piece, t0, t1) < kSweepBound_u / 4;
}

void add_between(const NibPath& path,
                 size_t piece,
                 double t0,
                 double t1,
                 int halvings,
                 std::vector<NibPlace>& places) {
  if (halvings == 0 || is_near(path, piece, t0, t1)) {
    places.push_back(place_on(path, piece, t1));
    return;
  }
  const double middle = (t0 + t1) / 2;
  add_between(path, piece, t0, middle, halvings - 1, places);
  add_between(path, piece, middle, t1, halvings - 1, places);
}

}  // namespace

NibPlace place_on(const NibPath& path, size_t piece, double t) {
  const Nib& a = path.nibs[piece];
  const Nib& b = path.nibs[piece + 1];
  NibPlace result;
  result.at = gen::point_on(path.pieces[piece], t);
  result.nib.kind = a.kind;
  result.nib.width = mix(a.width, b.width, t);
  result.nib.height = mix(a.height, b.height, t);
  result.nib.angle = mix(a.angle, b.angle, t);
  return result;
}

std::vector<NibPlace> places_on(const NibPath& path) {
  std::vector<NibPlace> places;
  if (path.nibs.empty() || path.pieces.empty()) {
    return places;
  }
  places.push_back(place_on(path, 0, 0));
  for (size_t i = 0; i < path.pieces.size(); ++i) {
    add_between(path, i, 0, 1, kMostHalvings, places);
  }
  return places;
}

std::vector<std::vector<Point>> sweep(const std::vector<NibPlace>& places) {
  std::vector<std::vector<Point>> result;
  if (places.empty()) {
    return result;
  }
  int corners = 0;
  for (const NibPlace& p : places) {
    corners = std::max(corners, corner_count(p.nib, kSweepBound_u / 2));
  }
  const std::vector<Point> profile =
      nib_polygon({places[0].nib.kind, 2, 2, 0}, corners);
  Paths hulls;
  for (size_t i = 0; i + 1 < places.size() || i == 0; ++i) {
    add_hulls(places[i], places[std::min(i + 1, places.size() - 1)], profile,
              hulls);
  }
  // Smaller areas are slivers left by rounding.
  const double least_area =
      std::pow(kSweepBound_u * kClipperUnits_per_u / 4, 2);
  for (const Path& path : unite_range(hulls, 0, hulls.size())) {
    std::vector<Point> polygon;
    for (const IntPoint& p : path) {
      polygon.push_back({static_cast<double>(p.X) / kClipperUnits_per_u,
                         static_cast<double>(p.Y) / kClipperUnits_per_u});
    }
    if (std::fabs(ClipperLib::Area(path)) > least_area) {
      result.push_back(std::move(polygon));
    }
  }
  return result;
}

}  // namespace inkcell::design
