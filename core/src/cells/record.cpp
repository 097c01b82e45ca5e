#include "inkcell/field.hpp"

#include "base/bytes.hpp"
#include "cells/cell_access.hpp"
#include "cells/field_cell.hpp"
#include "cells/record.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

using detail::Columns;
using detail::columns_q6;
using detail::combine_q22;
using detail::FieldTerms;
using detail::in_grid;
using detail::kScaleOfUnits;
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

// The fields of a cell where a px is a u. The position is rounded to 1/256 u.
FieldTerms terms_at(const GlyphField& field,
                    const Cell& cell,
                    Q16_16 x,
                    Q16_16 y) noexcept {
  const auto q8 = [](Q16_16 position_u) noexcept {
    return static_cast<uint32_t>(((position_u.raw >> 7) + 1) >> 1);
  };
  FieldTerms terms;
  detail::set_up_terms(terms, field, cell, q8(x), q8(y), kScaleOfUnits);
  return terms;
}

}  // namespace

// Not inline: what is read goes to its place at once.
__attribute__((noinline)) Status detail::read_record(
    Span<const uint8_t> record, GlyphField& field) noexcept {
  namespace glyph = format::glyph;
  namespace fields = format::fields;
  namespace linked = format::linked;
  using Kind = GlyphField::Kind;
  const uint8_t* const at = record.data;
  if (record.size == 0) {
    return Status::corrupt;
  }
  const bool of_fields = at[glyph::kType] == glyph::kTypeFields;
  if (of_fields ? INKCELL_FIELD_CELLS == 0
                : INKCELL_SAMPLE_CELLS == 0 ||
                      at[glyph::kType] != glyph::kTypeSamples) {
    return Status::unsupported;
  }
  if (record.size < linked::kBytes ||
      reinterpret_cast<uintptr_t>(at) % format::glyphs::kRecordAlignment != 0) {
    return Status::corrupt;
  }
  uint32_t log2 = at[glyph::kTileLog2];
  uint32_t bytes = glyph::kBytes;
  int32_t grid_limit = glyph::kGridLimit;
  if (of_fields) {
    field.kind = Kind::narrow_fields;
    bytes = fields::kBytes;
    grid_limit = fields::kGridLimit;
    if ((log2 & linked::kFlag) != 0) {
      field.kind = Kind::linked_fields;
      bytes = linked::kBytes;
      log2 -= linked::kFlag;
    }
  }
  field.tile_log2 = static_cast<uint8_t>(log2);
  field.x0_u = load_i16(at + glyph::kX0);
  field.y0_u = load_i16(at + glyph::kY0);
  field.tiles_x = at[glyph::kTilesX];
  field.tiles_y = at[glyph::kTilesY];
  if (record.size < bytes || log2 > glyph::kMaxTileLog2 ||
      field.x0_u < -grid_limit || field.x1_u() > grid_limit ||
      field.y0_u < -grid_limit || field.y1_u() > grid_limit) {
    return Status::corrupt;
  }
  // Of what follows the header: cells first where they are fields.
  field.cells = at + bytes;
  const uint32_t tiles = static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  const uint16_t first_count = load_u16(at + glyph::kNodeCount);
  uint32_t reference_bytes = tiles + 4u * first_count;
  if (field.kind == Kind::linked_fields) {
    field.heap_units = first_count;
    if (tiles > first_count || first_count > linked::kMaxUnits) {
      return Status::corrupt;
    }
    reference_bytes = 2u * first_count;
  } else {
    field.node_count = first_count;
    if (detail::has_fields(field)) {
      field.arc_count = load_u16(at + fields::kArcCount);
      field.line_count = load_u16(at + fields::kLineCount);
      field.pair_count = load_u16(at + fields::kPairCount);
      field.triple_count = load_u16(at + fields::kTripleCount);
      bytes += fields::kArcBytes * field.arc_count +
               fields::kLineBytes * field.line_count +
               fields::kPairUnits * field.pair_count +
               fields::kTripleUnits * field.triple_count;
    }
  }
  field.references = at + bytes;
  if (!detail::has_fields(field)) {
    reference_bytes *= 2;
    field.cell_count = load_u16(at + glyph::kCellCount);
    field.cells += reference_bytes;
    bytes += format::samples::kBytes * field.cell_count;
  }
  return record.size < bytes + reference_bytes ? Status::corrupt : Status::ok;
}

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  GlyphField field;
  INKCELL_TRY(detail::read_record(record, field));
  out = field;
  return Status::ok;
}

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  return detail::has_fields(field) ? detail::locate_fields(field, x_u, y_u)
                                   : detail::locate_cell(field, x_u, y_u);
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

int32_t detail::samples_distance_q10(const GlyphField& field,
                                     int32_t x_q16,
                                     int32_t y_q16) noexcept {
  Cell cell;
  if (in_grid(field, x_q16 >> 16, y_q16 >> 16)) {
    cell = locate_cell(field, x_q16 >> 16, y_q16 >> 16);
  }
  if (cell.samples == nullptr) {
    return cell.inside ? kSaturatedDistanceQ10 : -kSaturatedDistanceQ10;
  }
  return samples_distance(cell.samples, cell.size_log2,
                          x_q16 - cell.x0_u * (1 << 16),
                          y_q16 - cell.y0_u * (1 << 16))
      .raw;
}

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  if (!detail::has_fields(field)) {
    return Q22_10::from_raw(detail::samples_distance_q10(field, x.raw, y.raw));
  }
  Cell cell;
  if (in_grid(field, x.floor(), y.floor())) {
    cell = locate(field, x.floor(), y.floor());
  }
  if (cell.field_count == 0) {
    return Q22_10::from_raw(cell.inside ? kSaturatedDistanceQ10
                                        : -kSaturatedDistanceQ10);
  }
  const FieldTerms terms = terms_at(field, cell, x, y);
  return Q22_10::from_raw(
      combine_q22(terms, kScaleOfUnits.bend_shift, detail::kNoReach) >> 12);
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  Gradient gradient;
  if (!in_grid(field, x.floor(), y.floor())) {
    return gradient;
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.is_saturated()) {
    return gradient;
  }
  if (detail::has_fields(field)) {
    return detail::combined_gradient(terms_at(field, cell, x, y),
                                     kScaleOfUnits.bend_shift);
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
