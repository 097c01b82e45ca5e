#include "shape/shape.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "shape/clipper_units.hpp"
#include "shape/flatten.hpp"

namespace inkcell::gen {
namespace {

constexpr uint32_t kEdgesPerLeaf = 6;

// Smaller contours are residues of accidental crossings, as in variable fonts:
// the width is less than a font unit of most fonts, the area 1/64 of a pixel at
// 64 px/em. Their border would show as a speck of half the intensity.
constexpr double kLeastArea = 4;  // [u^2]
constexpr double kLeastWidth_u = 1.0 / 8;

// Height of the bands that index edges by y. [u]
constexpr double kRowHeight_u = 4;

ClipperLib::Path to_clipper(const std::vector<Point>& polygon) {
  ClipperLib::Path path;
  path.reserve(polygon.size());
  for (const Point& p : polygon) {
    path.push_back(gen::to_clipper(p));
  }
  return path;
}

// The outer borders counter-clockwise, the holes clockwise.
ClipperLib::Paths unite(const Outline& outline) {
  ClipperLib::Clipper clipper;
  bool any = false;
  for (const Contour& contour : outline.contours) {
    const ClipperLib::Path path = to_clipper(flatten(contour));
    if (path.size() >= 3) {
      // False for a path without area, which may be dropped.
      any |= clipper.AddPath(path, ClipperLib::ptSubject, true);
    }
  }
  if (!any) {
    return {};  // Execute would report failure
  }
  return executed(clipper, ClipperLib::ctUnion,
                  "the contours could not be united");
}

// The mean width is that of a narrow rectangle with the same border.
bool is_sliver(const ClipperLib::Path& path) {
  const double area = std::fabs(ClipperLib::Area(path)) /
                      (kClipperUnits_per_u * kClipperUnits_per_u);
  double border_u = 0;
  for (size_t i = 0; i < path.size(); ++i) {
    border_u += length(from_clipper(path[(i + 1) % path.size()]) -
                       from_clipper(path[i]));
  }
  return area < kLeastArea && 2 * area < kLeastWidth_u * border_u;
}

Box box_of(const std::vector<Edge>& edges, size_t first, size_t count) {
  Box box = kNoBox;
  for (size_t i = first; i < first + count; ++i) {
    box.add(edges[i].a);
    box.add(edges[i].b);
  }
  return box;
}

double squared(double x, double y) {
  return x * x + y * y;
}

double squared_distance(const Box& box, double x, double y) {
  return squared(std::max({box.x0 - x, x - box.x1, 0.0}),
                 std::max({box.y0 - y, y - box.y1, 0.0}));
}

// Half open: a line through a corner meets one of the two edges, both or none,
// so the number of crossings stays even.
bool crosses(const Edge& edge, double y) {
  return (edge.a.y <= y) != (edge.b.y <= y);
}

double crossing(const Edge& edge, double y) {
  return edge.a.x +
         (y - edge.a.y) * (edge.b.x - edge.a.x) / (edge.b.y - edge.a.y);
}

}  // namespace

Box box_of(const std::vector<std::vector<Point>>& lines) {
  Box box = kNoBox;
  for (const std::vector<Point>& line : lines) {
    for (const Point& p : line) {
      box.add(p);
    }
  }
  return box;
}

Shape::Shape(const Outline& outline) {
  for (const ClipperLib::Path& path : unite(outline)) {
    if (is_sliver(path)) {
      continue;
    }
    for (size_t i = 0; i < path.size(); ++i) {
      const ClipperLib::IntPoint& next = path[(i + 1) % path.size()];
      if (path[i] != next) {
        edges_.push_back({from_clipper(path[i]), from_clipper(next)});
      }
    }
  }
  if (edges_.empty()) {
    return;
  }
  box_ = box_of(edges_, 0, edges_.size());
  build_tree(0, 0, static_cast<uint32_t>(edges_.size()));
  build_rows();
}

// Consecutive edges are close to each other, so halving the range gives a good
// tree without sorting.
void Shape::build_tree(size_t node, uint32_t first, uint32_t count) {
  if (tree_.size() <= node) {
    tree_.resize(node + 1);
  }
  tree_[node] = {box_of(edges_, first, count), first, count};
  if (count <= kEdgesPerLeaf) {
    return;
  }
  build_tree(2 * node + 1, first, count / 2);
  build_tree(2 * node + 2, first + count / 2, count - count / 2);
}

void Shape::build_rows() {
  const double height = box_.y1 - box_.y0;
  const size_t rows = static_cast<size_t>(height / kRowHeight_u) + 1;
  row_height_ = kRowHeight_u;
  std::vector<std::vector<uint32_t>> lists(rows);
  for (size_t i = 0; i < edges_.size(); ++i) {
    const double low = std::min(edges_[i].a.y, edges_[i].b.y) - box_.y0;
    const double high = std::max(edges_[i].a.y, edges_[i].b.y) - box_.y0;
    const size_t last = static_cast<size_t>(high / row_height_);
    for (size_t row = static_cast<size_t>(low / row_height_); row <= last;
         ++row) {
      lists[row].push_back(static_cast<uint32_t>(i));
    }
  }
  for (const std::vector<uint32_t>& list : lists) {
    row_starts_.push_back(static_cast<uint32_t>(row_edges_.size()));
    row_edges_.insert(row_edges_.end(), list.begin(), list.end());
  }
  row_starts_.push_back(static_cast<uint32_t>(row_edges_.size()));
}

double Shape::distance(double x, double y) const {
  if (empty()) {
    return -kInfinity;
  }
  double best = kInfinity;
  // A range is halved at each level: 32 levels hold any count.
  size_t pending[64];
  size_t depth = 0;
  pending[depth++] = 0;
  while (depth > 0) {
    const size_t node = pending[--depth];
    const Branch& branch = tree_[node];
    if (squared_distance(branch.box, x, y) >= best) {
      continue;
    }
    if (branch.count <= kEdgesPerLeaf) {
      for (uint32_t i = 0; i < branch.count; ++i) {
        best = std::min(best, squared_distance_to_segment(
                                  {x, y}, edges_[branch.first + i].a,
                                  edges_[branch.first + i].b));
      }
      continue;
    }
    // The nearer half comes from the stack first.
    size_t near = 2 * node + 1;
    size_t far = 2 * node + 2;
    if (squared_distance(tree_[far].box, x, y) <
        squared_distance(tree_[near].box, x, y)) {
      std::swap(near, far);
    }
    pending[depth++] = far;
    pending[depth++] = near;
  }
  return inside(x, y) ? std::sqrt(best) : -std::sqrt(best);
}

bool Shape::inside(double x, double y) const {
  if (empty() || !(y >= box_.y0 && y <= box_.y1)) {
    return false;
  }
  const size_t row = static_cast<size_t>((y - box_.y0) / row_height_);
  bool odd = false;
  for (uint32_t i = row_starts_[row]; i < row_starts_[row + 1]; ++i) {
    const Edge& edge = edges_[row_edges_[i]];
    if (crosses(edge, y) && crossing(edge, y) <= x) {
      odd = !odd;
    }
  }
  return odd;
}

void Shape::crossings(double y, std::vector<double>& out) const {
  out.clear();
  if (empty() || !(y >= box_.y0 && y <= box_.y1)) {
    return;
  }
  const size_t row = static_cast<size_t>((y - box_.y0) / row_height_);
  for (uint32_t i = row_starts_[row]; i < row_starts_[row + 1]; ++i) {
    const Edge& edge = edges_[row_edges_[i]];
    if (crosses(edge, y)) {
      out.push_back(crossing(edge, y));
    }
  }
  std::sort(out.begin(), out.end());
}

}  // namespace inkcell::gen
