#include "inkcell/effects.hpp"

#include "point_walk.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace {

using detail::FieldPosition;
using detail::PointWalk;
using detail::SpanWriter;

int32_t lesser(int32_t a, int32_t b) noexcept {
  return a < b ? a : b;
}
int32_t greater(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

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

}  // namespace

Status check_reach(const FontRange& range,
                   Q26_6 size,
                   const Filter& filter) noexcept {
  const int32_t reach_q10 = greater(-filter.outside_q10, filter.inside_q10);
  // The band is 1/1024 em, so that both sides are 1/1024 px, Q6.
  return int64_t{reach_q10} * 64 > (int64_t{range.band_u} + 1) * size.raw
             ? Status::beyond_band
             : Status::ok;
}

void paint_outline(const GlyphField& field,
                   const Brush& brush,
                   const void* options,
                   const FinePoint& origin,
                   const RowMap* rows,
                   const Sink& sink) {
  const Filter& outer = brush.filter();
  const Filter& inner = *static_cast<const Filter*>(options);
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  PointWalk walk(field, brush,
                 greater(detail::reach_of(outer), detail::reach_of(inner)));
  const FieldPosition step = detail::pixel_step(brush);
  SpanWriter writer(sink, box.y0);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    FieldPosition at =
        detail::sample_position(brush, origin, rows, box.x0, y, {0, 0});
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const int32_t d = walk.distance_q10(at);
      writer.put(x, static_cast<uint8_t>(
                        greater(outer.coverage(d) - inner.coverage(d), 0)));
      at = detail::moved(at, step);
    }
    writer.next_row();
  }
}

void paint_outline_and_fill(const GlyphField& field,
                            const Brush& brush,
                            const void* options,
                            const FinePoint& origin,
                            const RowMap* rows,
                            const Sink& sink) {
  const OutlineAndFill& both = *static_cast<const OutlineAndFill*>(options);
  const Filter& outer = brush.filter();
  const Filter& inner = *both.inner;
  const Rect box = intersect(field_box(field, brush, origin),
                             intersect(sink.window, both.fill->window));
  PointWalk walk(field, brush,
                 greater(detail::reach_of(outer), detail::reach_of(inner)));
  const FieldPosition step = detail::pixel_step(brush);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    FieldPosition at =
        detail::sample_position(brush, origin, rows, box.x0, y, {0, 0});
    for (int32_t x = box.x0; x < box.x1; x += kMaxSpan) {
      uint8_t outline[kMaxSpan];
      uint8_t fill[kMaxSpan];
      const int32_t count = lesser(kMaxSpan, box.x1 - x);
      for (int32_t i = 0; i < count; ++i) {
        const int32_t d = walk.distance_q10(at);
        fill[i] = inner.coverage(d);
        // Where the fill is solid nothing of the outline is left to see.
        outline[i] = fill[i] == 255 ? uint8_t{0} : outer.coverage(d);
        at = detail::moved(at, step);
      }
      emit(sink, x, y, outline, count);
      emit(*both.fill, x, y, fill, count);
    }
  }
}

}  // namespace inkcell
