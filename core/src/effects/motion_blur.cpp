#include "inkcell/motion_blur.hpp"

#include "base/math.hpp"
#include "distance/sampler.hpp"
#include "raster/draw_cells.hpp"
#include "sink/row_writer.hpp"

namespace inkcell {
namespace {

using detail::abs;
using detail::CellSampler;
using detail::GlyphPoint;
using detail::moved;
using detail::offset_of;
using detail::RowWriter;

// A distance as a place in the filter's table, which goes on to both sides.
// [entries, Q8]
int32_t place_q8(const Filter& filter, int32_t distance_q10) noexcept {
  return ((distance_q10 - filter.outside_q10) * filter.scale) >> 6;
}

// Coverage summed up to a place. [entries, Q8]
int32_t sum_q8(const MotionBlur& blur, int32_t place_q8) noexcept {
  constexpr int32_t kEnd = Filter::kEntries << 8;
  if (place_q8 <= 0) {
    return 0;
  }
  if (place_q8 >= kEnd) {
    return blur.sums[Filter::kEntries] * 256 + (place_q8 - kEnd) * 255;
  }
  const int32_t entry = place_q8 >> 8;
  return blur.sums[entry] * 256 + blur.filter.table[entry] * (place_q8 & 255);
}

// The mean coverage between two places.
int32_t mean_coverage(const MotionBlur& blur,
                      int32_t a_q8,
                      int32_t b_q8) noexcept {
  // Closer than an entry there is nothing to integrate.
  if (abs(b_q8 - a_q8) < 256) {
    const int32_t middle = (a_q8 + b_q8) >> 9;
    return middle < 0                  ? 0
           : middle < Filter::kEntries ? blur.filter.table[middle]
                                       : 255;
  }
  return (sum_q8(blur, b_q8) - sum_q8(blur, a_q8)) / (b_q8 - a_q8);
}

// What the pixels of a glyph have in common.
struct Shot {
  const MotionBlur& blur;
  CellSampler sampler;
  GlyphPoint step;
  int32_t low_q10;
  int32_t high_q10;

  // Beyond the ramp by a step's length nothing shows: what saturated cells say
  // must not count for more.
  int32_t place_at(const GlyphPoint& at) noexcept {
    int32_t distance_q10 = sampler.distance_q10(at);
    distance_q10 = distance_q10 < low_q10 ? low_q10 : distance_q10;
    distance_q10 = distance_q10 > high_q10 ? high_q10 : distance_q10;
    return place_q8(blur.filter, distance_q10);
  }
};

__attribute__((noinline)) uint8_t coverage_at(Shot& shot,
                                              GlyphPoint at) noexcept {
  const int32_t steps = shot.blur.steps;
  int32_t before = shot.place_at(at);
  int32_t sum = 0;
  for (int32_t i = 0; i < steps; ++i) {
    at = moved(at, shot.step);
    const int32_t after = shot.place_at(at);
    sum += mean_coverage(shot.blur, before, after);
    before = after;
  }
  return static_cast<uint8_t>((sum + steps / 2) / steps);
}

__attribute__((noinline)) void draw_row(Shot& shot,
                                        const TextStyle& style,
                                        const FinePoint& origin,
                                        const Rect& box,
                                        int32_t y,
                                        const Sink& sink) noexcept {
  const MotionBlur& blur = shot.blur;
  GlyphPoint at = shot.sampler.point(
      origin, box.x0, y,
      {-blur.right_q10 * blur.steps / 2, -blur.up_q10 * blur.steps / 2});
  const GlyphPoint step = offset_of(style, {1 << 10, 0});
  RowWriter writer(sink, y);
  for (int32_t x = box.x0; x < box.x1; ++x) {
    writer.put(x, coverage_at(shot, at));
    at = moved(at, step);
  }
  writer.next_row();
}

}  // namespace

Status make_motion_blur(const Filter& filter,
                        Point way,
                        MotionBlur& out) noexcept {
  constexpr int32_t kMost = 32 << 6;
  if (way.x.raw > kMost || way.x.raw < -kMost || way.y.raw > kMost ||
      way.y.raw < -kMost) {
    return Status::bad_argument;
  }
  const int32_t x = abs(way.x.raw);
  const int32_t y = abs(way.y.raw);
  // From the length to 3/2 of it; steps are no longer than a pixel along an
  // axis.
  const int32_t longer = x > y ? x : y;
  const int32_t steps = longer <= 64 ? 1 : (longer + 63) >> 6;
  out.filter = filter;
  uint32_t sum = 0;
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    out.sums[i] = static_cast<uint16_t>(sum);
    sum += filter.table[i];
  }
  out.sums[Filter::kEntries] = static_cast<uint16_t>(sum);
  out.steps = static_cast<uint8_t>(steps);
  out.right_q10 = way.x.raw * 16 / steps;
  out.up_q10 = -way.y.raw * 16 / steps;
  out.length_q10 = (x + y) * 16 / steps;
  out.reach_px = static_cast<uint8_t>((longer >> 7) + 1);
  return Status::ok;
}

void detail::paint_motion_blur(const GlyphField& field,
                               const TextStyle& style,
                               const void* options,
                               const FinePoint& origin,
                               const Sink& sink) {
  const auto& blur = *static_cast<const MotionBlur*>(options);
  const Rect box = detail::visible_pixels(field, style, origin, sink.window);
  Shot shot = {blur, CellSampler(field, style, detail::kNoReach),
               offset_of(style, {blur.right_q10, blur.up_q10}),
               blur.filter.outside_q10 - blur.length_q10,
               blur.filter.inside_q10 + blur.length_q10};
  for (int32_t y = box.y0; y < box.y1; ++y) {
    draw_row(shot, style, origin, box, y, sink);
  }
}

}  // namespace inkcell
