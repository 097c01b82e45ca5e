#include "shape/difference.hpp"

#include <polyclipping/clipper.hpp>

#include "shape/clipper_units.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

void add_border(const Shape& shape,
                ClipperLib::PolyType role,
                ClipperLib::Clipper& clipper) {
  const std::vector<Edge>& edges = shape.edges();
  ClipperLib::Path path;
  for (size_t first = 0, i = 0; i < edges.size(); ++i) {
    path.push_back(to_clipper(edges[i].a));
    if (edges[i].b == edges[first].a) {
      clipper.AddPath(path, role, true);
      path.clear();
      first = i + 1;
    }
  }
}

}  // namespace

std::vector<std::vector<Point>> difference(const Shape& a, const Shape& b) {
  ClipperLib::Clipper clipper;
  add_border(a, ClipperLib::ptSubject, clipper);
  add_border(b, ClipperLib::ptClip, clipper);
  std::vector<std::vector<Point>> polygons;
  for (const ClipperLib::Path& path :
       executed(clipper, ClipperLib::ctDifference,
                "two areas could not be compared")) {
    polygons.emplace_back();
    for (const ClipperLib::IntPoint& p : path) {
      polygons.back().push_back(from_clipper(p));
    }
  }
  return polygons;
}

}  // namespace inkcell::gen
