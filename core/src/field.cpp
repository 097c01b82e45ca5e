#include "inkcell/field.hpp"

#include "bytes.hpp"
#include "cell_access.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace {

using detail::Columns;
using detail::columns_q6;
using detail::lagrange_q14;
using detail::load_i16;
using detail::load_u16;
using detail::Weights;

constexpr int32_t kOneQ14 = 1 << 14;

// Derivatives of the Lagrange weights: 4t - 3, 4 - 8t, 4t - 1.
Weights lagrange_slope_q14(int32_t t_q14) noexcept {
  return {4 * t_q14 - 3 * kOneQ14, 4 * kOneQ14 - 8 * t_q14,
          4 * t_q14 - kOneQ14};
}

int16_t clamp_i16(int32_t value) noexcept {
  if (value < INT16_MIN) {
    return INT16_MIN;
  }
  return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX : value);
}

// Sum of the nine offsets with weights in x and y. [quanta, Q6]
int32_t weigh_q6(const uint8_t* samples,
                 const Weights& x,
                 const Weights& y) noexcept {
  const Columns c = columns_q6(samples, y);
  return (x.w1 * (c.v1 >> 2) + x.w2 * (c.v2 >> 2) + x.w3 * (c.v3 >> 2)) >> 12;
}

bool in_grid(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  return x_u >= field.x0_u && x_u < field.x1_u() && y_u >= field.y0_u &&
         y_u < field.y1_u();
}

}  // namespace

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  namespace glyph = format::glyph;
  if (record.size < glyph::kBytes) {
    return Status::corrupt;
  }
  const uint8_t* at = record.data;
  if (at[glyph::kType] != glyph::kTypeSamples) {
    return Status::unsupported;
  }
  GlyphField field;
  field.tile_log2 = at[glyph::kTileLog2];
  field.x0_u = load_i16(at + glyph::kX0);
  field.y0_u = load_i16(at + glyph::kY0);
  field.tiles_x = at[glyph::kTilesX];
  field.tiles_y = at[glyph::kTilesY];
  field.node_count = load_u16(at + glyph::kNodeCount);
  field.cell_count = load_u16(at + glyph::kCellCount);
  if (field.tile_log2 > glyph::kMaxTileLog2) {
    return Status::corrupt;
  }
  if (field.x0_u < -glyph::kGridLimit || field.x1_u() > glyph::kGridLimit ||
      field.y0_u < -glyph::kGridLimit || field.y1_u() > glyph::kGridLimit) {
    return Status::corrupt;
  }
  const uint32_t tiles = static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  const uint32_t reference_bytes = 2 * (tiles + 4u * field.node_count);
  if (record.size < glyph::kBytes + reference_bytes +
                        format::samples::kBytes * field.cell_count) {
    return Status::corrupt;
  }
  field.references = at + glyph::kBytes;
  field.cells = field.references + reference_bytes;
  out = field;
  return Status::ok;
}

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  return detail::locate_cell(field, x_u, y_u);
}

void SamplesRow::set_up(const uint8_t* samples,
                        uint8_t cell_size_log2,
                        int32_t y_q16) noexcept {
  detail::set_up_row(*this, samples, cell_size_log2, y_q16);
}

Q22_10 samples_distance(const uint8_t* samples,
                        uint8_t size_log2,
                        int32_t x_q16,
                        int32_t y_q16) noexcept {
  SamplesRow row;
  row.set_up(samples, size_log2, y_q16);
  return Q22_10::from_raw(row.distance_q10(x_q16));
}

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  if (!in_grid(field, x.floor(), y.floor())) {
    return Q22_10::from_raw(-kSaturatedDistanceQ10);
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.samples == nullptr) {
    return Q22_10::from_raw(cell.inside ? kSaturatedDistanceQ10
                                        : -kSaturatedDistanceQ10);
  }
  return samples_distance(cell.samples, cell.size_log2,
                          x.raw - cell.x0_u * (1 << 16),
                          y.raw - cell.y0_u * (1 << 16));
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  Gradient gradient;
  if (!in_grid(field, x.floor(), y.floor())) {
    return gradient;
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.samples == nullptr) {
    return gradient;
  }
  const int shift = cell.size_log2 + 2;
  const int32_t tx = (x.raw - cell.x0_u * (1 << 16)) >> shift;
  const int32_t ty = (y.raw - cell.y0_u * (1 << 16)) >> shift;
  // A quantum is 1/128 of the cell, and so is the slope's unit: Q6 quanta per
  // cell size are Q13 of pure slope.
  gradient.x.raw = clamp_i16(
      2 * weigh_q6(cell.samples, lagrange_slope_q14(tx), lagrange_q14(ty)));
  gradient.y.raw = clamp_i16(
      2 * weigh_q6(cell.samples, lagrange_q14(tx), lagrange_slope_q14(ty)));
  return gradient;
}

}  // namespace inkcell
