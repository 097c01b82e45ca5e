// Paths of lines, arcs and cubics, parametrised by length, and text along them;
// text on circles, in one call:
//
//   const TextCircle rim = {{120, 120}, 100_px, from_degrees(90)};
//   draw_on_circle(painter, font, style, rim, "BAROMETER");
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/pose.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// A point of a path. [px, Q16.16, y down]
struct PathPoint {
  Q16_16 x;
  Q16_16 y;
  Q16_16 length;  // of the path up to here
  Q16_16 turn;    // [turns] counter-clockwise, since the first chord
};

/// A polyline in the caller's memory, with the length up to each point.
///
///   PathPoint points[40];
///   Path path(points);
///   INKCELL_TRY(path.move_to({x, y}));
///   INKCELL_TRY(path.cubic_to(c1, c2, end, 32));
///
/// Coordinates are clamped to +-8191 px, the length to 32767 px.
class Path {
 public:
  constexpr explicit Path(Span<PathPoint> points) noexcept : points_(points) {}

  void clear() noexcept { count_ = 0; }

  /// The first point. bad_argument: there is one already. buffer_small (also
  /// below): the points do not fit; the path is unchanged.
  Status move_to(Point to) noexcept;

  /// bad_argument (also below): there is no first point.
  Status line_to(Point to) noexcept;

  /// A cubic Bezier curve as `pieces` chords, 1 to 256. A chord of length l and
  /// angle a is off by l a / 8: 16 pieces are enough for a bend of 90 px.
  Status cubic_to(Point control1,
                  Point control2,
                  Point to,
                  int32_t pieces) noexcept;

  /// An arc about `centre` from the current point by `turns` turns, -4 to 4,
  /// counter-clockwise if positive.
  Status arc_to(Point centre, Q16_16 turns, int32_t pieces) noexcept;

  Q16_16 length() const noexcept {
    return count_ == 0 ? Q16_16() : points_[count_ - 1].length;
  }
  Span<const PathPoint> points() const noexcept {
    return {points_.data, count_};
  }

  /// The point at a length. Before the start and after the end: on the tangent.
  PathPoint at(Q16_16 length) const noexcept;

 private:
  Status add(int64_t x_q16, int64_t y_q16) noexcept;
  Status check(int32_t pieces) const noexcept;

  Span<PathPoint> points_;
  size_t count_ = 0;
  int32_t heading_ = 0;  // of the last chord, as PathPoint::turn
  Angle angle_;          // of the last chord
};

/// What happens to glyphs outside of a path.
enum class PathOverflow : uint8_t {
  hide,    // not drawn if their middle is outside, as in SVG
  extend,  // continue on the tangent
  wrap,    // enter at the other end: for closed paths
};

/// How a run is set along a path.
struct PathPlace {
  Q16_16 start;    // of the run's origin, along the path [px]
  Q26_6 size;      // [px to the em]
  Q26_6 tracking;  // [px]
  Q26_6 lift;      // of the baseline to the left of the path [px]
  PathOverflow overflow = PathOverflow::hide;
  int16_t pivot_height = 250;  // as in RunPlace
};

/// Places glyph `index` < run.glyphs.size on a path: the middle of its advance
/// is on the path, its baseline on the chord below it, so that sliding glyphs
/// turn smoothly. Advances and kerning are measured at the height of the pivot,
/// so that letters neither touch in valleys nor part on crests. Further lines
/// run beside the first. A hidden glyph has opacity 0.
PosedGlyph place(const Font& font,
                 const Run& run,
                 size_t index,
                 const Path& path,
                 const PathPlace& where,
                 const Pose& pose) noexcept;

/// Where letters have their heads, and how the line runs.
enum class CircleSide : uint8_t {
  outside,  // clockwise: the upper half of a dial
  inside,   // counter-clockwise, heads to the centre: the lower half
};

/// The circle of a line's baseline.
struct TextCircle {
  Point centre;
  Q26_6 radius;  // clamped to 1..8191 px
  Angle at;      // of the anchor: 0 is to the right of the centre
  CircleSide side = CircleSide::outside;
  Anchor anchor = Anchor::centre;
};

/// Draws a line with the size, the filter and the effect of a style, and
/// returns the pixels that it may touch: Painter() draws nothing. Glyphs are
/// turned, and not fitted. They are spaced a quarter of the em above the
/// baseline, so that they neither touch inside nor part outside.
Rect draw_on_circle(const Painter& painter,
                    const Font& font,
                    const Style& style,
                    const TextCircle& circle,
                    Text text) noexcept;

}  // namespace inkcell::motion
