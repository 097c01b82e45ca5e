// Minimum, maximum, absolute value and clamps, by their plain names.
#pragma once

#include "base/math.hpp"

namespace inkcell::motion {

using detail::abs;
using detail::clamp;
using detail::clamp_i64;
using detail::max;
using detail::min;

}  // namespace inkcell::motion
