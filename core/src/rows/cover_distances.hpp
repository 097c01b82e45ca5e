// Rows of painted distances to coverage, in place.
#pragma once

#include "inkcell/filter.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {

// What paint_distances left; coverage of Filter::is_linear_pixel().
void cover_linear(const Band& band, const Filter& filter) noexcept;

// What paint_distances or paint_wide_distances left; coverage of `filter`,
// whose ramp lies within the band's reach.
void cover_filtered(const Band& band, const Filter& filter) noexcept;

}  // namespace detail
}  // namespace inkcell
