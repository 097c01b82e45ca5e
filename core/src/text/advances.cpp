#include "text/advances.hpp"

namespace inkcell::detail {

int32_t Advances::advance(uint16_t glyph) const noexcept {
  return is_whole() ? fitter_->advance_px(font_, *style_, glyph)
                    : font_.advance(glyph);
}

int32_t Advances::join(const GlyphPair& pair,
                       int32_t& drift_q6) const noexcept {
  return fitter_->outlines->join(font_, *style_, *fitter_, pair, drift_q6);
}

int32_t Advances::to_units(int32_t sum) const noexcept {
  return is_whole()
             ? clamp_to(fitter_->outlines->to_units(font_, style_->size(), sum),
                        kMaxUnits)
             : sum;
}

}  // namespace inkcell::detail
