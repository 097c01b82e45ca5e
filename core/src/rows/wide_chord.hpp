// Distances to an outline within some pixels of it.
//
// Curves become chords that turn by less than 28 degrees from one to the next.
// A chord paints the pixels that are no farther than the reach and lie between
// the normals at its ends, which it shares with its neighbours:
//
//             \                 /         along the longer axis, pixel by
//      before  \               /  after   pixel: from the crossing upwards and
//               \             /           downwards until the reach ends
//       reach    +-----------+
//                      chord
//
// What is painted near a normal is up to 3 % too near. Corners have the wedge
// between the normals of their edges.
//
// `Marks` says what is kept in a band's bytes beside nearness, in bits that
// ~kMask has:
//   cross_row(pixel)     the outline crosses a row, between `pixel` and the one
//                        to its left
//   cross_column(pixel)  likewise a column; asked for with kHasColumns
#pragma once

#include "base/math.hpp"
#include "rows/band.hpp"
#include "rows/contours.hpp"
#include "rows/reciprocal.hpp"

namespace inkcell::detail::wide {

// Longer chords are cut. [px, Q8]
inline constexpr int32_t kChordLimit = kLengthLimit / 2;

// Tangents are shorter.
inline constexpr int32_t kTangentLimit = 1 << 12;

template <typename Marks>
inline void approach(uint8_t* pixel, int32_t nearness) noexcept {
  const int32_t old = *pixel;
  nearness &= Marks::kMask;
  if (old < nearness) {
    *pixel = static_cast<uint8_t>(nearness | (old & ~Marks::kMask));
  }
}

// A direction that an outline has at the end of a chord, and how far the chord
// is painted beyond the normal there. [px, Q8]
struct Tangent {
  int32_t x;
  int32_t y;
  int32_t slack;
};

// Roundings leave no gap between two chords.
constexpr int32_t kLeastSlack = 4;

// A direction with components below kTangentLimit.
inline Tangent tangent_of(int32_t x, int32_t y) noexcept {
  while (max(abs(x), abs(y)) >= kTangentLimit) {
    x >>= 1;
    y >>= 1;
  }
  return {x, y, kLeastSlack};
}

// Where two stored curves join without a corner their tangents differ by up to
// 8 degrees: each goes on by a 14th of the reach.
inline Tangent joined(const Band& band, Tangent tangent) noexcept {
  tangent.slack += band.reach_q8 * 18 >> 8;
  return tangent;
}

// The length of a vector whose longer component is `a`: tangents of the circle
// at 0, 18 and 36 degrees.
inline int32_t length_within_1_percent(int32_t a, int32_t b) noexcept {
  return max(a, max(245 * a + 80 * b, 208 * a + 151 * b) >> 8);
}

// Pixels around a corner that lie beyond the normals of both of its edges:
// `before` leads to the corner, `after` away from it; zeros are no limit.
template <typename Marks>
__attribute__((noinline)) void paint_corner(const Band& band,
                                            const PixelPoint& at,
                                            const PixelPoint& before,
                                            const PixelPoint& after) noexcept {
  const Tangent a = tangent_of(before.x, before.y);
  const Tangent b = tangent_of(-after.x, -after.y);
  // Outlines that turn to the side that is filled have the wedge outside.
  const bool is_outside = (a.x * b.y > a.y * b.x) != band.is_mirrored;
  const int32_t reach = is_outside ? band.outside_q8 : band.inside_q8;
  const int32_t first_row = max((at.y - reach + 255) >> 8, 0);
  const int32_t last_row = min((at.y + reach) >> 8, band.rows - 1);
  const int32_t first = max((at.x - reach + 255) >> 8, 0);
  const int32_t last = min((at.x + reach) >> 8, band.last_column);
  if (first_row > last_row || first > last) {
    return;
  }
  // Roundings leave no gap.
  constexpr int32_t kSlack = kLeastSlack * kTangentLimit;
  for (int32_t row = first_row; row <= last_row; ++row) {
    const int32_t y = row * 256 - at.y;
    const int32_t x = first * 256 - at.x;
    int32_t beyond_a = a.x * x + a.y * y + kSlack;
    int32_t beyond_b = b.x * x + b.y * y + kSlack;
    uint8_t* pixel = band.row(row) + first;
    for (int32_t column = first; column <= last; ++column, ++pixel) {
      if ((beyond_a | beyond_b) >= 0) {
        const int32_t dx = abs(column * 256 - at.x);
        const int32_t dy = abs(y);
        const int32_t length =
            length_within_1_percent(max(dx, dy), min(dx, dy));
        approach<Marks>(pixel, 254 - (length * band.fall_q14 >> 14));
      }
      beyond_a += a.x * 256;
      beyond_b += b.x * 256;
    }
  }
}

// The end of a chord: along it and across, which are the axes of the band or
// the other way round.
struct End {
  int32_t along;
  int32_t across;
  // Where the normal leads along for one across. [Q14]
  int32_t lean_q14;
  int32_t slack;

  // `slope_q14` is the chord's, for ends that have its direction.
  End(const PixelPoint& at, const Tangent& tangent, bool is_steep) noexcept
      : along(is_steep ? at.y : at.x),
        across(is_steep ? at.x : at.y),
        slack(tangent.slack) {
    const int32_t a = abs(is_steep ? tangent.y : tangent.x);
    int32_t b = is_steep ? tangent.x : tangent.y;
    if ((is_steep ? tangent.y : tangent.x) < 0) {
      b = -b;
    }
    // Normals lean by 76 degrees at most.
    const int32_t least = max(abs(b) >> 2, 1);
    lean_q14 =
        times(b, reciprocal_of(static_cast<uint32_t>(max(a, least)))) >> 2;
  }

  // The normal in a line of pixels. [px, Q16] The same from wherever lines are
  // counted.
  int32_t normal_q16(int32_t line_q8) const noexcept {
    return along * 256 - ((line_q8 - across) * lean_q14 >> 6);
  }
};

// Where a chord crosses the lines of pixels on its way from a to b across.
// `inverse_q16`: along for one across.
template <typename Marks>
__attribute__((noinline)) void cross_lines(const Band& band,
                                           bool rows,
                                           int32_t along,
                                           int32_t across,
                                           int32_t end_across,
                                           int32_t inverse_q16) noexcept {
  int32_t line = max((min(across, end_across) >> 8) + 1, 0);
  const int32_t last = min(max(across, end_across) >> 8,
                           rows ? band.rows - 1 : band.last_column);
  for (; line <= last; ++line) {
    const int32_t at = along + ((line * 256 - across) * inverse_q16 >> 16);
    const int32_t pixel = (at >> 8) + 1;
    if (rows) {
      if (pixel <= band.last_column + 1) {
        Marks::cross_row(band.row(line) + max(pixel, 0));
      }
    } else if (pixel >= 0 && pixel < band.rows) {
      Marks::cross_column(band.row(pixel) + line);
    }
  }
}

// Crossings of rows, and of columns where they are marked.
template <typename Marks>
void cross(const Band& band,
           const PixelPoint& from,
           const PixelPoint& to) noexcept {
  // Products are at most what the chord is long, 2^14, in Q24.
  if ((from.y ^ to.y) >> 8 != 0) {
    cross_lines<Marks>(band, true, from.x, from.y, to.y,
                       (to.x - from.x) * 65536 / (to.y - from.y));
  }
  if (Marks::kHasColumns && (from.x ^ to.x) >> 8 != 0) {
    cross_lines<Marks>(band, false, from.y, from.x, to.x,
                       (to.y - from.y) * 65536 / (to.x - from.x));
  }
}

// Pixels along a chord, from one normal to the other, line by line across it:
//
//     | \ . . . . / |     lines of pixels of a flat chord are rows, of a steep
//     |  \_______/  |     one columns
//     | / . . . . \ |
//
template <typename Marks>
__attribute__((noinline)) void paint_strip(const Band& band,
                                           const End& before,
                                           const End& after,
                                           bool is_steep,
                                           bool is_inside_low) noexcept {
  const int32_t length = after.along - before.along;
  const int32_t rise = after.across - before.across;
  const int32_t reach = band.reach_q8;
  const int32_t slope_q14 =
      times(rise, reciprocal_of(static_cast<uint32_t>(length))) >> 2;
  const int32_t square = slope_q14 * slope_q14 >> 14;
  // 1 / sqrt(1 + square) within 0.0005.
  const int32_t cosine =
      (1 << 14) +
      (square * (-7997 + (square * (4688 - (square * 1498 >> 14)) >> 14)) >>
       14);
  // What nearness falls by from pixel to pixel. [Q6]
  const int32_t fall_across = band.fall_q14 * cosine >> 14;
  const int32_t fall_along = -(fall_across * slope_q14 >> 14);
  // Normals at the ends may lead further across than the chord's own.
  const auto aside = [cosine](int32_t far) noexcept {
    return min((cosine * far >> 14) + (far >> 2), far) + 1;
  };
  const int32_t low = aside(is_inside_low ? band.inside_q8 : band.outside_q8);
  const int32_t high = aside(is_inside_low ? band.outside_q8 : band.inside_q8);
  const int32_t last_across = is_steep ? band.last_column : band.rows - 1;
  const int32_t first_along = max((before.along - reach + 255) >> 8, 0);
  const int32_t last_along = min((after.along + reach) >> 8,
                                 is_steep ? band.rows - 1 : band.last_column);
  int32_t line = max((min(before.across, after.across) - low + 255) & ~255, 0);
  const int32_t last_line =
      min(max(before.across, after.across) + high, last_across * 256);
  if (line > last_line || first_along > last_along) {
    return;
  }
  const int32_t step = is_steep ? band.stride : 1;
  const int32_t line_step = is_steep ? 1 : band.stride;
  uint8_t* pixels = band.bytes + (line >> 8) * line_step;
  int32_t low_q16 = before.normal_q16(line) - before.slack * 256 + 0xffff;
  int32_t high_q16 = after.normal_q16(line) + after.slack * 256;
  // Nearness that is missing beside the first end. [Q14]
  int32_t missing = (line - before.across) * fall_across;
  do {
    int32_t pixel = max(low_q16 >> 16, first_along);
    const int32_t last = min(high_q16 >> 16, last_along);
    if (pixel <= last) {
      uint8_t* at = pixels + pixel * step;
      int32_t away = missing + (pixel * 256 - before.along) * fall_along;
      do {
        approach<Marks>(at, 254 - (abs(away) >> 14));
        away += fall_along * 256;
        at += step;
        ++pixel;
      } while (pixel <= last);
    }
    low_q16 -= before.lean_q14 * 4;
    high_q16 -= after.lean_q14 * 4;
    missing += fall_across * 256;
    pixels += line_step;
    line += 256;
  } while (line <= last_line);
}

// A chord shorter than kChordLimit. Both tangents lead from `from` to `to`.
template <typename Marks>
__attribute__((noinline)) void paint_short(const Band& band,
                                           const PixelPoint& from,
                                           const PixelPoint& to,
                                           const Tangent& before,
                                           const Tangent& after) noexcept {
  cross<Marks>(band, from, to);
  const bool is_steep = abs(to.y - from.y) >= abs(to.x - from.x);
  const End first(from, before, is_steep);
  const End second(to, after, is_steep);
  // What is filled lies to the left, or in a mirror to the right.
  if (first.along < second.along) {
    paint_strip<Marks>(band, first, second, is_steep,
                       is_steep == band.is_mirrored);
  } else if (first.along > second.along) {
    paint_strip<Marks>(band, second, first, is_steep,
                       is_steep != band.is_mirrored);
  }
}

// A line, or a chord of a curve, of any length.
template <typename Marks>
void paint_chord(const Band& band,
                 const PixelPoint& from,
                 const PixelPoint& to,
                 const Tangent& before,
                 const Tangent& after) noexcept {
  const int32_t dx = to.x - from.x;
  const int32_t dy = to.y - from.y;
  if (max(abs(dx), abs(dy)) < kChordLimit) {
    paint_short<Marks>(band, from, to, before, after);
    return;
  }
  const Tangent along = tangent_of(dx, dy);
  Tangent first = before;
  cut_line(from, to, kChordLimit,
           [&](const PixelPoint& at, const PixelPoint& next) noexcept {
             const bool is_last = next.x == to.x && next.y == to.y;
             paint_short<Marks>(band, at, next, first, is_last ? after : along);
             first = along;
           });
}

}  // namespace inkcell::detail::wide
