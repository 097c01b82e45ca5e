// Rows of cells of fields: fastest where cells have few pixels, and the only
// way for rows that are fitted to the grid.
#include "field_draw.hpp"

#include "cell_access.hpp"
#include "field_row.hpp"
#include "order.hpp"
#include "position.hpp"

namespace inkcell {
namespace detail {
namespace {

__attribute__((noinline)) void draw_rows(const GlyphField& field,
                                         const Brush& brush,
                                         const Placed& placed,
                                         const Sink& sink) noexcept {
  Upright upright = place_upright(field, brush, placed, sink.window);
  const Rect& pixels = upright.pixels;
  if (is_empty(pixels)) {
    return;
  }
  const CoverageRamp ramp(brush.filter());
  const auto step_q16 = static_cast<uint32_t>(brush.step_along_q16());
  FieldRow row(field, scale_of(brush), reach_of(brush.filter()),
               brush.step_along_q16());
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    RowHeight height;
    if (upright.place_row(brush, height)) {
      row.go_to(height.y_q16, height.y_q20);
      RowPoint first = row.point(upright.at.x_q16, upright.at.x_q20);
      for (int32_t x = pixels.x0; x < pixels.x1; x += kMaxSpan) {
        uint8_t line[kMaxSpan];
        const int32_t count = lesser(pixels.x1 - x, kMaxSpan);
        if (row.cover(first, ramp, line, count)) {
          sink.coverage(sink.context, x, y, line, count);
        }
        first.x_q16 += kMaxSpan * step_q16;
        first.x_q20 += kMaxSpan << 20;
      }
    }
    upright.next_row(brush);
  }
}

// Object order wins from this size on. [px to the em, Q8]
constexpr uint32_t kCellsFromQ8 = 50 << 8;

}  // namespace

void draw_fields(const GlyphField& field,
                 const Brush& brush,
                 const Placed& placed,
                 const Sink& sink) noexcept {
  if (INKCELL_OBJECT_ORDER != 0 && placed.rows == nullptr &&
      scale_of(brush).size_q8 >= kCellsFromQ8) {
    draw_by_cells(field, brush, placed, sink);
  } else {
    draw_rows(field, brush, placed, sink);
  }
}

int32_t fields_distance_q10(const GlyphField& field,
                            const Brush& brush,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  Cell cell;
  if (in_grid(field, x_u, y_u)) {
    cell = locate_fields(field, x_u, y_u);
  }
  if (cell.field_count == 0) {
    return brush.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                       : -kSaturatedDistanceQ10);
  }
  FieldTerms terms;
  set_up_terms(terms, field, cell, q8_of(at.x_q20), q8_of(at.y_q20),
               scale_of(brush));
  return combine_q22(terms, brush.bend_log2(), reach_q22) >> 12;
}

}  // namespace detail
}  // namespace inkcell
