// Grid fitting of outlines: points that give way to the grid of pixels.
#include "rows/outline_source.hpp"

#include "base/math.hpp"

namespace inkcell::detail {
namespace {

// A map for points that follow each other, from an origin in samples.
class AxisWarp {
 public:
  AxisWarp(const AxisMap& map, int32_t origin_q8, int32_t samples) noexcept
      : map_(map), origin_q8_(origin_q8), samples_(samples) {}

  // `sign` is -1 where points count down.
  int32_t to(int32_t at_q8, int32_t sign) noexcept {
    if (map_.count == 0) {
      return at_q8;
    }
    // Points of hostile fonts lie anywhere: modulo 2^32.
    const int32_t from = product(sum(at_q8, -origin_q8_), sign);
    const int32_t px_q8 =
        samples_ == 1 ? from
                      : static_cast<int32_t>(int64_t{from} * 21846 >> 16);
    return sum(origin_q8_, product(map_.map(px_q8, knot_), sign * samples_));
  }

 private:
  const AxisMap& map_;
  int32_t origin_q8_;
  int32_t samples_;  // a pixel, 1 or 3
  int32_t knot_ = 0;
};

// Moves both ends of an upright glyph as its points. `sign` is -1 where places
// count down. Points of hostile fonts lie anywhere: modulo 2^32.
void move_ends(const AxisMap& map, int32_t sign, InkEnds& ends) noexcept {
  constexpr int32_t kRoundings = 1 << 11;
  const auto moved = [&](int32_t at) noexcept {
    return product(map.map(product(at >> 10, sign)), sign * (1 << 10));
  };
  if (map.count != 0) {
    ends = {sum(moved(ends.low), -kRoundings),
            sum(moved(ends.high), kRoundings)};
  }
}

bool fit_outline(OutlineJob& job,
                 const Font& font,
                 uint16_t glyph,
                 Placed& placed,
                 InkEnds (&ink)[2]) noexcept {
  auto& warp = *reinterpret_cast<GlyphWarp*>(job.ram);
  job.ram += sizeof warp;
  job.ram_bytes -= int32_t{sizeof warp};
  const Style& style = *job.style;
  FinePoint origin = placed.origin();
  style.fitter()->fit(font, style, glyph, job.outline.metrics(), origin, warp);
  if ((warp.x.count | warp.y.count) != 0) {
    job.warp = &warp;
    move_ends(warp.x, 1, ink[0]);
    move_ends(warp.y, -1, ink[1]);
  }
  return placed.set(origin);
}

void move_points(const OutlineJob& job,
                 ScreenPoint* points,
                 const ScreenPoint* end) noexcept {
  const OutlineGlyph& outline = job.outline;
  AxisWarp x(job.warp->x, outline.origin_x_q8(), job.plan.columns);
  AxisWarp y(job.warp->y, outline.origin_y_q8(), job.plan.rows);
  for (; points != end; ++points) {
    *points = ScreenPoint::at(x.to(points->x_q8, 1), y.to(points->y_q8(), -1),
                              points->kind());
  }
}

// A pen that is ahead or behind by more is corrected beside blanks, and within
// words by more than the second. [px, Q6]
constexpr int32_t kMostDrift = 32;
constexpr int32_t kMostInWord = 96;
constexpr int32_t kFarthest = 1 << 20;

bool is_blank(const Font& font, uint16_t glyph) noexcept {
  GlyphMetrics metrics;
  return font.glyph_metrics(glyph, metrics) == Status::ok &&
         metrics.x_max <= metrics.x_min;
}

// Sizes that are fitted are below 2^12 [px, Q6], so that products have 31 bits;
// others wrap. [px, Q6]
int32_t rounded_px(const Font& font,
                   const Style& style,
                   int32_t units) noexcept {
  return quotient(product(units, style.size().raw), font.units_per_em());
}

// How many of a pair are digits, whose ids follow each other as their code
// points do. Those stand in columns.
uint32_t count_digits(const Font& font, const GlyphPair& pair) noexcept {
  uint16_t zero = 0;
  if (font.glyph_of('0', zero) != Status::ok) {
    return 0;
  }
  const auto is_digit = [zero](uint32_t glyph) noexcept {
    return glyph - zero < 10 ? 1u : 0u;
  };
  return is_digit(pair.left) + is_digit(pair.right);
}

// How much closer two glyphs may come until less than a pixel is between them;
// those that reach over each other come no closer than designed. [px]
int32_t room_to_kern(const Font& font,
                     const Style& style,
                     const Fitter& fitter,
                     const GlyphPair& pair,
                     int32_t kerning_q6) noexcept {
  const FitGap gap = fitter.gap(font, style, pair.left, pair.right);
  const int32_t designed = gap.designed_q6 + kerning_q6;
  return (gap.fitted_q6 - (designed > -32 ? 64 : -(-designed & ~63))) >> 6;
}

int32_t join(const Font& font,
             const Style& style,
             const Fitter& fitter,
             const GlyphPair& pair,
             int32_t& drift_q6) noexcept {
  const int32_t kerning_q6 = pair.kerning == 0 || count_digits(font, pair) == 2
                                 ? 0
                                 : rounded_px(font, style, pair.kerning);
  int32_t px = quotient(kerning_q6, 64);
  if (px < 0) {
    px = min(max(px, -room_to_kern(font, style, fitter, pair, kerning_q6)), 0);
  }
  const int32_t advance = font.advance(pair.left);
  const int32_t advance_px = fitter.advance_px(font, style, pair.left);
  const int32_t drift = drift_q6 - kerning_q6 + (px + advance_px) * 64 -
                        rounded_px(font, style, advance);
  // Glyphs of one width stand in columns.
  int32_t more = 0;
  if (abs(drift) > kMostDrift &&
      abs(advance - font.advance(pair.right)) * 32 >= advance) {
    // A blank gives a pixel in front from 4 px on, from 3 px if the pen is far
    // ahead, and another one behind from 8.
    const bool is_far = abs(drift) > kMostInWord;
    int32_t blank_px = 0;
    bool has_blank = is_blank(font, pair.left);
    if (has_blank) {
      blank_px = advance_px - 7;
    } else if (is_blank(font, pair.right)) {
      has_blank = true;
      blank_px = fitter.advance_px(font, style, pair.right) - (is_far ? 2 : 3);
    }
    if (drift < 0) {
      more = has_blank || is_far ? 1 : 0;
    } else if (blank_px > 0 ||
               (is_far && !has_blank && count_digits(font, pair) == 0 &&
                room_to_kern(font, style, fitter, pair, kerning_q6) > -px)) {
      more = -1;
    }
  }
  drift_q6 = min(max(drift + more * 64, -kFarthest), kFarthest);
  return px + more;
}

int32_t fitted_units(const Font& font, Q26_6 size, int32_t px) noexcept {
  const int32_t size_q6 = size.raw;
  const int32_t em_q6 = font.units_per_em() * 64;
  // Whole units of a pixel, and what is left.
  const int32_t whole = quotient(em_q6, size_q6);
  const int32_t part = product(px, em_q6 - whole * size_q6);
  const int32_t half = part < 0 ? -(size_q6 >> 1) : size_q6 >> 1;
  return px * whole + quotient(part + half, size_q6);
}

}  // namespace

const OutlineFitter kOutlineFitter = {fit_outline, move_points, join,
                                      fitted_units};

}  // namespace inkcell::detail
