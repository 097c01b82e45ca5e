// Unions of two to six parts, combined while they are drawn, against the exact
// union.
//
//   inkcell_union_figures ROUNDS
//
// Draws ROUNDS unions of bars and ellipses, 60 to 200 u wide, for each count of
// parts at 8 to 64 px. The error of a pixel is the lesser of two: against the
// filtered distance to the exact union, or against the union's area. At corners
// these two differ by more than 100 of 255. Prints the worst pixel and the
// share of edge pixels beyond 32 of 255, also for the maximum of the distances.
// Exits with 1 if the share is above 1/1000, or if the maximum is better.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "component/csg.hpp"
#include "inkcell/simulation/combine.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design {
namespace {

using gen::Point;
using motion::DistanceGrid;
using simulation::GridPart;

constexpr int kMostParts = 6;
constexpr int kSizes_px[] = {8, 10, 12, 16, 24, 32, 48, 64};
constexpr int kMargin_px = 4;
constexpr int kMostSide_px = 64 + 2 * kMargin_px;
constexpr int kFine = 16;     // points of a pixel's side for its area
constexpr double kMost = 32;  // [1/255]
constexpr double kMostShare = 0.001;

using Random = std::mt19937;

double within(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A bar or an ellipse, turned, in the middle of the em.
gen::Shape random_part(Random& random) {
  const double long_u = within(random, 250, 800) / 2;
  const double short_u = within(random, 60, 200) / 2;
  const double turn = within(random, 0, 2 * M_PI);
  const double x = within(random, 350, 674);
  const double y = within(random, 350, 674);
  const bool is_bar = random() % 2 == 0;
  const int corners = is_bar ? 4 : 180;
  std::vector<Point> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / corners;
    const double stretch = is_bar ? M_SQRT2 : 1;
    const double px = stretch * long_u * std::cos(angle);
    const double py = stretch * short_u * std::sin(angle);
    polygon.push_back({x + px * std::cos(turn) - py * std::sin(turn),
                       y + px * std::sin(turn) + py * std::cos(turn)});
  }
  return gen::Shape(outline_of_polygons({polygon}));
}

// Pixels of an em and a margin at a size, y down.
struct Screen {
  int size_px;
  int side() const { return size_px + 2 * kMargin_px; }
  Point to_u(double x, double y) const {
    const double u_per_px = 1024.0 / size_px;
    return {(x - kMargin_px) * u_per_px, (size_px + kMargin_px - y) * u_per_px};
  }
  double distance_px(const gen::Shape& shape, double x, double y) const {
    const Point p = to_u(x, y);
    return shape.distance(p.x, p.y) * size_px / 1024;
  }
};

// As DistanceGrid::paint does: sample s holds distances of s / 32 to
// (s + 1) / 32 px.
struct Samples {
  int8_t bytes[kMostSide_px * kMostSide_px];

  Samples(const Screen& screen, const gen::Shape& shape) {
    const int side = screen.side();
    for (int i = 0; i < side * side; ++i) {
      const double d =
          screen.distance_px(shape, i % side + 0.5, i / side + 0.5);
      bytes[i] =
          static_cast<int8_t>(std::clamp(std::floor(32 * d), -128.0, 127.0));
    }
  }
};

double area(const Screen& screen, const gen::Shape& shape, int x, int y) {
  int inside = 0;
  for (int i = 0; i < kFine * kFine; ++i) {
    const Point p = screen.to_u(x + (i % kFine + 0.5) / kFine,
                                y + (i / kFine + 0.5) / kFine);
    inside += shape.inside(p.x, p.y) ? 1 : 0;
  }
  return 255.0 * inside / (kFine * kFine);
}

// Errors of pixels. [1/255]
struct Errors {
  double worst = 0;
  int beyond = 0;  // kMost

  void add(double drawn, double filtered, double covered) {
    const double error =
        std::min(std::fabs(drawn - filtered), std::fabs(drawn - covered));
    worst = std::max(worst, error);
    beyond += error > kMost ? 1 : 0;
  }
};

struct Result {
  Errors combined;
  Errors by_maxima;
  int edge_pixels = 0;

  double share(const Errors& errors) const {
    return static_cast<double>(errors.beyond) / edge_pixels;
  }
};

double coverage(int32_t distance_q10) {
  return kFilterText.coverage(distance_q10);
}

Q16_16 middle(int px) {
  return Q16_16::from_raw(px * 65536 + 32768);
}

void measure_pixel(const Screen& screen,
                   const std::vector<GridPart>& parts,
                   const gen::Shape& whole,
                   int x,
                   int y,
                   Result& result) {
  const double d = screen.distance_px(whole, x + 0.5, y + 0.5);
  // Also far from the edge: no distance may show where there is none.
  const double filtered = 255 * std::clamp(d + 0.5, 0.0, 1.0);
  const bool is_edge = std::fabs(d) < 1;
  const double covered = is_edge ? area(screen, whole, x, y) : filtered;
  result.edge_pixels += is_edge ? 1 : 0;
  const motion::GridPoint at = simulation::combined_at(
      {parts.data(), parts.size()}, middle(x), middle(y), kFilterText);
  result.combined.add(coverage(at.distance_q10), filtered, covered);
  int most = -128;
  for (const GridPart& part : parts) {
    most = std::max<int>(most, part.grid->at(x, y));
  }
  result.by_maxima.add(coverage(most * 32 + 16), filtered, covered);
}

void measure(const Screen& screen,
             const std::vector<gen::Shape>& shapes,
             const gen::Shape& whole,
             Result& result) {
  const int side = screen.side();
  std::vector<Samples> samples;
  std::vector<DistanceGrid> grids;
  std::vector<GridPart> parts(shapes.size());
  samples.reserve(shapes.size());
  grids.reserve(shapes.size());
  for (size_t i = 0; i < shapes.size(); ++i) {
    samples.emplace_back(screen, shapes[i]);
    grids.emplace_back(Span<int8_t>(samples.back().bytes), side, side, 0);
    parts[i].grid = &grids.back();
  }
  for (int i = 0; i < side * side; ++i) {
    measure_pixel(screen, parts, whole, i % side, i / side, result);
  }
}

Result measure(int count, int rounds) {
  Random random(static_cast<unsigned>(count));
  Result result;
  for (int round = 0; round < rounds; ++round) {
    std::vector<gen::Shape> parts = {random_part(random)};
    gen::Shape whole = parts.front();
    for (int i = 1; i < count; ++i) {
      parts.push_back(random_part(random));
      whole = combine(whole, parts.back(), Combination::unite);
    }
    for (const int size_px : kSizes_px) {
      measure({size_px}, parts, whole, result);
    }
  }
  return result;
}

int run(int rounds) {
  double worst = 0;
  bool is_good = true;
  for (int count = 2; count <= kMostParts; ++count) {
    const Result r = measure(count, rounds);
    const double share = r.share(r.combined);
    const double by_maxima = r.share(r.by_maxima);
    std::printf(
        "%d parts: worst %.0f of 255, by maxima %.0f; beyond %.0f: %.2f %% of "
        "%d edge pixels, by maxima %.2f %%\n",
        count, r.combined.worst, r.by_maxima.worst, kMost, 100 * share,
        r.edge_pixels, 100 * by_maxima);
    worst = std::max(worst, r.combined.worst);
    is_good = is_good && share <= kMostShare && share < by_maxima &&
              r.combined.worst < r.by_maxima.worst;
  }
  std::printf("unions, worst pixel %.1f of 255\n", worst);
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace inkcell::design

int main(int argc, char** argv) {
  if (argc != 2 || std::atoi(argv[1]) <= 0) {
    std::fprintf(stderr, "usage: inkcell_union_figures ROUNDS\n");
    return 2;
  }
  return inkcell::design::run(std::atoi(argv[1]));
}
