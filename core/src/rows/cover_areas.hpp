// Rows of painted areas to coverage, in place.
#pragma once

#include "inkcell/filter.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {

// What paint_areas left. The filter is not looked at.
void cover_areas(const Band& band, const Filter& filter) noexcept;

}  // namespace detail
}  // namespace inkcell
