#include "judge/painted_chords.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// paint_curve() halves while second differences are not less. [px]
constexpr double kStrays_px = 25.0 / 256;
constexpr int kMostHalvings = 6;

// Roundings of three points change a second difference by less. [px]
constexpr double kRounding_px = 2.75 / 256;

// How far joints of chords lie outside of the curve, in second differences of
// a chord's ends and control point: two thirds of what the chord strays.
constexpr double kOut = 1.0 / 6;

// The curve itself, in steps a chord: they stray by 1/64 of what the chord
// does.
constexpr int kSteps = 8;

int chords_of(const Point& second_px, ChordNumber number) {
  const double wide = std::fabs(second_px.x);
  const double high = std::fabs(second_px.y);
  double strays = std::max(wide, high) + 0.375 * std::min(wide, high);
  strays += number == ChordNumber::more ? kRounding_px : -kRounding_px;
  int halvings = 0;
  for (; strays >= kStrays_px && halvings != kMostHalvings; strays /= 4) {
    ++halvings;
  }
  return 1 << halvings;
}

Point point_at(const Point& a, const Point& b, const Point& c, double t) {
  const Point first = a + t * (b - a);
  return first + t * (b + t * (c - b) - first);
}

class Painter {
 public:
  Painter(int px, ChordNumber number, Polygons& strays)
      : px_(px), number_(number), strays_(strays) {}

  // `is_smooth`: the device moves the end of the curve, and with it the begin
  // of the next one.
  void add_curve(const Point& from,
                 const Point& control,
                 const Point& to,
                 bool is_smooth) {
    const Point begin = from + moved_;
    const Point second = begin - 2 * control + to;
    const int chords = chords_of((px_ / 1024.0) * second, number_);
    const Point out = (-kOut / (chords * chords)) * second;
    std::vector<Point> polygon = {begin};
    for (int i = 1; i < chords; ++i) {
      polygon.push_back(
          point_at(begin, control, to, static_cast<double>(i) / chords) + out);
    }
    moved_ = is_smooth ? out : Point{};
    polygon.push_back(to + moved_);
    for (int i = kSteps * chords; i >= 0; --i) {
      polygon.push_back(point_at(from, control, to,
                                 static_cast<double>(i) / (kSteps * chords)));
    }
    strays_.push_back(std::move(polygon));
  }

 private:
  int px_;
  ChordNumber number_;
  Polygons& strays_;
  Point moved_;  // the end of the last curve
};

}  // namespace

Polygons chord_strays(const MinimalOutline& outline,
                      double u_per_grid,
                      int px,
                      ChordNumber number) {
  Polygons strays;
  for (const MinimalContour& contour : outline.contours) {
    const std::vector<GridPoint>& points = contour.points;
    const auto at = [&](size_t i) {
      const GridPoint& p = points[i % points.size()];
      return u_per_grid *
             Point{static_cast<double>(p.x), static_cast<double>(p.y)};
    };
    const auto is_off = [&](size_t i) {
      return points[i % points.size()].kind == PointKind::off_curve;
    };
    Painter painter(px, number, strays);
    for (size_t i = 1; i <= points.size(); ++i) {
      if (is_off(i)) {
        const Point from = is_off(i - 1) ? middle(at(i - 1), at(i)) : at(i - 1);
        const Point to = is_off(i + 1) ? middle(at(i), at(i + 1)) : at(i + 1);
        painter.add_curve(from, at(i), to, is_off(i + 1));
      }
    }
  }
  return strays;
}

}  // namespace inkcell::gen
