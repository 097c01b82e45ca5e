// The packed coding's steps, and the numbers of fields for generators.
#include "packed_field.hpp"

#include "inkcell/format.hpp"
#include "inkcell/packed.hpp"

namespace inkcell {

PackedCoding PackedCoding::read(const uint8_t* quantisation) noexcept {
  namespace at = format::quantisation;
  PackedCoding coding;
  coding.d0_step = quantisation[at::kD0Step];
  coding.bend_step = quantisation[at::kBendStep];
  coding.d0_base = quantisation[at::kD0Base];
  coding.d0_log2 = quantisation[at::kD0Log2];
  coding.angle_base = quantisation[at::kAngleBase];
  coding.bend_k = static_cast<uint16_t>(quantisation[at::kBendBits] |
                                        quantisation[at::kBendBits + 1] << 8);
  return coding;
}

FieldNumbers expand_field(const FieldCode& code,
                          const PackedCoding& coding,
                          uint32_t log2,
                          int32_t x_u,
                          int32_t y_u) noexcept {
  const uint32_t turn =
      code.angle << (has_angle(code.kind) ? 16 - coding.angle_bits(log2) : 14);
  const detail::Normal n = detail::normal_of(turn);
  const detail::Anchor anchor = {x_u, y_u};
  FieldNumbers field;
  field.nx_q14 = static_cast<int16_t>(n.x);
  field.ny_q14 = static_cast<int16_t>(n.y);
  field.c_q4 = detail::offset_q4(code.d0, coding, n, anchor);
  if (is_bent(code.kind)) {
    // No stream states more.
    constexpr int32_t kMost = 1 << 19;
    const int32_t most = code.bend > kMost ? kMost : code.bend;
    field.bend = detail::curvature(most < -kMost ? -kMost : most, coding, log2);
  }
  if (field.bend != 0) {
    field.along_q4 = detail::along_q4(n, anchor);
  }
  return field;
}

}  // namespace inkcell
