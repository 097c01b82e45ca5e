// Figures: rectangles, circles, rings, arcs, lines and polygons, filled or
// stroked, in exact area as text is, on every canvas and in strips.
//
//   using namespace inkcell::figures;
//   stroke(painter, rectangle({4, 4}, {60, 28}), {2_px});
//   fill(painter, circle({80, 16}, 6.5_px));
//   const Figure dial =
//       arc({120, 40}, 30_px, motion::from_degrees(225), turns);
//   stroke(painter, dial, {6_px, Cap::round});
//   const Rect dirty = stroke_box(dial, {6_px, Cap::round});
//
// Pixels are squares: an edge at a whole number of px is sharp, and so is a
// stroke of 1 px whose line runs through the middle of pixels, at 4.5_px.
// Canvases of 1 bit draw the pixels that are covered by half.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"

namespace inkcell {

namespace figures {
struct Figure;
struct Pen;
}  // namespace figures

namespace detail {
class FigureTracer;
using TraceFigure = void(const figures::Figure& figure,
                         FigureTracer& tracer) noexcept;
TraceFigure trace_box;
TraceFigure trace_arc;
TraceFigure trace_path;

// Its box, if there is no painter.
Rect draw_figure(const figures::Figure& figure,
                 const figures::Pen* pen,
                 const Painter* painter) noexcept;
}  // namespace detail

namespace figures {

/// How the ends of lines, polylines and arcs look.
enum class Cap : uint8_t {
  butt,    // straight, at the end
  round,   // a semicircle around the end
  square,  // straight, half of the width farther
};

/// How strokes look at corners.
enum class Join : uint8_t {
  miter,  // sharp; cut off where the angle is below 29 degrees
  round,
};

/// Half of the width is on either side of an outline; it is rounded down to
/// 1/64 px and clamped to 511 px. {2_px} has butt caps and sharp corners.
struct Pen {
  Q26_6 width;
  Cap cap = Cap::butt;
  Join join = Join::miter;
};

/// Made by the functions below; in ROM if their arguments are constant. Empty,
/// it draws nothing. Points are clamped to +-2047 px from the first one, or the
/// centre, and radii to 0..2047 px. `points` must outlive it.
struct Figure {
  detail::TraceFigure* trace = nullptr;
  Point ends[2];  // the first point, or the centre; an opposite corner
  Q26_6 radius;
  Q16_16 turns;
  motion::Angle from;
  bool has_ends = false;
  Span<const Point> points;
};

/// By two opposite corners. A radius is at most half of the shorter side.
constexpr Figure rounded_rectangle(Point a, Point b, Q26_6 radius) noexcept {
  return {&detail::trace_box, {a, b}, radius, {}, {}, false, {}};
}
constexpr Figure rectangle(Point a, Point b) noexcept {
  return rounded_rectangle(a, b, {});
}

/// A part of a circle, counter-clockwise if `turns` is positive: none at 0, all
/// at 1. Filled it is a sector.
constexpr Figure arc(Point centre,
                     Q26_6 radius,
                     motion::Angle from,
                     Q16_16 turns) noexcept {
  return {&detail::trace_arc, {centre, {}}, radius, turns, from, false, {}};
}
/// Stroked it is a ring.
constexpr Figure circle(Point centre, Q26_6 radius) noexcept {
  return arc(centre, radius, {}, Q16_16::from_int(1));
}

/// To be stroked. One whose ends are the same is a dot if caps are round.
constexpr Figure line(Point a, Point b) noexcept {
  return {&detail::trace_path, {a, b}, {}, {}, {}, true, {}};
}
/// It has the first 65535 points. What its outline winds around, in either
/// direction, is filled, also where it crosses itself.
constexpr Figure polygon(Span<const Point> points) noexcept {
  if (points.size == 0) {
    return {};
  }
  const Point first = points.data[0];
  return {&detail::trace_path, {first, first}, {}, {}, {}, false, points};
}
/// The same with two ends. Filled, it is closed.
constexpr Figure polyline(Span<const Point> points) noexcept {
  Figure result = polygon(points);
  result.has_ends = true;
  return result;
}

/// Draws what lies inside, into the painter's sink, in its RAM. The picture is
/// the same in strips of any height, and with any RAM. Where two parts of one
/// figure share a pixel, their areas add up.
inline void fill(const Painter& painter, const Figure& figure) noexcept {
  detail::draw_figure(figure, nullptr, &painter);
}
/// Draws the outline.
inline void stroke(const Painter& painter,
                   const Figure& figure,
                   const Pen& pen) noexcept {
  detail::draw_figure(figure, &pen, &painter);
}

/// The pixels that these may touch, whatever the window is; empty if nothing
/// shows. At most 2 px on each side stay empty, of radii up to 400 px.
inline Rect fill_box(const Figure& figure) noexcept {
  return detail::draw_figure(figure, nullptr, nullptr);
}
inline Rect stroke_box(const Figure& figure, const Pen& pen) noexcept {
  return detail::draw_figure(figure, &pen, nullptr);
}

}  // namespace figures
}  // namespace inkcell
