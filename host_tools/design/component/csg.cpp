#include "component/csg.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "fit/vectors.hpp"
#include "model/arguments.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "shape/outline.hpp"
#include "stroke/stroke.hpp"
#include "trace/contour_walk.hpp"

namespace inkcell::design {
namespace {

constexpr double kClipperUnits_per_u = 65536;
constexpr int kMostDepth = 16;

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
  const auto distance = [&](const Point& p) {
    const double da = a.distance(p.x, p.y);
    const double db = b.distance(p.x, p.y);
    const double h = std::max(k - std::fabs(da - db), 0.0);
    return std::max(da, db) + h * h / (4 * k);
  };
  // A blend reaches a quarter of k beyond both.
  const double reach = k / 4 + 2;
  const gen::Box box = {std::min(a.box().x0, b.box().x0) - reach,
                        std::min(a.box().y0, b.box().y0) - reach,
                        std::max(a.box().x1, b.box().x1) + reach,
                        std::max(a.box().y1, b.box().y1) + reach};
  std::vector<std::vector<Point>> polygons;
  for (const Loop& loop : walk_contours(distance, box)) {
    polygons.push_back(loop.points);
  }
  return gen::Shape(outline_of_polygons(polygons));
}

gen::Shape shape_of_node(const Project& project,
                         size_t layer,
                         const Value& node,
                         int depth);

gen::Shape shape_of_leaf(const Project& project,
                         size_t layer,
                         const Value& leaf) {
  ComponentUse use;
  use.base = leaf.at("glyph").get<std::string>();
  if (leaf.contains("matrix")) {
    const Value command = {{"do", "tree"}, {"matrix", leaf["matrix"]}};
    use.matrix = Arguments(command).matrix("matrix");
  }
  Glyph glyph;
  glyph.components.push_back(use);
  return gen::Shape(outline_of(project, glyph, layer));
}

gen::Shape shape_of_operator(const Project& project,
                             size_t layer,
                             const Value& node,
                             int depth) {
  const std::string op = node.value("op", "");
  const std::pair<const char*, Combination> names[] = {
      {"union", Combination::unite},
      {"intersection", Combination::intersect},
      {"difference", Combination::subtract},
      {"blend", Combination::blend}};
  const auto found =
      std::find_if(std::begin(names), std::end(names),
                   [&op](const auto& entry) { return op == entry.first; });
  if (found == std::end(names)) {
    throw Error("operator '" + op +
                "' of a tree is not known; use union, intersection, "
                "difference or blend");
  }
  const double radius =
      node.value("radius", 0.0) * gen::kUPerEm / project.units_per_em();
  if (found->second == Combination::blend && !(radius > 0)) {
    throw Error("a blend has a \"radius\" above 0, in font units");
  }
  const Value& parts = node.at("parts");
  if (!parts.is_array() || parts.size() < 2) {
    throw Error("\"" + op + "\" of a tree has two or more \"parts\"");
  }
  gen::Shape shape = shape_of_node(project, layer, parts[0], depth - 1);
  for (size_t i = 1; i < parts.size(); ++i) {
    shape = combine(shape, shape_of_node(project, layer, parts[i], depth - 1),
                    found->second, radius);
  }
  return shape;
}

gen::Shape shape_of_node(const Project& project,
                         size_t layer,
                         const Value& node,
                         int depth) {
  if (depth == 0) {
    throw Error("a tree of shapes is at most 16 levels deep");
  }
  try {
    return node.is_object() && node.contains("glyph")
               ? shape_of_leaf(project, layer, node)
               : shape_of_operator(project, layer, node, depth);
  } catch (const Value::exception& error) {
    throw Error(std::string("a tree of shapes is { \"op\", \"parts\" } or { "
                            "\"glyph\", \"matrix\" }: ") +
                error.what());
  }
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

gen::Shape shape_of_tree(const Project& project,
                         size_t layer,
                         const Value& tree) {
  return shape_of_node(project, layer, tree, kMostDepth);
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
