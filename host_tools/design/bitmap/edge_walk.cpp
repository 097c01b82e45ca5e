#include "bitmap/edge_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fit/curve_fitter.hpp"
#include "model/error.hpp"

namespace inkcell::design {
namespace {

constexpr double kHalf = 127.5;

// Stairs are averaged over this many steps to both sides: more give smoother
// edges, but shrink curves of a radius of 20 px by 0.3 px.
constexpr int kSteps = 5;
constexpr int kGreySteps = 1;

// Walks the squares between four pixel centres; corner (x, y) is the upper
// left. Corners and sides are numbered counter-clockwise in the picture, y
// down, so ink is to the left of the edge.
class EdgeWalker {
 public:
  EdgeWalker(const Bitmap& bitmap, bool is_bilevel)
      : bitmap_(bitmap),
        is_bilevel_(is_bilevel),
        width_(bitmap.width + 1),
        visited_(static_cast<size_t>(width_) *
                     static_cast<size_t>(bitmap.height + 1),
                 0) {}

  // In pixels, y down.
  std::vector<std::vector<Point>> run() {
    for (int y = -1; y < bitmap_.height; ++y) {
      for (int x = -1; x < bitmap_.width; ++x) {
        // Every loop has a side with ink above and none below: walks only begin
        // there.
        if (ink(x, y) && !ink(x, y + 1) && (visited(x, y) & 1) == 0) {
          walk(x, y);
        }
      }
    }
    return std::move(loops_);
  }

 private:
  bool ink(int x, int y) const { return bitmap_.at(x, y) > kHalf; }
  uint8_t& visited(int x, int y) {
    return visited_[static_cast<size_t>(y + 1) * static_cast<size_t>(width_) +
                    static_cast<size_t>(x + 1)];
  }

  // Corners: 0 upper left, 1 lower left, 2 lower right, 3 upper right. Side i
  // leads from corner i to i + 1.
  static int corner_x(int x, int c) { return x + (c >= 2 ? 1 : 0); }
  static int corner_y(int y, int c) { return y + (c == 1 || c == 2 ? 1 : 0); }
  bool corner(int x, int y, int c) const {
    return ink(corner_x(x, c & 3), corner_y(y, c & 3));
  }
  bool leaves(int x, int y, int side) const {
    return !corner(x, y, side) && corner(x, y, side + 1);
  }

  int exit_of(int x, int y, int entry) const {
    const int next = (entry + 1) & 3;
    const int before = (entry + 3) & 3;
    if (leaves(x, y, next) && leaves(x, y, before)) {
      const int sum = bitmap_.at(x, y) + bitmap_.at(x + 1, y) +
                      bitmap_.at(x, y + 1) + bitmap_.at(x + 1, y + 1);
      return sum > 4 * kHalf ? next : before;
    }
    return leaves(x, y, next)     ? next
           : leaves(x, y, before) ? before
                                  : (entry + 2) & 3;
  }

  void walk(int x, int y) {
    std::vector<Point> loop;
    int side = 0;
    while ((visited(x, y) >> side & 1) == 0) {
      visited(x, y) = static_cast<uint8_t>(visited(x, y) | 1 << side);
      loop.push_back(crossing(x, y, side));
      const int exit = exit_of(x, y, side);
      x += exit == 2 ? 1 : exit == 0 ? -1 : 0;
      y += exit == 1 ? 1 : exit == 3 ? -1 : 0;
      side = (exit + 2) & 3;
    }
    loops_.push_back(std::move(loop));
  }

  // Pixel (x, y) has its centre at (x + 0.5, y + 0.5).
  Point crossing(int x, int y, int side) const {
    const int c1 = (side + 1) & 3;
    const int ax = corner_x(x, side), ay = corner_y(y, side);
    const int bx = corner_x(x, c1), by = corner_y(y, c1);
    const Point a = {ax + 0.5, ay + 0.5};
    const Point b = {bx + 0.5, by + 0.5};
    if (is_bilevel_) {
      return 0.5 * (a + b);
    }
    const double va = bitmap_.at(ax, ay);
    const double vb = bitmap_.at(bx, by);
    const Point p = a + (kHalf - va) / (vb - va) * (b - a);
    return on_edge(p, std::fabs(va - kHalf) < std::fabs(vb - kHalf) ? ax : bx,
                   std::fabs(va - kHalf) < std::fabs(vb - kHalf) ? ay : by);
  }

  // Moves p onto the straight edge in pixel (x, y).
  Point on_edge(const Point& p, int x, int y) const {
    const double ink_here = bitmap_.at(x, y) / 255.0;
    if (ink_here <= 0 || ink_here >= 1) {
      return p;
    }
    const auto v = [&](int dx, int dy) {
      return static_cast<double>(bitmap_.at(x + dx, y + dy));
    };
    const Point gradient = {
        v(1, -1) + 2 * v(1, 0) + v(1, 1) - v(-1, -1) - 2 * v(-1, 0) - v(-1, 1),
        v(-1, 1) + 2 * v(0, 1) + v(1, 1) - v(-1, -1) - 2 * v(0, -1) - v(1, -1)};
    const Point n = unit(gradient);
    if (n.x == 0 && n.y == 0) {
      return p;
    }
    const Point centre = {x + 0.5, y + 0.5};
    const double off = dot(p - centre, n) + offset(ink_here, n);
    return std::fabs(off) < 1 ? p - off * n : p;
  }

  // The distance of a pixel's centre from a straight edge with normal n that
  // leaves `ink` of it covered; positive if the centre is covered. Inverts the
  // area of a half plane in a unit square: a triangle, a trapezium, or a square
  // less a triangle.
  static double offset(double ink, const Point& n) {
    const double a = std::max(std::fabs(n.x), std::fabs(n.y));
    const double b = std::min(std::fabs(n.x), std::fabs(n.y));
    const double small = std::min(ink, 1 - ink);
    // Width from the corner to the edge along n.
    const double width =
        small <= b / (2 * a) ? std::sqrt(2 * small * a * b) : small * a + b / 2;
    const double d = width - (a + b) / 2;
    return ink < 0.5 ? d : -d;
  }

  const Bitmap& bitmap_;
  bool is_bilevel_;
  int width_;
  std::vector<uint8_t> visited_;  // sides through which an edge entered
  std::vector<std::vector<Point>> loops_;
};

double area(const std::vector<Point>& loop) {
  double sum = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    sum += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
  }
  return sum;
}

// Averages 2 steps + 1 points, twice: a triangular window.
std::vector<Point> smooth(const std::vector<Point>& loop, int steps) {
  const int size = static_cast<int>(loop.size());
  steps = std::min(steps, size / 4);
  std::vector<Point> result = loop;
  for (int round = 0; round < 2; ++round) {
    const std::vector<Point> in = result;
    const auto at = [&](int i) {
      return in[static_cast<size_t>((i % size + size) % size)];
    };
    Point sum;
    for (int k = -steps; k <= steps; ++k) {
      sum = sum + at(k);
    }
    for (int i = 0; i < size; ++i) {
      result[static_cast<size_t>(i)] = 1.0 / (2 * steps + 1) * sum;
      sum = sum + at(i + steps + 1) - at(i - steps);
    }
  }
  return result;
}

}  // namespace

MasterPlace place_between(const Point& origin, const Point& em) {
  MasterPlace place;
  place.px_per_em = length(em - origin);
  if (!(place.px_per_em >= 16)) {
    throw Error("the origin of a master and the point an em to its right are " +
                std::to_string(place.px_per_em) +
                " px apart; the least is 16 px");
  }
  place.origin_x = origin.x;
  place.origin_y = origin.y;
  place.slope = std::atan2(em.y - origin.y, em.x - origin.x);
  return place;
}

double pixel_tolerance(const Bitmap& bitmap, const MasterPlace& place) {
  const double px = 1024 / place.px_per_em;
  return std::max(0.1, (bitmap.is_bilevel() ? 0.4 : 0.15) * px);
}

std::vector<Loop> walk_edges(const Bitmap& bitmap,
                             const MasterOptions& options) {
  const bool is_bilevel = bitmap.is_bilevel();
  const double scale = 1024 / options.place.px_per_em;
  const size_t stride = is_bilevel ? 4 : 1;
  const double c = std::cos(options.place.slope);
  const double s = std::sin(options.place.slope);
  // From y down to y up, with a level baseline.
  const auto upright = [c, s](const Point& p) {
    return Point{c * p.x + s * p.y, s * p.x - c * p.y};
  };
  std::vector<Loop> loops;
  for (std::vector<Point>& steps : EdgeWalker(bitmap, is_bilevel).run()) {
    if (steps.size() < 8 || std::fabs(area(steps)) < options.least_area_px) {
      continue;
    }
    const std::vector<Point> smoothed =
        smooth(steps, is_bilevel ? kSteps : kGreySteps);
    Loop loop;
    const size_t count = smoothed.size();
    const size_t reach = std::min<size_t>(stride, count / 4);
    for (size_t i = 0; i < count; i += stride) {
      const Point& p = smoothed[i];
      const Point t =
          smoothed[(i + reach) % count] - smoothed[(i + count - reach) % count];
      loop.points.push_back(scale * upright({p.x - options.place.origin_x,
                                             p.y - options.place.origin_y}));
      loop.tangents.push_back(unit(upright(t)));
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

gen::Outline outline_of(const Bitmap& bitmap, const MasterOptions& options) {
  std::vector<Loop> loops = walk_edges(bitmap, options);
  const double px = 1024 / options.place.px_per_em;
  CornerOptions corners;
  corners.reach =
      std::max(1.5, (bitmap.is_bilevel() ? 1.5 * kSteps : 2.5) * px);
  corners.turn = 0.2;
  FitOptions fit;
  fit.tolerance = options.tolerance_u > 0
                      ? options.tolerance_u
                      : pixel_tolerance(bitmap, options.place);
  fit.extremes = options.extremes;
  for (Loop& loop : loops) {
    find_corners(corners, loop);
  }
  return fit_loops(loops, fit);
}

}  // namespace inkcell::design
