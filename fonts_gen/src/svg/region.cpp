#include "svg/region.hpp"

#include <algorithm>
#include <cmath>

#include "shape/clipper_units.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Areas that differ by less are equal. [u^2]
constexpr double kSameArea = 0.05;

// Contours with less area are slivers, from rounding. [u^2]
constexpr double kSliver = 0.01;

// The winding number is examined at this distance from a contour. [u]
constexpr double kAside_u = 1.0 / 1024;

ClipperLib::Path to_clipper(const Corners& polygon) {
  ClipperLib::Path path;
  for (const Point& p : polygon) {
    if (!(std::fabs(p.x) <= kCoordinateLimit &&
          std::fabs(p.y) <= kCoordinateLimit)) {
      throw GeometryError(GeometryError::Kind::bad_coordinates,
                          "a stroke reaches too far from the origin");
    }
    path.push_back(to_clipper(p));
  }
  return path;
}

ClipperLib::Paths to_clipper(const Outline& outline) {
  ClipperLib::Paths paths;
  for (const Contour& contour : outline.contours) {
    paths.push_back(to_clipper(flatten(contour)));
  }
  return paths;
}

ClipperLib::Paths combine(ClipperLib::ClipType type,
                          const ClipperLib::Paths& a,
                          ClipperLib::PolyFillType rule,
                          const ClipperLib::Paths& b = {}) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(a, ClipperLib::ptSubject, true);
  clipper.AddPaths(b, ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(type, result, rule, ClipperLib::pftNonZero);
  return result;
}

ClipperLib::Paths unite(const ClipperLib::Paths& paths,
                        ClipperLib::PolyFillType rule) {
  return combine(ClipperLib::ctUnion, paths, rule);
}

// [u^2]
double area_of(const ClipperLib::Paths& paths) {
  double sum = 0;
  for (const ClipperLib::Path& path : paths) {
    sum += ClipperLib::Area(path);
  }
  return std::fabs(sum) / (kClipperUnits_per_u * kClipperUnits_per_u);
}

// Whether an area has a winding number of this kind.
bool has(ClipperLib::PolyFillType kind, const ClipperLib::Paths& paths) {
  return area_of(unite(paths, kind)) > kSameArea;
}

Outline without_slivers(ClipperLib::Paths paths) {
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                             [](const ClipperLib::Path& path) {
                               return area_of({path}) < kSliver;
                             }),
              paths.end());
  return outline_of(paths);
}

void reverse(Contour& contour) {
  std::reverse(contour.segments.begin(), contour.segments.end());
  for (Segment& segment : contour.segments) {
    std::reverse(segment.p, segment.p + degree_of(segment) + 1);
  }
}

int winding(const std::vector<Corners>& polygons, const Point& at) {
  int sum = 0;
  for (const Corners& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= at.y) != (b.y <= at.y) &&
          a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y) > at.x) {
        sum += b.y > a.y ? 1 : -1;
      }
    }
  }
  return sum;
}

bool is_filled(int winding, FillRule rule) {
  return rule == FillRule::evenodd ? winding % 2 != 0 : winding != 0;
}

// Orients each contour with its ink on the left, and drops contours with ink on
// both sides or none. Examines both sides of the longest chords: exact for
// contours that do not cross.
Outline directed(const Outline& contours, FillRule rule) {
  std::vector<Corners> polygons;
  for (const Contour& contour : contours.contours) {
    polygons.push_back(flatten(contour));
  }
  Outline result;
  for (size_t i = 0; i < polygons.size(); ++i) {
    const Corners& polygon = polygons[i];
    Point a;
    Point b;
    for (size_t k = 0; k < polygon.size(); ++k) {
      const Point& next = polygon[(k + 1) % polygon.size()];
      if (length(next - polygon[k]) > length(b - a)) {
        a = polygon[k];
        b = next;
      }
    }
    const Point along = direction(b - a);
    const Point aside = kAside_u * Point{-along.y, along.x};
    const Point on = middle(a, b);
    const bool is_left = is_filled(winding(polygons, on + aside), rule);
    const bool is_right = is_filled(winding(polygons, on - aside), rule);
    if (is_left != is_right) {
      result.contours.push_back(contours.contours[i]);
      if (is_right) {
        reverse(result.contours.back());
      }
    }
  }
  return result;
}

}  // namespace

Outline filled_area(const Outline& contours, FillRule rule) {
  const ClipperLib::Paths paths = to_clipper(contours);
  if (rule == FillRule::nonzero && !has(ClipperLib::pftNegative, paths)) {
    return contours;
  }
  if (rule == FillRule::nonzero && !has(ClipperLib::pftPositive, paths)) {
    Outline turned = contours;
    std::for_each(turned.contours.begin(), turned.contours.end(), reverse);
    return turned;
  }
  const ClipperLib::Paths wanted =
      unite(paths, rule == FillRule::nonzero ? ClipperLib::pftNonZero
                                             : ClipperLib::pftEvenOdd);
  Outline result = directed(contours, rule);
  const ClipperLib::Paths got = to_clipper(result);
  const double difference =
      area_of(combine(ClipperLib::ctXor, got, ClipperLib::pftNonZero, wanted));
  const bool is_same =
      difference <= kSameArea && !has(ClipperLib::pftNegative, got);
  return is_same ? result : without_slivers(wanted);
}

Outline united_area(const std::vector<Corners>& polygons) {
  ClipperLib::Paths paths;
  for (const Corners& polygon : polygons) {
    paths.push_back(to_clipper(polygon));
    if (!ClipperLib::Orientation(paths.back())) {
      std::reverse(paths.back().begin(), paths.back().end());
    }
  }
  return without_slivers(unite(paths, ClipperLib::pftNonZero));
}

bool fill_alike(const Outline& a, const Outline& b, double slack) {
  const ClipperLib::Paths difference = combine(
      ClipperLib::ctXor, to_clipper(a), ClipperLib::pftNonZero, to_clipper(b));
  ClipperLib::ClipperOffset inset;
  inset.AddPaths(difference, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths rest;
  inset.Execute(rest, -slack * kClipperUnits_per_u);
  return rest.empty();
}

}  // namespace inkcell::gen
