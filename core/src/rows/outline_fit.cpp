#include "rows/outline_fit.hpp"

#include "base/math.hpp"
#include "base/modular.hpp"

namespace inkcell {
namespace detail {
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
    const auto from = static_cast<int32_t>(
        (static_cast<uint32_t>(at_q8) - static_cast<uint32_t>(origin_q8_)) *
        static_cast<uint32_t>(sign));
    int32_t px_q8 = from;
    if (samples_ != 1) {
      px_q8 = static_cast<int32_t>(int64_t{from} * 21846 >> 16);
    }
    return static_cast<int32_t>(static_cast<uint32_t>(origin_q8_) +
                                static_cast<uint32_t>(map_.map(px_q8, knot_)) *
                                    static_cast<uint32_t>(sign * samples_));
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

// Sizes that are fitted are below 2^12 [px, Q6], so that products have 31 bits;
// others wrap.
int32_t to_px(const Font& font, Q26_6 size, int32_t units) noexcept {
  return quotient(product(units, size.raw), font.units_per_em() * 64);
}

int32_t to_units(const Font& font, Q26_6 size, int32_t px) noexcept {
  const int32_t size_q6 = size.raw;
  const int32_t em_q6 = font.units_per_em() * 64;
  // Whole units of a pixel, and what is left.
  const int32_t whole = quotient(em_q6, size_q6);
  const int32_t part = product(px, em_q6 - whole * size_q6);
  const int32_t half = part < 0 ? -(size_q6 >> 1) : size_q6 >> 1;
  return px * whole + quotient(part + half, size_q6);
}

}  // namespace

const OutlineFitter kOutlineFitter = {fit_outline, move_points, to_px,
                                      to_units};

}  // namespace detail
}  // namespace inkcell
