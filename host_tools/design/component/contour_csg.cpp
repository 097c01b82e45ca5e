// Clipper combines polygons of chords; each edge of the result lies on a chord,
// and a row of such edges is a part of the chord's curve.
#include "component/contour_csg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <polyclipping/clipper.hpp>

#include "fit/vectors.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "outlines/curves.hpp"
#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

using ClipperLib::IntPoint;

constexpr double kSteps_per_unit = 4096;
constexpr double kChordBound = 1.0 / 32;  // [font units]
constexpr int kMostChords = 256;
// Clipper rounds crossings to its grid. [1/4096 unit]
constexpr double kReach = 4;
// Parts of curves below this are rounding. [font units]
constexpr double kLeastPart = 0.75;

Point on_grid(const Point& p) {
  return {std::round(p.x * kSteps_per_unit), std::round(p.y * kSteps_per_unit)};
}

Point point_of(const IntPoint& p) {
  return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

struct Curve {
  gen::Segment segment;
  size_t contour = 0;
};

struct Chord {
  size_t curve = 0;
  double t0 = 0;
  double t1 = 1;
  Point a;  // [1/4096 unit]
  Point b;
};

// A part of a curve; backwards if from > to.
struct Part {
  size_t curve = 0;
  double from = 0;
  double to = 1;
  Point start;  // [font units]

  bool is_whole() const { return std::abs(to - from) == 1; }
};

Point rounded(const Point& p) {
  return {std::round(p.x), std::round(p.y)};
}

class Combiner {
 public:
  std::vector<PointContour> run(const std::vector<PointContour>& a,
                                const std::vector<PointContour>& b,
                                ClipperLib::ClipType type) {
    ClipperLib::Clipper clipper;
    clipper.PreserveCollinear(true);
    clipper.AddPaths(paths_of(a), ClipperLib::ptSubject, true);
    clipper.AddPaths(paths_of(b), ClipperLib::ptClip, true);
    if (chords_.empty()) {
      return std::move(result_);
    }
    ClipperLib::Paths paths;
    if (!clipper.Execute(type, paths, ClipperLib::pftNonZero,
                         ClipperLib::pftNonZero)) {
      throw Error("the contours could not be combined");
    }
    for (const ClipperLib::Path& path : paths) {
      add_contour(path);
    }
    return std::move(result_);
  }

 private:
  ClipperLib::Paths paths_of(const std::vector<PointContour>& contours) {
    ClipperLib::Paths paths;
    for (const PointContour& contour : contours) {
      if (contour.open()) {
        result_.push_back(contour);
        continue;
      }
      ClipperLib::Path path;
      for (const gen::Segment& segment : to_segments(contour, 1).segments) {
        add_chords(segment, path);
      }
      contours_.push_back(contour);
      paths.push_back(std::move(path));
    }
    return paths;
  }

  void add_chords(const gen::Segment& segment, ClipperLib::Path& path) {
    const int count =
        std::min(gen::chord_count(segment, kChordBound), kMostChords);
    for (int i = 0; i < count; ++i) {
      Chord chord;
      chord.curve = curves_.size();
      chord.t0 = static_cast<double>(i) / count;
      chord.t1 = static_cast<double>(i + 1) / count;
      chord.a = on_grid(gen::point_on(segment, chord.t0));
      chord.b = on_grid(gen::point_on(segment, chord.t1));
      path.emplace_back(static_cast<ClipperLib::cInt>(chord.a.x),
                        static_cast<ClipperLib::cInt>(chord.a.y));
      chords_.push_back(chord);
    }
    curves_.push_back({segment, contours_.size()});
  }

  // The part of a curve along an edge; `last` is the part before it, whose
  // curve is chosen where several coincide.
  Part part_along(const Point& p, const Point& q, const Part* last) const {
    const auto distance = [&](const Chord& chord) {
      return std::max(distance_to_piece(p, chord.a, chord.b),
                      distance_to_piece(q, chord.a, chord.b));
    };
    const Chord* best = nullptr;
    double least = kReach;
    for (const Chord& chord : chords_) {
      const bool continues = last != nullptr && last->curve == chord.curve;
      const double d = distance(chord) - (continues ? kReach : 0);
      if (d < least) {
        least = d;
        best = &chord;
      }
    }
    if (best == nullptr) {
      throw Error("the contours could not be combined; move one a little");
    }
    const auto place = [best](const Point& at) {
      const Point along = best->b - best->a;
      const double square = dot(along, along);
      const double part = square == 0 ? 0 : dot(at - best->a, along) / square;
      return best->t0 + std::clamp(part, 0.0, 1.0) * (best->t1 - best->t0);
    };
    return {best->curve, place(p), place(q), (1 / kSteps_per_unit) * p};
  }

  static bool continues(const Part& a, const Part& b) {
    constexpr double kSlack = 1e-6;
    return a.curve == b.curve && std::abs(a.to - b.from) < kSlack &&
           (a.to > a.from) == (b.to > b.from);
  }

  std::vector<Part> parts_of(const ClipperLib::Path& path) const {
    std::vector<Part> parts;
    for (size_t i = 0; i < path.size(); ++i) {
      const Part part =
          part_along(point_of(path[i]), point_of(path[(i + 1) % path.size()]),
                     parts.empty() ? nullptr : &parts.back());
      if (!parts.empty() && continues(parts.back(), part)) {
        parts.back().to = part.to;
      } else {
        parts.push_back(part);
      }
    }
    if (parts.size() > 1 && continues(parts.back(), parts.front())) {
      parts.front().from = parts.back().from;
      parts.front().start = parts.back().start;
      parts.pop_back();
    }
    return parts;
  }

  // The contour that these are all curves of, in its direction or reversed.
  std::optional<PointContour> whole_contour(
      const std::vector<Part>& parts) const {
    const size_t contour = curves_[parts[0].curve].contour;
    const auto count = static_cast<size_t>(std::count_if(
        curves_.begin(), curves_.end(),
        [contour](const Curve& c) { return c.contour == contour; }));
    const bool is_reversed = parts[0].from > parts[0].to;
    const bool is_whole =
        std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
          return curves_[part.curve].contour == contour && part.is_whole() &&
                 (part.from > part.to) == is_reversed;
        });
    if (!is_whole || count != parts.size()) {
      return std::nullopt;
    }
    return is_reversed ? reversed(contours_[contour]) : contours_[contour];
  }

  // The start of `part`, which follows `last`: a point of a curve, or a
  // crossing. Beside curves that are cut it is whole.
  Point joint(const Part& last, const Part& part) const {
    const auto is_end = [](double t) { return t == 0 || t == 1; };
    Point at = part.start;
    if (is_end(part.from)) {
      at = gen::point_on(curves_[part.curve].segment, part.from);
    } else if (is_end(last.to)) {
      at = gen::point_on(curves_[last.curve].segment, last.to);
    }
    return part.is_whole() && last.is_whole() ? at : rounded(at);
  }

  gen::Segment segment_of(const Part& part,
                          const Point& start,
                          const Point& end) const {
    gen::Segment segment =
        gen::part_of(curves_[part.curve].segment, std::min(part.from, part.to),
                     std::max(part.from, part.to));
    if (part.from > part.to) {
      segment = gen::reversed(segment);
    }
    const int last = gen::degree_of(segment);
    for (int i = 1; i < last && !part.is_whole(); ++i) {
      segment.p[i] = rounded(segment.p[i]);
    }
    segment.p[0] = start;
    segment.p[last] = end;
    return segment;
  }

  // Appends a segment, as a part of the last one if both are one line.
  static void append(const gen::Segment& segment, gen::Contour& contour) {
    std::vector<gen::Segment>& list = contour.segments;
    if (!list.empty() && gen::degree_of(segment) == 1 &&
        gen::degree_of(list.back()) == 1) {
      const Point before = list.back().p[1] - list.back().p[0];
      const Point after = segment.p[1] - segment.p[0];
      if (cross(before, after) == 0 && dot(before, after) > 0) {
        list.back().p[1] = segment.p[1];
        return;
      }
    }
    list.push_back(segment);
  }

  void add_contour(const ClipperLib::Path& path) {
    std::vector<Part> parts = parts_of(path);
    if (auto whole = whole_contour(parts)) {
      result_.push_back(std::move(*whole));
      return;
    }
    const auto is_rounding = [this](const Part& part) {
      const gen::Segment segment = gen::part_of(curves_[part.curve].segment,
                                                std::min(part.from, part.to),
                                                std::max(part.from, part.to));
      double size = 0;
      for (int i = 1; i <= gen::degree_of(segment); ++i) {
        size += length(segment.p[i] - segment.p[i - 1]);
      }
      return size < kLeastPart && !part.is_whole();
    };
    parts.erase(std::remove_if(parts.begin(), parts.end(), is_rounding),
                parts.end());
    std::vector<Point> joints;
    for (size_t i = 0; i < parts.size(); ++i) {
      joints.push_back(
          joint(parts[(i + parts.size() - 1) % parts.size()], parts[i]));
    }
    gen::Contour contour;
    for (size_t i = 0; i < parts.size(); ++i) {
      append(segment_of(parts[i], joints[i], joints[(i + 1) % parts.size()]),
             contour);
    }
    // The first line may continue the last one.
    if (contour.segments.size() > 2) {
      const gen::Segment first = contour.segments.front();
      const size_t count = contour.segments.size();
      append(first, contour);
      if (contour.segments.size() == count) {
        contour.segments.erase(contour.segments.begin());
      } else {
        contour.segments.pop_back();
      }
    }
    if (contour.segments.size() > 1) {
      result_.push_back(from_segments(contour, 1));
    }
  }

  std::vector<PointContour> contours_;
  std::vector<Curve> curves_;
  std::vector<Chord> chords_;
  std::vector<PointContour> result_;
};

}  // namespace

std::vector<PointContour> combined(const std::vector<PointContour>& a,
                                   const std::vector<PointContour>& b,
                                   const std::string& operation) {
  static const std::map<std::string, ClipperLib::ClipType> types = {
      {"union", ClipperLib::ctUnion},
      {"intersection", ClipperLib::ctIntersection},
      {"difference", ClipperLib::ctDifference},
      {"exclusion", ClipperLib::ctXor}};
  const auto type = types.find(operation);
  if (type == types.end()) {
    throw Error("operation '" + operation +
                "' is not known; use union, intersection, difference or "
                "exclusion");
  }
  return Combiner().run(a, b, type->second);
}

}  // namespace inkcell::design
