#include "text/advances.hpp"

#include "rows/outline_fit.hpp"

namespace inkcell {
namespace detail {

int32_t Advances::advance(uint16_t glyph) const noexcept {
  return is_whole() ? style_->fitter()->advance_px(font_, *style_, glyph)
                    : font_.advance(glyph);
}

int32_t Advances::to_whole_px(int32_t units) const noexcept {
  return style_->outline_fitter().to_px(font_, style_->size(), units);
}

int32_t Advances::to_units(int32_t sum) const noexcept {
  return is_whole() ? clamp_to(style_->outline_fitter().to_units(
                                   font_, style_->size(), sum),
                               kMaxUnits)
                    : sum;
}

}  // namespace detail
}  // namespace inkcell
