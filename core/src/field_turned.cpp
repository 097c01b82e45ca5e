// Slanted text: cells of samples are quartic along a row, so that every pixel
// is a query of its own.
#include "field_turned.hpp"

#include "cell_access.hpp"
#include "field_draw.hpp"
#include "position.hpp"
#include "span_writer.hpp"

namespace inkcell {

void detail::paint_turned(const GlyphField& field,
                          const Brush& brush,
                          const void*,
                          const FinePoint& origin,
                          const RowMap*,
                          const Sink& sink) noexcept {
  const Rect box = intersect(field_box(field, brush, origin), sink.window);
  const int32_t reach_q22 = reach_of(brush.filter());
  for (int32_t y = box.y0; y < box.y1; ++y) {
    SpanWriter writer(sink, y);
    FieldPosition at = position_of(brush, origin, box.x0, y);
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const uint8_t coverage =
          has_fields(field)
              ? brush.filter().coverage(
                    fields_distance_q10(field, brush, at, reach_q22))
              : brush.coverage(samples_distance_q10(field, at.x_q16, at.y_q16));
      writer.put(x, coverage);
      at.x_q16 += brush.step_along_q16();
      at.y_q16 -= brush.step_across_q16();
      at.x_q20 += static_cast<uint32_t>(along_q20(brush));
      at.y_q20 -= static_cast<uint32_t>(across_q20(brush));
    }
    writer.flush();
  }
}

}  // namespace inkcell
