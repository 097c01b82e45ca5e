#include "inkcell/format/cell.hpp"

#include "cells/leaf_reader.hpp"
#include "distance/samples.hpp"

namespace inkcell {

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  const uint32_t x = static_cast<uint32_t>(x_u - field.x0_u);
  const uint32_t y = static_cast<uint32_t>(y_u - field.y0_u);
  detail::Leaf leaf;
  detail::find_leaf(field, x, y, leaf);
  Cell cell;
  const uint32_t log2 = leaf.size_log2;
  cell.size_log2 = leaf.size_log2;
  cell.x0_u = field.x0_u + static_cast<int32_t>((x >> log2) << log2);
  cell.y0_u = field.y0_u + static_cast<int32_t>((y >> log2) << log2);
  if (leaf.has_samples()) {
    cell.samples = leaf.parts[0];
    return cell;
  }
  cell.inside = leaf.count == 0 && leaf.is_inside;
  cell.field_count = leaf.count;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    const auto unit = (detail::record_of(leaf.parts[i]) - field.cells) >> 1;
    cell.fields[i] = static_cast<uint16_t>(
        static_cast<uint32_t>(unit) |
        (detail::arc_bit(leaf.parts[i]) != 0 ? format::linked::kArcField : 0));
  }
  if (leaf.count > 1) {
    cell.op = leaf.field_operator();
  }
  return cell;
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

}  // namespace inkcell
