// What only the library reads of a style.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"
#include "inkcell/style.hpp"

namespace inkcell::detail {

struct StyleParts {
  // What the filter takes of a band. Null, also if all bytes of the style are
  // 0: nothing is drawn.
  static const BandKind* band_kind(const Style& style) noexcept {
    return style.filter_ == nullptr ? nullptr : style.filter_->band_kind;
  }
  // Whether the canvas decides about fitting.
  static bool is_fit_open(const Style& style) noexcept {
    return style.is_fit_open_;
  }
  // Of a fitted style, and of one that is not upright.
  static const OutlineFitter& outline_fitter(const Style& style) noexcept {
    INKCELL_ASSERT(style.is_fitted());
    return *style.fitter_->outlines;
  }
  static const Slant& slant(const Style& style) noexcept {
    INKCELL_ASSERT(!style.is_upright());
    return *style.slant_;
  }
  // The least stretch over the greatest.
  static int32_t least_gain_q15(const Style& style) noexcept {
    return style.least_gain_q15_;
  }
};

}  // namespace inkcell::detail
