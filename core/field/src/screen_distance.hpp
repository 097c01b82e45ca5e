// Distances of fields in px of the screen.
#pragma once

#include <stdint.h>

#include "field_sampler.hpp"
#include "inkcell/style.hpp"

namespace inkcell {
namespace detail {

// How much less than Style::size() a stretched style enlarges the distance
// to an edge of this gradient: |g| over the length of g on the screen. An edge
// at f in the glyph is there at f times that, to first order: exactly where f
// is a plane. [Q15, at most 1]
int32_t gain_q15(const Style& style, const Gradient& gradient) noexcept;

// The distance at a place on the screen, within +-32 px. [px, Q10]
int32_t screen_distance_q10(const Style& style,
                            FieldSampler& sampler,
                            const FieldPlace& at) noexcept;

}  // namespace detail
}  // namespace inkcell
