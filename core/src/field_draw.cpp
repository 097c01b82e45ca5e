// Rows of cells of fields, pixel by pixel: fastest where cells have few pixels,
// and rows that are fitted to the grid. Each pixel is evaluated for itself, and
// no further than to the first field that decides it.
#include "field_draw.hpp"

#include "cell_access.hpp"
#include "field_combine.hpp"

namespace inkcell {
namespace detail {
namespace {

// The value of one field at a pixel.
__attribute__((always_inline)) inline int32_t value_at(
    const FieldPage& page, uint32_t unit, PixelPlace place) noexcept {
  FieldTerm term;
  set_up_term(term, page.field, unit, place.x_q8, place.y_q8, page.scale);
  return term.value_q22(page.scale.bend_log2);
}

// The distance of one pixel of a leaf of several fields, or what is as far on
// the same side.
__attribute__((noinline)) int32_t several_at(const FieldPage& page,
                                             const LeafFields& leaf,
                                             PixelPlace place) noexcept {
  int32_t values[3];
  for (uint32_t i = 0; i < leaf.count; ++i) {
    values[i] = with_sign(value_at(page, leaf.units[i], place), leaf.sign);
    if (values[i] <= -page.reach_q22 && (i == 0 || !leaf.is_nested)) {
      return with_sign(values[i], leaf.sign);
    }
  }
  return with_sign(combined(page, leaf, values, place), leaf.sign);
}

// The same of two fields, which are frequent.
inline int32_t pair_at(const FieldPage& page,
                       const LeafFields& leaf,
                       PixelPlace place) noexcept {
  int32_t values[2];
  values[0] = with_sign(value_at(page, leaf.units[0], place), leaf.sign);
  int32_t least = values[0];
  if (least > -page.reach_q22) {
    values[1] = with_sign(value_at(page, leaf.units[1], place), leaf.sign);
    const bool in_order = least <= values[1];
    least = in_order ? least : values[1];
    // Where the greater one is farther from 0 no vertex is near.
    if (least < 0 && least > -page.reach_q22 && values[0] + values[1] < 0) {
      least = rounded_at(page, leaf, in_order ? 0 : 1, in_order ? 1 : 0, values,
                         place);
    }
  }
  return with_sign(least, leaf.sign);
}

// The leaf at a point, in u from the grid's corner.
inline Leaf find_leaf(const GlyphField& field,
                      uint32_t x,
                      uint32_t y) noexcept {
  const uint32_t tile =
      (y >> field.tile_log2) * field.tiles_x + (x >> field.tile_log2);
  return field.kind == GlyphField::Kind::narrow_fields
             ? find_narrow_leaf(field, tile, x, y)
             : find_linked_leaf(field, tile, x, y);
}

// Draws a row of the grid; `x_q16` is from its left edge, `y` in u from its
// lower one.
inline void draw_row(FieldPage& page,
                     Range pixels,
                     PixelPlace place,
                     int32_t x_q16,
                     uint32_t y) noexcept {
  const GlyphField& field = page.field;
  int32_t x = pixels.begin;
  while (x < pixels.end) {
    const Leaf found = find_leaf(field, static_cast<uint32_t>(x_q16) >> 16, y);
    const uint32_t size_log2 = 16 + found.size_log2;
    const int32_t right_q16 = ((x_q16 >> size_log2) + 1) << size_log2;
    LeafFields leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf(field, found.reference, leaf);
    }
    if (leaf.count == 0) {
      const int32_t first = x;
      do {
        ++x;
        x_q16 += page.step_q16;
      } while (x < pixels.end && x_q16 < right_q16);
      page.writer.saturated(first, x - first,
                            found.reference == format::glyph::kInside);
      place.x_q8 += static_cast<uint32_t>(x - first) << 8;
      continue;
    }
    page.writer.begin(x);
    do {
      const int32_t value_q22 =
          leaf.count == 1   ? value_at(page, leaf.units[0], place)
          : leaf.count == 2 ? pair_at(page, leaf, place)
                            : several_at(page, leaf, place);
      ++x;
      page.writer.append(page.filter.coverage(value_q22 >> 12), x);
      place.x_q8 += 1 << 8;
      x_q16 += page.step_q16;
    } while (x < pixels.end && x_q16 < right_q16);
  }
}

// Object order wins from this size on. [px to the em, Q8]
constexpr uint32_t kCellsFromQ8 = 40 << 8;

}  // namespace

void draw_fields(const GlyphField& field,
                 const Brush& brush,
                 Upright& upright,
                 const Sink& sink) noexcept {
  const Rect& pixels = upright.pixels;
  FieldPage page = {field,
                    brush.filter(),
                    scale_of(brush),
                    reach_of(brush.filter()),
                    brush.step_along_q16(),
                    SpanWriter(sink, pixels.y0)};
  if (upright.rows == nullptr && page.scale.size_q8 >= kCellsFromQ8) {
    draw_by_cells(page, upright);
    return;
  }
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    FieldPosition at;
    if (upright.place_row(brush, at)) {
      draw_row(page, {pixels.x0, pixels.x1}, {q8_of(at.x_q20), q8_of(at.y_q20)},
               at.x_q16 - field.x0_u * (1 << 16),
               static_cast<uint32_t>(at.y_q16 - field.y0_u * (1 << 16)) >> 16);
    }
    page.writer.next_row();
    upright.next_row(brush);
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
