// Rows of cells of fields, pixel by pixel: fastest where cells have few pixels,
// and rows that are fitted to the grid. Each pixel is evaluated for itself, and
// no further than to the first field that decides it.
#include "field_draw.hpp"

#include "cell_access.hpp"
#include "field_combine.hpp"

namespace inkcell {
namespace detail {
namespace {

// What it takes to evaluate fields, and the row.
struct Row {
  const uint8_t* cells;
  uint32_t size_q8;
  int32_t bend_q14;
  int32_t bend_shift;
  int32_t reach_q22;
  uint32_t y_q8;

  Row(const FieldPage& page, uint32_t at_q8) noexcept
      : cells(page.field.cells),
        size_q8(page.scale.size_q8),
        bend_q14(page.scale.bend_q14),
        bend_shift(page.scale.bend_log2 + 5),
        reach_q22(page.reach_q22),
        y_q8(at_q8) {}

  // The value of a field at a pixel: FieldTerm::value_q22 in one step. [px]
  int32_t value_q22(uint32_t unit, uint32_t x_q8) const noexcept {
    namespace fields = format::fields;
    const uint8_t* at = cells + 2 * (unit & format::linked::kOffsetMask);
    const int32_t nx = load_i16(at + fields::kNormalX);
    const int32_t ny = load_i16(at + fields::kNormalY);
    uint32_t value = times(nx, x_q8) + times(ny, y_q8) +
                     times(load_i16(at + fields::kOffset), size_q8);
    if ((unit & format::linked::kArcField) != 0) {
      const int32_t along_q8 =
          wrapped(times(nx, y_q8) - times(ny, x_q8) + (1 << 13) +
                  times(load_i16(at + fields::kAlong), size_q8)) >>
          14;
      const int32_t bend =
          (load_i16(at + fields::kBend) * bend_q14 + (1 << 10)) >> 11;
      const auto along = static_cast<uint32_t>(along_q8);
      const int32_t slope = wrapped(times(bend, along)) >> bend_shift;
      value += static_cast<uint32_t>(wrapped(times(slope, along)) >> 1);
    }
    return wrapped(value);
  }
};

// The distance of one pixel of a leaf of three fields, or what is as far on the
// same side. With the leaf's sign, as two_at's.
int32_t three_at(const FieldPage& page,
                 const Row& row,
                 const LeafFields& leaf,
                 uint32_t x_q8) noexcept {
  const int32_t reach_q22 = row.reach_q22;
  int32_t values[3];
  values[0] = with_sign(row.value_q22(leaf.units[0], x_q8), leaf.sign);
  if (values[0] <= -reach_q22) {
    return values[0];
  }
  values[1] = with_sign(row.value_q22(leaf.units[1], x_q8), leaf.sign);
  int32_t least = values[0];
  if (leaf.is_nested) {
    if (values[1] >= reach_q22) {
      return least;
    }
    values[2] = with_sign(row.value_q22(leaf.units[2], x_q8), leaf.sign);
    const int32_t inner = values[1] >= values[2] ? values[1] : values[2];
    least = least <= inner ? least : inner;
    if (least <= -reach_q22 || least >= reach_q22) {
      return least;
    }
  } else {
    if (values[1] <= -reach_q22) {
      return values[1];
    }
    values[2] = with_sign(row.value_q22(leaf.units[2], x_q8), leaf.sign);
    least = least <= values[1] ? least : values[1];
    least = least <= values[2] ? least : values[2];
    if (least <= -reach_q22 || least >= 0) {
      return least;
    }
  }
  return combined(page, leaf, values, {x_q8, row.y_q8});
}

// The same of two fields, which are frequent.
inline int32_t two_at(const FieldPage& page,
                      const Row& row,
                      const LeafFields& leaf,
                      uint32_t x_q8) noexcept {
  int32_t values[2];
  values[0] = with_sign(row.value_q22(leaf.units[0], x_q8), leaf.sign);
  int32_t least = values[0];
  if (least > -row.reach_q22) {
    values[1] = with_sign(row.value_q22(leaf.units[1], x_q8), leaf.sign);
    const bool in_order = least <= values[1];
    least = in_order ? least : values[1];
    // Where the greater one is farther from 0 no vertex is near.
    if (least < 0 && least > -row.reach_q22 && values[0] + values[1] < 0) {
      least = rounded_at(page, leaf, in_order ? 0 : 1, in_order ? 1 : 0, values,
                         {x_q8, row.y_q8});
    }
  }
  return least;
}

// Draws a row of the grid from `x_q16` on, of u from its left edge; `y` in u
// from its lower one.
template <bool kNarrow>
__attribute__((noinline)) void draw_row(FieldPage& page,
                                        Range pixels,
                                        PixelPlace place,
                                        uint32_t x_q16,
                                        uint32_t y) noexcept {
  const GlyphField& field = page.field;
  const Filter& filter = page.filter;
  const Row row(page, place.y_q8);
  const auto step = static_cast<uint32_t>(page.step_q16);
  const uint32_t end_q16 =
      x_q16 + static_cast<uint32_t>(pixels.end - pixels.begin) * step;
  const uint32_t first_tile = (y >> field.tile_log2) * field.tiles_x;
  // Pixel `x` is at x_q8.
  uint32_t x_q8 = place.x_q8;
  const int32_t from_x = pixels.begin;
  const auto pixel = [&x_q8, &place, from_x] {
    return from_x + static_cast<int32_t>((x_q8 - place.x_q8) >> 8);
  };
  while (x_q16 < end_q16) {
    const uint32_t x = x_q16 >> 16;
    const uint32_t tile = first_tile + (x >> field.tile_log2);
    const Leaf found = kNarrow ? find_narrow_leaf(field, tile, x, y)
                               : find_linked_leaf(field, tile, x, y);
    const uint32_t size_log2 = 16 + found.size_log2;
    uint32_t stop_q16 = ((x_q16 >> size_log2) + 1) << size_log2;
    stop_q16 = stop_q16 < end_q16 ? stop_q16 : end_q16;
    LeafFields leaf;
    leaf.count = 0;
    if (found.reference >= format::glyph::kFirstNode) {
      read_leaf<kNarrow>(field, found.reference, leaf);
    }
    if (leaf.count == 0) {
      const int32_t first = pixel();
      do {
        x_q8 += 1 << 8;
        x_q16 += step;
      } while (x_q16 < stop_q16);
      page.writer.saturated(first, pixel() - first,
                            found.reference == format::glyph::kInside);
      continue;
    }
    page.writer.begin(pixel());
    do {
      const int32_t value_q22 =
          leaf.count == 1
              ? row.value_q22(leaf.units[0], x_q8)
              : with_sign(leaf.count == 2 ? two_at(page, row, leaf, x_q8)
                                          : three_at(page, row, leaf, x_q8),
                          leaf.sign);
      x_q8 += 1 << 8;
      x_q16 += step;
      if (page.writer.append(filter.coverage(value_q22 >> 12))) {
        page.writer.begin(pixel());
      }
    } while (x_q16 < stop_q16);
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
    draw_by_cells(page, upright, sink);
    return;
  }
  for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
    FieldPosition at;
    if (upright.place_row(brush, at)) {
      const Range all = {pixels.x0, pixels.x1};
      const PixelPlace place = {q8_of(at.x_q20), q8_of(at.y_q20)};
      const auto x_q16 =
          static_cast<uint32_t>(at.x_q16 - field.x0_u * (1 << 16));
      const uint32_t y_u =
          static_cast<uint32_t>(at.y_q16 - field.y0_u * (1 << 16)) >> 16;
      if (field.kind == GlyphField::Kind::narrow_fields) {
        draw_row<true>(page, all, place, x_q16, y_u);
      } else {
        draw_row<false>(page, all, place, x_q16, y_u);
      }
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
