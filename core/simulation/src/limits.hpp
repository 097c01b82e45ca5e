// Functions of base and motion that sources of this room call without a
// namespace: minimum, maximum, absolute value, clamps, lengths, and all of
// motion.
#pragma once

#include <stdint.h>

#include "base/math.hpp"

namespace inkcell::motion {}

namespace inkcell::simulation {

using namespace motion;
using detail::abs;
using detail::clamp;
using detail::clamp_i64;
using detail::max;
using detail::min;
using detail::near_length;

constexpr int32_t kOneQ13 = 1 << 13;
constexpr int32_t kOneQ14 = 1 << 14;

}  // namespace inkcell::simulation
