// Polylines by length, and glyphs along them and on circles.
#include "inkcell/motion/path.hpp"

#include "as_designed.hpp"
#include "base/math.hpp"
#include "inkcell/motion/timeline.hpp"
#include "limits.hpp"
#include "place/style_parts.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kMostQ16 = 8191 << 16;
constexpr int32_t kLongestQ16 = 32767 << 16;

int32_t to_q16(Q26_6 px) noexcept {
  return clamp_i64(int64_t{px.raw} * (1 << 10), -kMostQ16, kMostQ16);
}

// One coordinate of a cubic, by de Casteljau's algorithm.
int32_t cubic_at(const int32_t (&points)[4], Q16_16 t) noexcept {
  const int32_t a = lerp(points[0], points[1], t);
  const int32_t b = lerp(points[1], points[2], t);
  const int32_t c = lerp(points[2], points[3], t);
  return lerp(lerp(a, b, t), lerp(b, c, t), t);
}

constexpr int32_t kMostRounds = 1 << 15;

// How far a path has turned at a length. [turns, Q16] Within +-2^47.
int64_t turn_at(const Path& path, int64_t length, bool wraps) noexcept {
  int64_t rounds = 0;
  if (wraps) {
    const int64_t whole = path.length().raw;
    rounds = length >= 0 ? length / whole : -((whole - 1 - length) / whole);
    length -= rounds * whole;
    rounds = clamp_i64(rounds, -kMostRounds, kMostRounds);
  }
  const Span<const PathPoint> points = path.points();
  const int64_t round = points.size == 0 ? 0 : points[points.size - 1].turn.raw;
  return rounds * round +
         path.at(Q16_16::from_raw(clamp_i64(length, INT32_MIN, INT32_MAX)))
             .turn.raw;
}

// The length of a path at which a curve `aside` to its left is `along` px long
// since `start`: a turn of the path by an angle makes it shorter by the angle
// times `aside`. [px, Q16]
int64_t along_at(const Path& path,
                 int64_t start,
                 int64_t along,
                 int64_t aside,
                 bool wraps) noexcept {
  constexpr int32_t kTries = 3;
  constexpr int64_t kTurnQ16 = 411775;  // 2 pi
  const int64_t first = turn_at(path, start, wraps);
  // Converges where the path's radius is greater than `aside`; elsewhere it
  // stays within twice the way.
  const int64_t most = along < 0 ? -along : along;
  int64_t at = start + along;
  const int64_t aside_q8 = clamp_i64(aside, -kMostQ16, kMostQ16) >> 8;
  for (int32_t i = 0; i < kTries; ++i) {
    const int64_t turned =
        clamp_i64(turn_at(path, at, wraps) - first, -(1 << 30), 1 << 30);
    const int64_t more = aside_q8 * (turned * kTurnQ16 >> 16) >> 8;
    at = start + along + (more < -most ? -most : more > most ? most : more);
  }
  return at;
}

// Draws a glyph and returns its box. `at.x`: from the circle's anchor;
// `middle`: that of its letter, twice, from the glyph's origin. [font units]
// Not inline: a frame of its own.
__attribute__((noinline)) Rect draw_glyph(const Painter& painter,
                                          const Font& font,
                                          const Style& style,
                                          const TextCircle& circle,
                                          const PositionedGlyph& at,
                                          int32_t middle) noexcept {
  constexpr int64_t kTurn = 683565276;  // 1 / (2 pi) [Q32]
  const Q26_6 size = style.size();
  const int32_t side = circle.side == CircleSide::outside ? 1 : -1;
  const int32_t radius_q6 = clamp(circle.radius.raw, 64, 8191 * 64);
  const int32_t spaced_q6 = max(radius_q6 + side * (size.raw / 4), 64);
  // The middle of the letter is on the circle.
  const int32_t half_q16 = to_px_q16(font, size, middle).raw / 2;
  const int64_t along_q16 = int64_t{to_px_q16(font, size, at.x).raw} + half_q16;
  const int64_t turns_q16 =
      (side * along_q16 * (kTurn * 64 / spaced_q6) + (int64_t{1} << 31)) >> 32;
  const Direction out = direction_of(
      Angle::from_raw(static_cast<uint16_t>(circle.at.raw - turns_q16)));
  const int32_t right = side * out.sine.raw;
  const int32_t up = -side * out.cosine.raw;
  // From the centre to the circle, and back by half of the advance.
  const int64_t rise_q16 = side * to_px_q16(font, size, at.y).raw;
  const auto px = [&](Q26_6 centre, int32_t to, int32_t back) {
    const int64_t far_q46 = (int64_t{radius_q6} * (1 << 10) + rise_q16) * to -
                            int64_t{half_q16} * back + (int64_t{1} << 39);
    return Q26_6::from_raw(
        clamp_i64(centre.raw + (far_q46 >> 40), INT32_MIN, INT32_MAX));
  };
  const Point origin(px(circle.centre.x, out.cosine.raw, right),
                     px(circle.centre.y, -out.sine.raw, -up));
  Style turned(
      size, style.filter(),
      {Fixed<int32_t, 30>::from_raw(right), Fixed<int32_t, 30>::from_raw(up)});
  turned.clear_fit();
  if (style.effect() != nullptr) {
    turned.set_effect(*style.effect());
  }
  const Rect box = painter.glyph_box(font, turned, origin, at.glyph);
  if (!is_empty(intersect(box, painter.sink().window))) {
    painter.glyph(font, turned, origin, at.glyph);
  }
  return box;
}

}  // namespace

Status Path::add(int64_t x_q16, int64_t y_q16) noexcept {
  if (count_ == points_.size) {
    return Status::buffer_small;
  }
  PathPoint point;
  point.x.raw = clamp_i64(x_q16, -kMostQ16, kMostQ16);
  point.y.raw = clamp_i64(y_q16, -kMostQ16, kMostQ16);
  if (count_ != 0) {
    const PathPoint& last = points_[count_ - 1];
    const int64_t length =
        int64_t{last.length.raw} +
        length_of(point.x.raw - last.x.raw, point.y.raw - last.y.raw);
    point.length.raw = clamp_i64(length, 0, kLongestQ16);
    // Halved, so that the difference fits; y up.
    const Angle angle = angle_of(point.x.raw / 2 - last.x.raw / 2,
                                 last.y.raw / 2 - point.y.raw / 2);
    if (count_ == 1) {
      heading_ = 0;
    } else {
      // At a joint the path has turned half of the way.
      const auto turn = static_cast<int16_t>(angle.raw - angle_.raw);
      points_[count_ - 1].turn.raw = detail::sum(heading_, turn / 2);
      heading_ = detail::sum(heading_, turn);
    }
    angle_ = angle;
    point.turn.raw = heading_;
  }
  points_[count_++] = point;
  return Status::ok;
}

Status Path::move_to(Point to) noexcept {
  return count_ != 0 ? Status::bad_argument : add(to_q16(to.x), to_q16(to.y));
}

Status Path::line_to(Point to) noexcept {
  return count_ == 0 ? Status::bad_argument : add(to_q16(to.x), to_q16(to.y));
}

// Whether a curve of so many chords can be added.
Status Path::check(int32_t pieces) const noexcept {
  if (count_ == 0 || pieces < 1 || pieces > 256) {
    return Status::bad_argument;
  }
  return points_.size - count_ < static_cast<size_t>(pieces)
             ? Status::buffer_small
             : Status::ok;
}

Status Path::cubic_to(Point control1,
                      Point control2,
                      Point to,
                      int32_t pieces) noexcept {
  INKCELL_TRY(check(pieces));
  const PathPoint from = points_[count_ - 1];
  const int32_t x[4] = {from.x.raw, to_q16(control1.x), to_q16(control2.x),
                        to_q16(to.x)};
  const int32_t y[4] = {from.y.raw, to_q16(control1.y), to_q16(control2.y),
                        to_q16(to.y)};
  for (int32_t i = 1; i <= pieces; ++i) {
    const Q16_16 t = fraction(0, pieces, i);
    INKCELL_TRY(add(cubic_at(x, t), cubic_at(y, t)));
  }
  return Status::ok;
}

Status Path::arc_to(Point centre, Q16_16 turns, int32_t pieces) noexcept {
  if (turns.raw > 4 << 16 || turns.raw < -(4 << 16)) {
    return Status::bad_argument;
  }
  INKCELL_TRY(check(pieces));
  const PathPoint from = points_[count_ - 1];
  const int64_t centre_x = to_q16(centre.x);
  const int64_t centre_y = to_q16(centre.y);
  const int64_t x = from.x.raw - centre_x;
  const int64_t y = from.y.raw - centre_y;
  for (int32_t i = 1; i <= pieces; ++i) {
    const Angle angle = Angle::from_raw(
        static_cast<uint16_t>(lerp(0, turns.raw, fraction(0, pieces, i))));
    // A unit vector in Q30, y up: the screen's y is down.
    const Direction direction = direction_of(angle);
    const int64_t c = direction.cosine.raw >> 14;
    const int64_t s = direction.sine.raw >> 14;
    constexpr int64_t kHalf = 1 << 15;
    INKCELL_TRY(add(centre_x + ((x * c + y * s + kHalf) >> 16),
                    centre_y + ((y * c - x * s + kHalf) >> 16)));
  }
  return Status::ok;
}

PathPoint Path::at(Q16_16 length) const noexcept {
  PathPoint result;
  result.length = length;
  if (count_ == 0) {
    return result;
  }
  // The last point with a length <= `length`, but never the end of a line.
  size_t low = 0;
  size_t high = count_ - 1;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (points_[middle].length.raw <= length.raw) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const PathPoint& from = points_[low];
  const PathPoint& to = points_[high];
  const int64_t whole = to.length.raw - from.length.raw;
  const int64_t part = int64_t{length.raw} - from.length.raw;
  const Q16_16 t = fraction(from.length.raw, to.length.raw, length.raw);
  result.turn.raw = lerp(from.turn.raw, to.turn.raw, t);
  if (whole <= 0) {
    result.x = from.x;
    result.y = from.y;
    return result;
  }
  if (part >= 0 && part <= whole) {
    result.x.raw = lerp(from.x.raw, to.x.raw, t);
    result.y.raw = lerp(from.y.raw, to.y.raw, t);
    return result;
  }
  // A component is at most the length: products stay below 2^63.
  result.x.raw =
      clamp_i64(from.x.raw + (int64_t{to.x.raw} - from.x.raw) * part / whole,
                -INT32_MAX, INT32_MAX);
  result.y.raw =
      clamp_i64(from.y.raw + (int64_t{to.y.raw} - from.y.raw) * part / whole,
                -INT32_MAX, INT32_MAX);
  return result;
}

PosedGlyph place(const Font& font,
                 const Run& run,
                 size_t index,
                 const Path& path,
                 const PathPlace& where,
                 const Pose& pose) noexcept {
  const RunGlyph& glyph = run.glyphs[index];
  const int64_t length = path.length().raw;
  const bool wraps = where.overflow == PathOverflow::wrap && length > 0;
  const int64_t half = to_px_q16(font, where.size, glyph.advance).raw / 2;
  const int64_t along_q16 =
      to_px_q16(font, where.size, glyph.x).raw + half +
      int64_t{where.tracking.raw} * glyph.half_gaps * (1 << 9);
  const Q16_16 pivot = pivot_height_px(where.size, where.pivot_height);
  // From the path to the pivot, to the left of the path. Marks turn with their
  // letters.
  const int32_t down = glyph.line * run.line_height;
  const int64_t aside = int64_t{pivot.raw} +
                        int64_t{where.lift.raw} * (1 << 10) -
                        to_px_q16(font, where.size, down).raw;
  int64_t middle = along_at(path, where.start.raw, along_q16, aside, wraps);
  PosedGlyph posed;
  posed.glyph = glyph.glyph;
  posed.pose = pose;
  if (wraps) {
    middle %= length;
    middle += middle < 0 ? length : 0;
  }
  if (where.overflow == PathOverflow::hide && (middle < 0 || middle > length)) {
    posed.pose.opacity = 0;
  }
  const auto point_at = [&](int64_t at) {
    if (wraps) {
      at += at < 0 ? length : at > length ? -length : 0;
    }
    return path.at(Q16_16::from_raw(clamp_i64(at, INT32_MIN, INT32_MAX)));
  };
  // Half the length of the chord below the glyph; at least half a pixel.
  const int64_t reach = half > (1 << 15) ? half : 1 << 15;
  const PathPoint from = point_at(middle - reach);
  const PathPoint to = point_at(middle + reach);
  const PathPoint on = point_at(middle);
  // Halved, so that the difference fits; y up.
  const Angle along =
      angle_of(to.x.raw / 2 - from.x.raw / 2, from.y.raw / 2 - to.y.raw / 2);
  posed.pose.angle.raw = static_cast<uint16_t>(pose.angle.raw + along.raw);
  posed.pivot_x.raw = static_cast<int32_t>(half);
  posed.pivot_y.raw =
      pivot.raw - to_px_q16(font, where.size, glyph.y + down).raw;
  const int64_t x = on.x.raw - (aside * sine(along).raw >> 14);
  const int64_t y = on.y.raw - (aside * cosine(along).raw >> 14);
  posed.at.x.raw = static_cast<int32_t>((x + (1 << 9)) >> 10);
  posed.at.y.raw = static_cast<int32_t>((y + (1 << 9)) >> 10);
  return posed;
}

Rect draw_on_circle(const Painter& painter,
                    const Font& font,
                    const Style& style,
                    const TextCircle& circle,
                    Text text) noexcept {
  Rect box;
  if (detail::StyleParts::band_kind(style) == nullptr) {
    return box;  // nothing is drawn
  }
  const Painter designing = painter.for_motion();
  const auto halves = static_cast<int32_t>(circle.anchor);
  int32_t first = 0;
  PositionedGlyph at;
  if (halves != 0) {
    TextCursor cursor(designing, font, text, kAsDesigned);
    while (cursor.next(at)) {
    }
    first = cursor.advance() * halves / 2;
  }
  TextCursor cursor(designing, font, text, kAsDesigned);
  while (cursor.next(at)) {
    const LetterEdges letter = cursor.letter();
    const int32_t middle = letter.begin + letter.end - 2 * at.x;
    at.x -= first;
    box =
        bounding_box(box, draw_glyph(painter, font, style, circle, at, middle));
  }
  return box;
}

}  // namespace inkcell::motion
