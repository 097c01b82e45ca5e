#include "hints/serifs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace inkcell::gen {
namespace {

constexpr double kThickestSerif = 65;   // [u]
constexpr double kWidest = 500;         // with its wings [u]
constexpr double kLongestWing = 165;    // [u]
constexpr double kLongestSide = 110;    // of a wing on one side only [u]
constexpr double kLeastWings = 20;      // both together [u]
constexpr double kStrokeInset = -30;    // a wing of a slanted stroke [u]
constexpr double kWidestStroke = 210;   // [u]
constexpr double kThickestShare = 0.9;  // of the width of the stroke

// Offset of heights that avoids the ends of chords. [u]
constexpr double kOffGrid = 0.18;

// Distance from a bar at which its sides are examined. [u]
constexpr double kOutside = 6;
constexpr double kInside = 20;
constexpr double kTouch = 15;       // ink beyond the outer side
constexpr double kOnEdges = 20;     // of a span of the bar
constexpr double kFromBottom = 30;  // of serifs at feet
constexpr double kFromTop = 210;    // of serifs at heads, below dots

// Cupped feet. [u]
constexpr double kFootHeight = 14;
constexpr double kStrokeHeight = 100;
constexpr double kLeastFootWings = 25;
constexpr double kFootStep = 4;

bool covers_most(const Interval& span, const Interval& stroke) {
  return overlap(span, stroke) > 0.5 * stroke.length();
}

Intervals strokes_in(const Interval& span, const Intervals& ink) {
  Intervals found;
  for (const Interval& stroke : ink) {
    if (covers_most(span, stroke)) {
      found.push_back(stroke);
    }
  }
  return found;
}

bool has_short_wings(const Interval& span,
                     const Interval& stroke,
                     double least_wings) {
  const double left = stroke.low - span.low;
  const double right = span.high - stroke.high;
  const bool has_both = std::min(left, right) > 0.25 * std::max(left, right);
  return std::max(left, right) < (has_both ? kLongestWing : kLongestSide) &&
         std::min(left, right) > kStrokeInset && left + right > least_wings &&
         stroke.length() < kWidestStroke;
}

bool touches(const Intervals& spans, const Intervals& ink) {
  return std::any_of(spans.begin(), spans.end(), [&](const Interval& span) {
    return overlap({span}, ink) > kTouch;
  });
}

// Looks from `outer`, beyond the bar, to `inner`.
bool is_serif_from(double outer,
                   double inner,
                   const Stroke& bar,
                   const Border& border) {
  const Box& box = border.box();
  const Intervals spans = border.ink_at(Axis::y, bar.middle() + kOffGrid);
  const bool is_outside = outer < box.y0 - 4 || outer > box.y1 + 4;
  if ((!is_outside && touches(spans, border.ink_at(Axis::y, outer))) ||
      (outer >= box.y0 + kFromBottom && outer <= box.y1 - kFromTop)) {
    return false;
  }
  const Intervals ink = border.ink_at(Axis::y, inner + kOffGrid);
  bool any = false;
  for (const Interval& span : spans) {
    if (overlap({span}, bar.low_pieces) + overlap({span}, bar.high_pieces) <
        kOnEdges) {
      continue;
    }
    const Intervals strokes = strokes_in(span, ink);
    if (strokes.size() != 1 || span.length() >= kWidest ||
        !has_short_wings(span, strokes[0], kLeastWings) ||
        bar.width() >= kThickestShare * strokes[0].length()) {
      return false;
    }
    any = true;
  }
  return any;
}

// The height of the feet at a lower edge.
std::optional<double> foot_height(const StrokeEdge& edge,
                                  const Border& border) {
  const auto ink_above = [&](double height) {
    return border.ink_at(Axis::y, edge.position + height + kOffGrid);
  };
  const Intervals ink = ink_above(kStrokeHeight);
  std::optional<double> highest;
  for (const Interval& span : ink_above(kFootHeight)) {
    const Intervals strokes = strokes_in(span, ink);
    if (strokes.size() != 1 ||
        !has_short_wings(span, strokes[0], kLeastFootWings)) {
      return {};
    }
    double height = kFootHeight;
    const auto is_wide = [&] {
      for (const Interval& part : ink_above(height)) {
        if (overlap(part, strokes[0]) > 0) {
          return part.length() > strokes[0].length() + kLeastFootWings;
        }
      }
      return true;
    };
    while (height < kStrokeHeight && is_wide()) {
      height += kFootStep;
    }
    highest = std::max(height, highest.value_or(0));
  }
  return highest;
}

}  // namespace

bool is_serif(const Stroke& bar, const Border& border) {
  if (bar.width() >= kThickestSerif || bar.is_round ||
      bar.kind == Stroke::Kind::spine) {
    return false;
  }
  const double inside = std::max(kInside, bar.width());
  return is_serif_from(bar.low - kOutside, bar.high + inside, bar, border) ||
         is_serif_from(bar.high + kOutside, bar.low - inside, bar, border);
}

void add_cupped_feet(const Border& border, Strokes& bars) {
  std::vector<StrokeEdge> rest;
  for (const StrokeEdge& edge : bars.lone) {
    const bool is_foot =
        edge.ink_beyond && edge.position < border.box().y0 + kFromBottom;
    const std::optional<double> height =
        is_foot ? foot_height(edge, border) : std::nullopt;
    if (height) {
      Stroke serif;
      serif.low = edge.position;
      serif.high = edge.position + *height;
      serif.kind = Stroke::Kind::serif;
      serif.low_pieces = edge.pieces;
      bars.strokes.push_back(serif);
    } else {
      rest.push_back(edge);
    }
  }
  bars.lone = std::move(rest);
  std::stable_sort(
      bars.strokes.begin(), bars.strokes.end(),
      [](const Stroke& a, const Stroke& b) { return a.low < b.low; });
}

}  // namespace inkcell::gen
