#include "inkcell/field/cell.hpp"

#include "cell_values.hpp"
#include "tree.hpp"

namespace inkcell {

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  const auto x = static_cast<uint32_t>(x_u - field.x0_u);
  const auto y = static_cast<uint32_t>(y_u - field.y0_u);
  const detail::FieldLeaf leaf = detail::FieldTree{field}.find(x, y);
  const uint32_t log2 = leaf.size_log2;
  Cell cell;
  cell.samples = leaf.samples;
  cell.x0_u = field.x0_u + static_cast<int32_t>((x >> log2) << log2);
  cell.y0_u = field.y0_u + static_cast<int32_t>((y >> log2) << log2);
  cell.size_log2 = leaf.size_log2;
  cell.inside = leaf.is_inside;
  return cell;
}

void SamplesRow::set_up(const uint8_t* samples,
                        uint8_t cell_size_log2,
                        int32_t y_q16) noexcept {
  *this =
      detail::cell_row(samples, cell_size_log2, static_cast<uint32_t>(y_q16));
}

Q22_10 samples_distance(const uint8_t* samples,
                        uint8_t size_log2,
                        int32_t x_q16,
                        int32_t y_q16) noexcept {
  return Q22_10::from_raw(
      detail::cell_row(samples, size_log2, static_cast<uint32_t>(y_q16))
          .distance_q10(x_q16));
}

}  // namespace inkcell
