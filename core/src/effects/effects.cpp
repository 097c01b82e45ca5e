#include "inkcell/effects.hpp"

#include "base/math.hpp"
#include "distance/point_walk.hpp"
#include "place/painted_box.hpp"
#include "sink/span_writer.hpp"

namespace inkcell {
namespace {

using detail::FieldPosition;
using detail::max;
using detail::min;
using detail::PointWalk;
using detail::SpanWriter;

// Hands on pixels of a row, but those at the ends that are empty.
void emit(const Sink& sink,
          int32_t x,
          int32_t y,
          const uint8_t* coverage,
          int32_t count) noexcept {
  int32_t begin = 0;
  while (begin < count && coverage[begin] == 0) {
    ++begin;
  }
  while (count > begin && coverage[count - 1] == 0) {
    --count;
  }
  int32_t full = begin;
  while (full < count && coverage[full] == 255) {
    ++full;
  }
  if (begin == count) {
    return;
  }
  if (full == count) {
    sink.solid(sink.context, x + begin, y, count - begin);
  } else {
    sink.coverage(sink.context, x + begin, y, coverage + begin, count - begin);
  }
}

// What drawing both painters takes, in a frame of its own: none shall be large.
struct Rows {
  const TextStyle& style;
  const Filter& inner;
  const FinePoint& origin;
  Rect box;

  FieldPosition at(int32_t y) const noexcept {
    return detail::sample_position(style, origin, box.x0, y, {0, 0});
  }
  int32_t reach_q22() const noexcept {
    return max(detail::reach_of(style.filter()), detail::reach_of(inner));
  }
};

__attribute__((noinline)) void draw_outline(const Rows& rows,
                                            PointWalk& walk,
                                            const Sink& sink) noexcept {
  const Filter& outer = rows.style.filter();
  const FieldPosition step = detail::pixel_step(rows.style);
  SpanWriter writer(sink, rows.box.y0);
  for (int32_t y = rows.box.y0; y < rows.box.y1; ++y) {
    FieldPosition at = rows.at(y);
    for (int32_t x = rows.box.x0; x < rows.box.x1; ++x) {
      const int32_t d = walk.distance_q10(at);
      writer.put(x, static_cast<uint8_t>(
                        max(outer.coverage(d) - rows.inner.coverage(d), 0)));
      at = detail::moved(at, step);
    }
    writer.next_row();
  }
}

// Up to kMaxSpan pixels of a row.
__attribute__((noinline)) void draw_both(const Rows& rows,
                                         PointWalk& walk,
                                         const Sink& sink,
                                         const Sink& fill_sink,
                                         FieldPosition& at,
                                         int32_t x,
                                         int32_t y) noexcept {
  const Filter& outer = rows.style.filter();
  const FieldPosition step = detail::pixel_step(rows.style);
  uint8_t outline[kMaxSpan];
  uint8_t fill[kMaxSpan];
  const int32_t count = min(kMaxSpan, rows.box.x1 - x);
  for (int32_t i = 0; i < count; ++i) {
    const int32_t d = walk.distance_q10(at);
    fill[i] = rows.inner.coverage(d);
    // Where the fill is solid nothing of the outline is left to see.
    outline[i] = fill[i] == 255 ? uint8_t{0} : outer.coverage(d);
    at = detail::moved(at, step);
  }
  emit(sink, x, y, outline, count);
  emit(fill_sink, x, y, fill, count);
}

}  // namespace

Status check_reach(const FontRange& range,
                   Q26_6 size,
                   const Filter& filter) noexcept {
  const int32_t reach_q10 = max(-filter.outside_q10, filter.inside_q10);
  // The band is 1/1024 em, so that both sides are 1/1024 px, Q6.
  return int64_t{reach_q10} * 64 > (int64_t{range.band_u} + 1) * size.raw
             ? Status::beyond_band
             : Status::ok;
}

void detail::paint_outline(const GlyphField& field,
                           const TextStyle& style,
                           const void* options,
                           const FinePoint& origin,
                           const Sink& sink) {
  const Rows all = {
      style, *static_cast<const Filter*>(options), origin,
      detail::painted_box(field, style, origin, sink.window, 0, 0)};
  PointWalk walk(field, style, all.reach_q22());
  draw_outline(all, walk, sink);
}

void detail::paint_outline_and_fill(const GlyphField& field,
                                    const TextStyle& style,
                                    const void* options,
                                    const FinePoint& origin,
                                    const Sink& sink) {
  const OutlineAndFill& both = *static_cast<const OutlineAndFill*>(options);
  const Rows all = {
      style, *both.inner, origin,
      detail::painted_box(field, style, origin,
                          intersect(sink.window, both.fill->window), 0, 0)};
  PointWalk walk(field, style, all.reach_q22());
  for (int32_t y = all.box.y0; y < all.box.y1; ++y) {
    FieldPosition at = all.at(y);
    for (int32_t x = all.box.x0; x < all.box.x1; x += kMaxSpan) {
      draw_both(all, walk, sink, *both.fill, at, x, y);
    }
  }
}

}  // namespace inkcell
