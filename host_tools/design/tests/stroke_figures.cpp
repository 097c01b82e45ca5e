// Random strokes against brute force: accuracy and speed of sweep().
//
// Usage: inkcell_stroke_figures COUNT [FIRST]
//
// Tries COUNT strokes from number FIRST (default 0) on. Prints the worst
// distance and the strokes with open or missing contours; fails above 0.25 u,
// or if there is such a stroke.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "parallel.hpp"
#include "shape/shape.hpp"
#include "stroke/stroke.hpp"
#include "stroke/sweep.hpp"
#include "stroke_oracle.hpp"
#include "work_time.hpp"

namespace inkcell::design::test {
namespace {

constexpr double kLimit_u = 0.25;
constexpr double kPi = 3.14159265358979323846;
constexpr int kPlaces = 12;  // of each kind that are looked at

struct Result {
  double worst_u = 0;
  bool is_broken = false;
  double milliseconds = 0;
};

class RandomStroke {
 public:
  explicit RandomStroke(size_t seed)
      : random_(static_cast<uint32_t>(seed * 2654435761u + 1)) {}

  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int below(int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random_);
  }
  Point point() { return {within(0, 1000), within(-200, 800)}; }

  NibPath path() {
    NibPath path;
    const auto kind = below(2) == 0 ? Nib::Kind::ellipse : Nib::Kind::rectangle;
    const int pieces = 1 + below(3);
    Point at = point();
    for (int i = 0; i < pieces; ++i) {
      path.pieces.push_back(piece(at));
      at = path.pieces.back().kind == gen::Segment::Kind::line
               ? path.pieces.back().p[1]
               : path.pieces.back().p[3];
    }
    Nib nib = {kind, size(), size(), within(-kPi, kPi)};
    for (int i = 0; i <= pieces; ++i) {
      path.nibs.push_back(nib);
      if (below(2) == 0) {  // varies
        nib.width = size();
        nib.height = size();
      }
      if (below(2) == 0) {
        nib.angle += within(-kPi, kPi);
      }
    }
    return path;
  }

 private:
  double size() {
    const int kind = below(8);
    return kind == 0 ? 0 : kind < 4 ? within(0, 20) : within(10, 200);
  }

  gen::Segment piece(const Point& from) {
    gen::Segment s;
    s.p[0] = from;
    const int kind = below(6);
    if (kind == 0) {
      s.p[1] = point();
      return s;
    }
    s.kind = gen::Segment::Kind::cubic;
    s.p[3] = point();
    if (kind == 1) {  // a cusp
      s.p[1] = {s.p[3].x, s.p[0].y + within(50, 300)};
      s.p[2] = {s.p[0].x, s.p[1].y};
      s.p[3].y = s.p[0].y;
    } else if (kind == 2) {  // about a quarter of a circle
      const double r = within(5, 300);
      s.p[1] = from + Point{0, 0.5523 * r};
      s.p[2] = from + Point{r - 0.5523 * r, r};
      s.p[3] = from + Point{r, r};
    } else if (kind == 3) {  // a parabola
      const Point c = point();
      s.p[1] = from + 2.0 / 3 * (c - from);
      s.p[2] = s.p[3] + 2.0 / 3 * (c - s.p[3]);
    } else {
      s.p[1] = point();
      s.p[2] = point();
    }
    return s;
  }

  std::mt19937 random_;
};

Point on_border(const NibPlace& place, double angle) {
  const double a = std::max(place.nib.width, kLeastNib_u) / 2;
  const double b = std::max(place.nib.height, kLeastNib_u) / 2;
  double x = std::cos(angle);
  double y = std::sin(angle);
  if (place.nib.kind == Nib::Kind::rectangle) {
    const double scale = std::max(std::fabs(x), std::fabs(y));
    x /= scale;
    y /= scale;
  }
  const double c = std::cos(place.nib.angle);
  const double s = std::sin(place.nib.angle);
  return place.at + Point{c * a * x - s * b * y, s * a * x + c * b * y};
}

double area(const std::vector<Point>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  }
  return sum;
}

Result check(size_t seed) {
  RandomStroke random(seed);
  const NibPath path = random.path();
  Result result;
  const double begin = tools::work_done_ms();
  const std::vector<std::vector<Point>> polygons = sweep(places_on(path));
  result.milliseconds = tools::work_done_ms() - begin;
  // The area of a nib is connected: one outer contour, with holes.
  int outer = 0;
  for (const std::vector<Point>& polygon : polygons) {
    outer += area(polygon) > 0 ? 1 : 0;
  }
  result.is_broken = outer != 1;
  const gen::Shape shape(outline_of_polygons(polygons));
  const PathTruth truth_of_path(path);
  const auto note = [&](double error) {
    result.worst_u = std::max(result.worst_u, error);
  };
  // The border of the result is on the exact border.
  const auto& edges = shape.edges();
  for (int i = 0; i < kPlaces && !edges.empty(); ++i) {
    const gen::Edge& edge = edges[static_cast<size_t>(
        random.below(static_cast<int>(edges.size())))];
    const Point p = edge.a + random.within(0, 1) * (edge.b - edge.a);
    note(std::fabs(truth_of_path.distance(p)));
  }
  // Everything that a nib covers is covered.
  for (int i = 0; i < kPlaces; ++i) {
    const size_t piece =
        static_cast<size_t>(random.below(static_cast<int>(path.pieces.size())));
    const Point p = on_border(place_on(path, piece, random.within(0, 1)),
                              random.within(-kPi, kPi));
    note(-std::min(shape.distance(p.x, p.y), 0.0));
  }
  // Random points: ink where a nib is, none elsewhere.
  for (int i = 0; i < kPlaces; ++i) {
    const Point p = {random.within(shape.box().x0, shape.box().x1),
                     random.within(shape.box().y0, shape.box().y1)};
    const double made = shape.distance(p.x, p.y);
    const double truth = truth_of_path.distance(p);
    if (std::fabs(made) > kLimit_u) {
      result.is_broken = result.is_broken || (made > 0) != (truth > -1e-6);
    }
  }
  return result;
}

int run(size_t count, size_t first) {
  std::vector<Result> results(count);
  parallel_for(count, 0, [&](size_t i) { results[i] = check(first + i); });
  double worst = 0;
  double time = 0;
  std::vector<double> times;
  size_t broken = 0;
  for (size_t i = 0; i < count; ++i) {
    const Result& result = results[i];
    worst = std::max(worst, result.worst_u);
    time += result.milliseconds;
    times.push_back(result.milliseconds);
    if (result.is_broken || result.worst_u > kLimit_u) {
      broken += result.is_broken ? 1 : 0;
      std::printf("stroke %zu: %s, %.3f u\n", first + i,
                  result.is_broken ? "open or missing contour" : "closed",
                  result.worst_u);
    }
  }
  std::sort(times.begin(), times.end());
  std::printf(
      "%zu strokes: worst %.4f u against brute force, %zu with open or missing "
      "contours; %.1f ms each, 99 %% below %.1f ms\n",
      count, worst, broken, time / static_cast<double>(count),
      times[count * 99 / 100]);
  return worst > kLimit_u || broken != 0 ? 1 : 0;
}

}  // namespace
}  // namespace inkcell::design::test

int main(int argc, char** argv) {
  const size_t count =
      argc == 2 || argc == 3 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const size_t first = argc == 3 ? std::strtoul(argv[2], nullptr, 10) : 0;
  if (count == 0) {
    std::fprintf(stderr, "usage: inkcell_stroke_figures COUNT [FIRST]\n");
    return 2;
  }
  return inkcell::design::test::run(count, first);
}
