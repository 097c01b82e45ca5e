#include "text/advances.hpp"

#include "base/math.hpp"
#include "base/modular.hpp"

namespace inkcell {
namespace detail {

int32_t Advances::advance(uint16_t glyph) const noexcept {
  return is_whole() ? style_->fitter()->advance_px(font_, glyph,
                                                   style_->fitter_options())
                    : font_.advance(glyph);
}

// Sizes that are fitted are below 2^12 [px, Q6], so that products have 31 bits;
// others wrap.
int32_t Advances::to_whole_px(int32_t units) const noexcept {
  return quotient(product(units, style_->size().raw),
                  font_.units_per_em() * 64);
}

int32_t Advances::to_units(int32_t sum) const noexcept {
  if (!is_whole()) {
    return sum;
  }
  const int32_t size_q6 = style_->size().raw;
  const int32_t em_q6 = font_.units_per_em() * 64;
  // Whole units of a pixel, and what is left.
  const int32_t whole = quotient(em_q6, size_q6);
  const int32_t part = product(sum, em_q6 - whole * size_q6);
  const int32_t half = part < 0 ? -(size_q6 >> 1) : size_q6 >> 1;
  return clamp_to(sum * whole + quotient(part + half, size_q6), kMaxUnits);
}

}  // namespace detail
}  // namespace inkcell
