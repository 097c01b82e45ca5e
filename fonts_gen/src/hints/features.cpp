#include "hints/features.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hints/serifs.hpp"

namespace inkcell::gen {
namespace {

// Points of the border this near to a serif belong to it. [u]
constexpr double kSerifReach = 30;
constexpr double kFootReach = 10;
constexpr double kBeside = 0.1;  // off the end of a serif [u]

// Heights at which both sides are compared, and the ink that may differ.
constexpr int kSymmetryRows = 23;
constexpr double kAsymmetry = 0.1;

// Taller or wider parts are no dots. A width of the record is 254 u at most.
constexpr double kThickestPart = 250;

bool is_in_serif(double y, const std::vector<Stroke>& bars) {
  return std::any_of(bars.begin(), bars.end(), [y](const Stroke& bar) {
    // Cupped feet have no upper edge.
    const double reach = bar.high_pieces.empty() ? kFootReach : kSerifReach;
    return bar.kind == Stroke::Kind::serif && y >= bar.low - reach &&
           y <= bar.high + reach;
  });
}

Interval find_body(const Border& border, const GlyphFeatures& features) {
  const Interval whole = {border.box().x0, border.box().x1};
  Interval body = {whole.high, whole.low};
  const auto add = [&body](double x) {
    body = {std::min(body.low, x), std::max(body.high, x)};
  };
  for (const std::vector<Point>& line : border.lines()) {
    for (const Point& point : line) {
      if (!is_in_serif(point.y, features.bars)) {
        add(point.x);
      }
    }
  }
  const auto add_ink = [&](double y) {
    if (!is_in_serif(y, features.bars)) {
      for (const Interval& span : border.ink_at(Axis::y, y)) {
        add(span.low);
        add(span.high);
      }
    }
  };
  // Straight strokes have no point between their serifs.
  for (const Stroke& bar : features.bars) {
    if (bar.kind == Stroke::Kind::serif) {
      add_ink(bar.low - kSerifReach - kBeside);
      add_ink(bar.high + kSerifReach + kBeside);
    }
  }
  for (const Stroke& stem : features.stems) {
    add(stem.low);
    add(stem.high);
  }
  return body.low < body.high ? body : whole;
}

bool is_symmetric(const Border& border) {
  const Box& box = border.box();
  double ink = 0;
  double mirrored = 0;
  for (int i = 1; i <= kSymmetryRows; ++i) {
    const double y =
        box.y0 + (box.y1 - box.y0) * (i + 0.007) / (kSymmetryRows + 1);
    const Intervals spans = border.ink_at(Axis::y, y);
    Intervals mirror;
    for (const Interval& span : spans) {
      mirror.push_back(
          {box.x0 + box.x1 - span.high, box.x0 + box.x1 - span.low});
    }
    ink += total_length(spans);
    mirrored += overlap(spans, mirror);
  }
  return ink > 0 && ink - mirrored < kAsymmetry * ink;
}

// The box of a closed line; empty if it bounds a counter, which lies to its
// right.
Box ink_box(const std::vector<Point>& line) {
  double twice_area = 0;
  Point last = line.back();
  for (const Point& point : line) {
    twice_area += cross(last, point);
    last = point;
  }
  return twice_area > 0 ? box_of({line}) : Box();
}

// Dots, accents and the like have edges that are too short for strokes: if a
// part is as thin as a heavy dot and has none, it is one.
void add_part(const Interval& place,
              double length,
              double most_length,
              std::vector<Stroke>& strokes) {
  const bool is_thin = place.length() > 0 && place.length() <= kThickestPart;
  const bool is_free =
      std::none_of(strokes.begin(), strokes.end(), [&](const Stroke& other) {
        return other.low < place.high && place.low < other.high;
      });
  if (!is_thin || !is_free || length > most_length) {
    return;
  }
  Stroke stroke;
  stroke.low = place.low;
  stroke.high = place.high;
  stroke.is_round = true;
  stroke.facing = length;
  strokes.insert(std::upper_bound(strokes.begin(), strokes.end(), stroke,
                                  [](const Stroke& a, const Stroke& b) {
                                    return a.low < b.low;
                                  }),
                 stroke);
}

void add_small_parts(const Border& border, GlyphFeatures& features) {
  for (const std::vector<Point>& line : border.lines()) {
    const Box box = ink_box(line);
    const Interval x = {box.x0, box.x1};
    const Interval y = {box.y0, box.y1};
    add_part(y, x.length(), HUGE_VAL, features.bars);
    // Taller parts may lean.
    add_part(x, y.length(), kThickestPart, features.stems);
  }
}

}  // namespace

GlyphFeatures find_features(const Outline& outline) {
  GlyphFeatures features;
  const Border border(outline);
  if (border.empty()) {
    return features;
  }
  features.has_ink = true;
  features.box = border.box();
  Strokes bars = find_bars(border);
  for (Stroke& bar : bars.strokes) {
    if (is_serif(bar, border)) {
      bar.kind = Stroke::Kind::serif;
    }
  }
  features.ends = find_free_ends(border, bars.strokes);
  add_cupped_feet(border, bars);
  features.bars = std::move(bars.strokes);
  features.lone_edges = std::move(bars.lone);
  features.stems = find_stems(border);
  add_small_parts(border, features);
  features.body = find_body(border, features);
  features.is_symmetric = is_symmetric(border);
  return features;
}

}  // namespace inkcell::gen
