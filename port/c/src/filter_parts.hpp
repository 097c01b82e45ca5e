// The two parts of a filter of C.
#pragma once

#include "inkcell/c/filter.h"
#include "inkcell/style.hpp"

namespace inkcell {
namespace c {

inline const Filter& table_of(const inkcell_filter_t* filter) noexcept {
  return *static_cast<const Filter*>(filter->words[0]);
}
inline const detail::BandPainter& painter_of(
    const inkcell_filter_t* filter) noexcept {
  return *static_cast<const detail::BandPainter*>(filter->words[1]);
}

}  // namespace c
}  // namespace inkcell
