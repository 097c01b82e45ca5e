#include "outlines/trace.hpp"

#include <algorithm>
#include <cmath>

#include "outlines/curve_fit.hpp"
#include "outlines/curves.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// A joint that turns by less than 20 degrees is part of a curve.
constexpr double kHardTurn_cos = 0.9396926;
// A corner is hard if rounding it off over its shorter side deviates by more
// than this. [tolerances]
constexpr double kHardStray = 3;
// Lines as short as this that turn by less than 12 degrees are chords of a
// curve. [u]
constexpr double kChord_u = 8;
constexpr double kChordTurn_cos = 0.9781476;
// Turning points nearer than this to an end of a curve count as the end. [grid
// units]
constexpr double kNearEnd = 1;
// Cubics are divided until a quadratic fits within this part of the tolerance.
constexpr double kDivideAt = 0.5;
// The rest of the tolerance is for curves as chords.
constexpr double kOfTolerance = 0.98;
constexpr size_t kFewestSamples = 6;
constexpr int kChordsOfCubic = 16;
// Coordinates that differ by less are equal. [grid units]
constexpr double kLevel = 0.01;

struct ContourPart {
  Segment curve;
  bool goes_on = false;  // continues the part before: chords of one curve
};

Segment scaled(Segment segment, double scale) {
  for (Point& p : segment.p) {
    p = scale * p;
  }
  return segment;
}

double chord_of(const ContourPart& part) {
  return length(end_of(part.curve) - part.curve.p[0]);
}

// Parts of the contour between joints and turning points.
std::vector<ContourPart> parts_of(const Contour& contour, double scale) {
  std::vector<ContourPart> parts;
  for (const Segment& segment : contour.segments) {
    const Segment curve = scaled(segment, scale);
    double t0 = 0;
    for (const double t : turning_points(curve)) {
      const Point p = point_on(curve, t);
      if (length(p - point_on(curve, t0)) > kNearEnd &&
          length(p - end_of(curve)) > kNearEnd) {
        parts.push_back({part_of(curve, t0, t)});
        t0 = t;
      }
    }
    parts.push_back({part_of(curve, t0, 1)});
  }
  return parts;
}

double turn_cos(const ContourPart& a, const ContourPart& b) {
  return dot(direction_at_end(a.curve), direction_at_start(b.curve));
}

// Rotates the list, so that the sharpest turn comes first, and marks short
// chords of one curve.
void arrange(std::vector<ContourPart>& parts, double chord) {
  const size_t n = parts.size();
  size_t sharpest = 0;
  double least = 2;
  for (size_t i = 0; i < n; ++i) {
    const double c = turn_cos(parts[(i + n - 1) % n], parts[i]);
    if (c < least - 1e-6) {
      least = c;
      sharpest = i;
    }
  }
  std::rotate(parts.begin(), parts.begin() + static_cast<ptrdiff_t>(sharpest),
              parts.end());
  for (size_t i = 1; i < n; ++i) {
    const ContourPart& before = parts[i - 1];
    parts[i].goes_on = before.curve.kind == Segment::Kind::line &&
                       parts[i].curve.kind == Segment::Kind::line &&
                       chord_of(before) < chord && chord_of(parts[i]) < chord &&
                       turn_cos(before, parts[i]) > kChordTurn_cos;
  }
}

class Tracer {
 public:
  Tracer(const RefitOptions& options, const RefitScale& scale)
      : options_(options), scale_(scale) {}

  Trace run(const Contour& contour) {
    std::vector<ContourPart> parts = parts_of(contour, scale_.grid_per_u);
    arrange(parts, kChord_u * scale_.grid_per_u);
    trace_.samples.push_back(parts[0].curve.p[0]);
    const size_t n = parts.size();
    for (size_t i = 0; i < n;) {
      size_t next = i + 1;
      while (next < n && parts[next].goes_on &&
             care_near(parts[next].curve.p[0], parts[next].curve.p[0]) !=
                 Care::exact) {
        ++next;
      }
      add_node(parts[(i + n - 1) % n], parts[i]);
      add_stretch(parts, i, next);
      i = next;
    }
    mark_hard();
    mark_extremes();
    return std::move(trace_);
  }

 private:
  void add_node(const ContourPart& before, const ContourPart& after) {
    Node node;
    node.before = direction_at_end(before.curve);
    node.after = direction_at_start(after.curve);
    push(node);
  }

  void push(Node node) {
    node.at = trace_.samples.size() - 1;
    const Point& p = trace_.samples.back();
    node.on_grid = {std::floor(p.x + 0.5), std::floor(p.y + 0.5)};
    node.care = care_near(p, p);
    trace_.nodes.push_back(node);
  }

  Care care_near(const Point& a, const Point& b) const {
    const double reach = scale_.reach * scale_.reach;
    const auto near = [&](const Point& place) {
      return squared_distance_to_segment(scale_.grid_per_u * place, a, b) <=
             reach;
    };
    if (std::any_of(options_.exact_u.begin(), options_.exact_u.end(), near)) {
      return Care::exact;
    }
    return std::any_of(options_.careful_u.begin(), options_.careful_u.end(),
                       near)
               ? Care::careful
               : Care::none;
  }

  Care care_of(const std::vector<Point>& samples,
               size_t first,
               size_t last) const {
    Care care = Care::none;
    for (size_t i = first; i < last; ++i) {
      care = std::max(care, care_near(samples[i], samples[i + 1]));
    }
    return care;
  }

  // Appends the samples of a curve, without its first point.
  void sample(const Segment& curve, std::vector<Point>& samples) const {
    int chords = 1;
    if (curve.kind != Segment::Kind::line) {
      chords = std::max(4, chord_count(curve, scale_.chord_bound));
    }
    if (curve.kind == Segment::Kind::cubic) {
      chords = std::max(kChordsOfCubic, chords);
    }
    for (int k = 1; k < chords; ++k) {
      samples.push_back(point_on(curve, static_cast<double>(k) / chords));
    }
    samples.push_back(end_of(curve));
  }

  // Adds the parts [i, next), chords of one curve or a single part, to the
  // trace.
  void add_stretch(const std::vector<ContourPart>& parts,
                   size_t i,
                   size_t next) {
    const Segment& curve = parts[i].curve;
    if (next > i + 1 || curve.kind == Segment::Kind::cubic) {
      std::vector<Point> samples{curve.p[0]};
      for (size_t k = i; k < next; ++k) {
        sample(parts[k].curve, samples);
      }
      divide(samples, 0, samples.size() - 1, true);
    } else if (curve.kind == Segment::Kind::line) {
      trace_.samples.push_back(end_of(curve));
      trace_.stretches.push_back(
          {Stretch::Kind::line, {}, care_near(curve.p[0], curve.p[1])});
    } else {
      add_quadratic(curve);
    }
  }

  void add_quadratic(const Segment& curve) {
    std::vector<Point> samples{curve.p[0]};
    sample(curve, samples);
    const Care care = care_of(samples, 0, samples.size() - 1);
    if (care != Care::exact) {
      append(samples, 0, samples.size() - 1);
      trace_.stretches.push_back({Stretch::Kind::quadratic, curve.p[1], care});
      return;
    }
    for (const double t : {0.0, 0.5}) {
      const Segment half = part_of(curve, t, t + 0.5);
      if (t > 0) {
        Node node;
        node.before = node.after = direction_at_start(half);
        push(node);
      }
      sample(half, trace_.samples);
      trace_.stretches.push_back({Stretch::Kind::quadratic, half.p[1], care});
    }
  }

  void append(const std::vector<Point>& samples, size_t first, size_t last) {
    trace_.samples.insert(trace_.samples.end(),
                          samples.begin() + static_cast<ptrdiff_t>(first) + 1,
                          samples.begin() + static_cast<ptrdiff_t>(last) + 1);
  }

  // Adds the samples `first` to `last` of a curve as stretches that a quadratic
  // fits.
  void divide(const std::vector<Point>& samples,
              size_t first,
              size_t last,
              bool whole) {
    const SampleSpan span{samples.data() + first, last - first + 1};
    Chain chain{samples[first], {Point{}}, samples[last]};
    const double limit = kDivideAt * scale_.tolerance;
    const Care care = care_of(samples, first, last);
    const double bound = care == Care::none ? limit : limit / 4;
    const bool fits =
        last - first < kFewestSamples ||
        (fit_controls(span, FixedControls(1), bound, chain) &&
         Deviation(span, scale_.chord_bound).of(chain, bound) <= bound);
    if (fits && !(care == Care::exact && whole && last - first > 1)) {
      append(samples, first, last);
      trace_.stretches.push_back({Stretch::Kind::other, {}, care});
      return;
    }
    const size_t half = (first + last) / 2;
    divide(samples, first, half, false);
    Node node;
    node.before = node.after = direction(samples[half + 1] - samples[half - 1]);
    push(node);
    divide(samples, half, last, false);
  }

  const Point& end_of_stretch(size_t i) const {
    return i + 1 < trace_.nodes.size() ? trace_.samples[trace_.nodes[i + 1].at]
                                       : trace_.samples.back();
  }

  void mark_hard() {
    const size_t n = trace_.nodes.size();
    const auto size = [&](size_t i) {
      return length(end_of_stretch(i) - trace_.samples[trace_.nodes[i].at]);
    };
    for (size_t i = 0; i < n; ++i) {
      Node& node = trace_.nodes[i];
      const double c = dot(node.before, node.after);
      const double sine = std::sqrt(std::max(0.0, (1 - c) / 2));
      node.hard =
          c < kHardTurn_cos && std::min(size(i), size((i + n - 1) % n)) * sine >
                                   kHardStray * scale_.tolerance;
    }
  }

  // Whether the coordinate is less, or greater, on both sides of the sample.
  bool turns_back(size_t at, double Point::*coordinate) const {
    const std::vector<Point>& samples = trace_.samples;
    const size_t n = samples.size() - 1;
    const auto step = [&](size_t by) {
      for (size_t k = 1; k < n; ++k) {
        const double d =
            samples[(at + k * by) % n].*coordinate - samples[at].*coordinate;
        if (std::fabs(d) > kLevel) {
          return d;
        }
      }
      return 0.0;
    };
    return step(1) * step(n - 1) > 0;
  }

  void mark_extremes() {
    for (Node& node : trace_.nodes) {
      node.extreme_x = turns_back(node.at, &Point::x);
      node.extreme_y = turns_back(node.at, &Point::y);
    }
  }

  const RefitOptions& options_;
  const RefitScale& scale_;
  Trace trace_;
};

}  // namespace

RefitScale::RefitScale(const RefitOptions& options)
    : grid_per_u(
          std::ldexp(options.units_per_em / 1024.0, -options.grid_shift)),
      tolerance(kOfTolerance * options.tolerance_u * grid_per_u),
      careful_tolerance(tolerance / 4),
      chord_bound(tolerance / 24),
      extreme_tolerance(std::min(tolerance, std::max(0.5, tolerance / 4))),
      reach(kCareRadius_u * grid_per_u) {}

Trace trace(const Contour& contour,
            const RefitOptions& options,
            const RefitScale& scale) {
  return Tracer(options, scale).run(contour);
}

}  // namespace inkcell::gen
