// Strokes of one pen, and the circles of their round ends and joins.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "shape/outline.hpp"
#include "svg/path_data.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// The ends of a path that have no cap, since something else covers them.
struct CoveredEnds {
  bool start = false;
  bool end = false;
};

/// The strokes of one pen, and the circles that their round joins and caps are
/// parts of. Where strokes meet, arcs of one circle would run along each other,
/// and caps would touch the far side of a stroke from within: a union of curves
/// tells such curves apart by rounding alone. So first all strokes and arcs are
/// noted. Then arcs are drawn in pieces from one end of any arc to the next,
/// which are the same bit for bit, and no cap is drawn that another stroke
/// covers.
class Circles {
 public:
  /// `bound`: how far borders may stray. `near`: centres so close are one.
  Circles(const PenStyle& pen, double bound, double near);

  /// Adds a path with its joints at the centres of circles, and without the
  /// segments that have no length then.
  const Subpath& add(const Subpath& subpath);

  /// The paths in the order in which they were added, once for each.
  size_t next() { return next_++; }
  const Subpath& path(size_t number) const { return paths_[number].subpath; }

  /// The ends of a path that another stroke, or another part of the path,
  /// covers with the disc around them: they need no round cap.
  CoveredEnds covered(size_t number) const;

  /// Notes the arc around `centre`, a joint, from the direction `from` by
  /// `angle`, which is above 0. [radians]
  void note(const Point& centre, double from, double angle);

  /// Its pieces, cubics of about 45 degrees at most. All arcs must be noted
  /// before.
  std::vector<Segment> arc(const Point& centre, double from, double angle);

 private:
  // Ends of arcs on a circle, 0 to 2 pi; ascending once they are used.
  struct Circle {
    Point centre;
    std::vector<double> ends;
    bool is_sorted = false;
  };

  struct Path {
    Subpath subpath;
    std::vector<std::vector<Point>> chords;  // corners of each segment
  };

  bool is_covered(size_t number, bool is_start) const;
  bool covers(const Path& other,
              size_t segment,
              const Point& at,
              bool may_be_end) const;

  size_t number_at(const Point& p);
  void sort_ends(Circle& circle) const;

  PenStyle pen_;
  double radius_;
  double same_end_;  // [radians]
  double near_;
  size_t next_ = 0;
  std::vector<Path> paths_;
  std::vector<Circle> circles_;
  std::multimap<double, size_t> by_x_;
};

}  // namespace inkcell::gen
