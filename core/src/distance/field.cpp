#include "inkcell/field.hpp"

#include "cells/cell_access.hpp"
#include "cells/field_cell.hpp"
#include "cells/record.hpp"
#include "inkcell/format/cell.hpp"

namespace inkcell {
namespace {

using detail::combine_q22;
using detail::FieldTerms;
using detail::in_grid;
using detail::kScaleOfUnits;

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

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  GlyphField field;
  INKCELL_TRY(detail::read_record(record, field));
  out = field;
  return Status::ok;
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
  if (!in_grid(field, x.floor(), y.floor())) {
    return {};
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.is_saturated()) {
    return {};
  }
  if (detail::has_fields(field)) {
    return detail::combined_gradient(terms_at(field, cell, x, y),
                                     kScaleOfUnits.bend_shift);
  }
  return detail::samples_gradient(cell, x, y);
}

}  // namespace inkcell
