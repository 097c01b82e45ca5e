#include "text/advances.hpp"

#include "place/style_parts.hpp"
#include "rows/outline_fit.hpp"

namespace inkcell {
namespace detail {

int32_t Advances::advance(uint16_t glyph) const noexcept {
  return is_whole() ? fitter_->advance_px(font_, *style_, glyph)
                    : font_.advance(glyph);
}

int32_t Advances::to_whole_px(int32_t units) const noexcept {
  return fitter_->outlines->to_px(font_, style_->size(), units);
}

int32_t Advances::to_units(int32_t sum) const noexcept {
  return is_whole()
             ? clamp_to(fitter_->outlines->to_units(font_, style_->size(), sum),
                        kMaxUnits)
             : sum;
}

}  // namespace detail
}  // namespace inkcell
