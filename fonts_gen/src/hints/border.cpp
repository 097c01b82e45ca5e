#include "hints/border.hpp"

#include <algorithm>
#include <utility>

#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Chords of a curve. The slope of a curve is judged by its chords.
constexpr int kChords = 16;

std::vector<Point> chords_of(const Contour& contour) {
  std::vector<Point> line;
  const auto add = [&line](const Point& point) {
    if (line.empty() || !(line.back() == point)) {
      line.push_back(point);
    }
  };
  for (const Segment& segment : contour.segments) {
    const int chords = segment.kind == Segment::Kind::line ? 1 : kChords;
    for (int i = 0; i < chords; ++i) {
      add(point_on(segment, static_cast<double>(i) / chords));
    }
  }
  while (line.size() > 1 && line.back() == line.front()) {
    line.pop_back();
  }
  return line;
}

}  // namespace

double overlap(const Interval& a, const Interval& b) {
  return std::max(0.0, std::min(a.high, b.high) - std::max(a.low, b.low));
}

double overlap(const Intervals& a, const Intervals& b) {
  double sum = 0;
  for (const Interval& x : a) {
    for (const Interval& y : b) {
      sum += overlap(x, y);
    }
  }
  return sum;
}

double total_length(const Intervals& intervals) {
  double sum = 0;
  for (const Interval& interval : intervals) {
    sum += interval.length();
  }
  return sum;
}

Border::Border(const Outline& outline) {
  for (const Contour& contour : outline.contours) {
    std::vector<Point> line = chords_of(contour);
    if (line.size() >= 3) {
      lines_.push_back(std::move(line));
    }
  }
  box_ = empty() ? Box() : box_of(lines_);
}

Intervals Border::ink_at(Axis axis, double at) const {
  std::vector<double> crossings;
  for (const std::vector<Point>& line : lines_) {
    for (size_t i = 0; i < line.size(); ++i) {
      const Point& a = line[i];
      const Point& b = line[(i + 1) % line.size()];
      const double pa = position(a, axis);
      const double pb = position(b, axis);
      if ((pa <= at) != (pb <= at)) {
        const double t = (at - pa) / (pb - pa);
        crossings.push_back(along(a, axis) +
                            t * (along(b, axis) - along(a, axis)));
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  Intervals ink;
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    ink.push_back({crossings[i], crossings[i + 1]});
  }
  return ink;
}

}  // namespace inkcell::gen
