#include "component/csg.hpp"

#include "component/blend_field.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "fit/vectors.hpp"
#include "shape/outline.hpp"
#include "stroke/stroke.hpp"
#include "trace/contour_walk.hpp"

namespace inkcell::design {
namespace {

constexpr double kClipperUnits_per_u = 65536;

ClipperLib::Paths paths_of(const gen::Shape& shape) {
  ClipperLib::Paths paths;
  for (const std::vector<Point>& polygon : polygons_of(shape)) {
    ClipperLib::Path path;
    for (const Point& p : polygon) {
      path.emplace_back(std::llround(p.x * kClipperUnits_per_u),
                        std::llround(p.y * kClipperUnits_per_u));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

gen::Shape clipped(const gen::Shape& a,
                   const gen::Shape& b,
                   ClipperLib::ClipType type) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths_of(a), ClipperLib::ptSubject, true);
  clipper.AddPaths(paths_of(b), ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  if (!clipper.Execute(type, result, ClipperLib::pftNonZero,
                       ClipperLib::pftNonZero)) {
    throw gen::GeometryError(gen::GeometryError::Kind::not_united,
                             "the shapes could not be combined");
  }
  std::vector<std::vector<Point>> polygons;
  for (const ClipperLib::Path& path : result) {
    std::vector<Point> polygon;
    for (const ClipperLib::IntPoint& p : path) {
      polygon.push_back({static_cast<double>(p.X) / kClipperUnits_per_u,
                         static_cast<double>(p.Y) / kClipperUnits_per_u});
    }
    polygons.push_back(std::move(polygon));
  }
  return gen::Shape(outline_of_polygons(polygons));
}

gen::Shape blended(const gen::Shape& a, const gen::Shape& b, double k) {
  const BlendField field(a, b, k);
  const auto distance = [&field](const Point& p) { return field.distance(p); };
  std::vector<std::vector<Point>> polygons;
  for (const Loop& loop : walk_contours(distance, field.box())) {
    polygons.push_back(loop.points);
  }
  return gen::Shape(outline_of_polygons(polygons));
}

}  // namespace

gen::Shape combine(const gen::Shape& a,
                   const gen::Shape& b,
                   Combination combination,
                   double radius_u) {
  switch (combination) {
    case Combination::intersect:
      return clipped(a, b, ClipperLib::ctIntersection);
    case Combination::subtract:
      return clipped(a, b, ClipperLib::ctDifference);
    case Combination::blend:
      if (!a.empty() && !b.empty()) {
        return blended(a, b, radius_u);
      }
      break;
    case Combination::unite:
      break;
  }
  return clipped(a, b, ClipperLib::ctUnion);
}

std::vector<std::vector<Point>> polygons_of(const gen::Shape& shape) {
  std::vector<std::vector<Point>> polygons;
  bool is_closed = true;
  for (const gen::Edge& edge : shape.edges()) {
    if (is_closed) {
      polygons.emplace_back();
    }
    polygons.back().push_back(edge.a);
    is_closed = same(edge.b, polygons.back().front());
  }
  return polygons;
}

}  // namespace inkcell::design
