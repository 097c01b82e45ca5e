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
  return detail::field_numbers(code, coding, log2, x_u, y_u);
}

}  // namespace inkcell
