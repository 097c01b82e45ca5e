// Slanted rows of cells, pixel by pixel.
#include "field_turned.hpp"

#include "cell_access.hpp"
#include "position.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace detail {
namespace {

uint8_t turned_coverage(const GlyphField& field,
                        const Brush& brush,
                        const FieldPosition& at) noexcept {
  if (has_fields(field)) {
    return brush.filter().coverage(
        fields_distance_q10(field, brush, at, reach_of(brush.filter())));
  }
  return brush.coverage(samples_distance_q10(field, at.x_q16, at.y_q16));
}

uint8_t stretched_coverage(const GlyphField& field,
                           const Brush& brush,
                           const FieldPosition& at) noexcept {
  return brush.filter().coverage(
      has_fields(field)
          ? stretched_fields_q10(field, brush, at, reach_of(brush.filter()))
          : stretched_samples_q10(field, brush, at));
}

using Coverage = uint8_t (*)(const GlyphField&,
                             const Brush&,
                             const FieldPosition&);

void paint(const GlyphField& field,
           const Brush& brush,
           const FinePoint& origin,
           const Sink& sink,
           Coverage coverage) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  SpanWriter writer(sink, box.y0);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const FieldPosition at = position_of(brush, origin, x, y);
      writer.put(x, coverage(field, brush, at));
    }
    writer.next_row();
  }
}

}  // namespace

void paint_turned(const GlyphField& field,
                  const Brush& brush,
                  const void*,
                  const FinePoint& origin,
                  const RowMap*,
                  const Sink& sink) noexcept {
  paint(field, brush, origin, sink, turned_coverage);
}

void paint_stretched(const GlyphField& field,
                     const Brush& brush,
                     const void*,
                     const FinePoint& origin,
                     const RowMap*,
                     const Sink& sink) noexcept {
  paint(field, brush, origin, sink, stretched_coverage);
}

}  // namespace detail
}  // namespace inkcell
