// Signed distances to outlines made by hand, from all of their edges, in
// double.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "outline_record.hpp"

namespace outline_truth {

using outline_record::OutlinePoint;
using outline_record::Span;

struct Place {
  double x;
  double y;
};

inline constexpr uint32_t kMaxEdges = 112;
inline constexpr int32_t kSteps = 8;  // of a curve

inline double root(double value) {
  double result = value > 1 ? value : 1;
  for (int32_t i = 0; i < 30; ++i) {
    result = (result + value / result) / 2;
  }
  return result;
}

/// A glyph as edges on the screen. [px, y down]
class Truth {
 public:
  /// `scale`: px per grid unit; the origin is at (x, y). Curves become `steps`
  /// edges.
  void set(Span<const OutlinePoint> points,
           double scale,
           double x,
           double y,
           int32_t steps = kSteps) {
    steps_ = steps;
    scale_ = scale;
    x_ = x;
    y_ = y;
    count_ = 0;
    size_t begin = 0;
    while (begin < points.size) {
      size_t end = begin + 1;
      while (end < points.size && points[end].kind != outline_record::start) {
        ++end;
      }
      add_contour({points.data + begin, end - begin});
      begin = end;
    }
  }

  /// Positive inside. [px]
  double distance(double x, double y) const {
    double least = 1e9;
    bool inside = false;
    for (uint32_t i = 0; i < count_; ++i) {
      const Place& a = from_[i];
      const Place& b = to_[i];
      const double dx = b.x - a.x;
      const double dy = b.y - a.y;
      const double square = dx * dx + dy * dy;
      double t = square == 0 ? 0 : ((x - a.x) * dx + (y - a.y) * dy) / square;
      t = t < 0 ? 0 : (t > 1 ? 1 : t);
      const double ox = a.x + t * dx - x;
      const double oy = a.y + t * dy - y;
      const double away = ox * ox + oy * oy;
      least = away < least ? away : least;
      if ((a.y <= y) != (b.y <= y) && a.x + (y - a.y) / dy * dx > x) {
        inside = !inside;
      }
    }
    return inside ? root(least) : -root(least);
  }

 private:
  Place place(const OutlinePoint& at) const {
    return {x_ + at.x * scale_, y_ - at.y * scale_};
  }
  void add(const Place& a, const Place& b) {
    if (count_ < kMaxEdges) {
      from_[count_] = a;
      to_[count_] = b;
      ++count_;
    }
  }
  void add_curve(const Place& a, const Place& c, const Place& b) {
    Place at = a;
    for (int32_t i = 1; i <= steps_; ++i) {
      const double t = static_cast<double>(i) / steps_;
      const double u = 1 - t;
      const Place next = {u * u * a.x + 2 * t * u * c.x + t * t * b.x,
                          u * u * a.y + 2 * t * u * c.y + t * t * b.y};
      add(at, next);
      at = next;
    }
  }
  void add_contour(Span<const OutlinePoint> points) {
    const Place first = place(points[0]);
    Place at = first;
    Place control = {};
    bool is_bent = false;
    for (size_t i = 1; i <= points.size; ++i) {
      const bool is_last = i == points.size;
      const Place next = is_last ? first : place(points[i]);
      if (!is_last && points[i].kind == outline_record::off) {
        if (is_bent) {
          const Place middle = {(control.x + next.x) / 2,
                                (control.y + next.y) / 2};
          add_curve(at, control, middle);
          at = middle;
        }
        control = next;
        is_bent = true;
        continue;
      }
      if (is_bent) {
        add_curve(at, control, next);
      } else {
        add(at, next);
      }
      at = next;
      is_bent = false;
    }
  }

  double scale_ = 0;
  double x_ = 0;
  double y_ = 0;
  int32_t steps_ = kSteps;
  uint32_t count_ = 0;
  Place from_[kMaxEdges];
  Place to_[kMaxEdges];
};

}  // namespace outline_truth
