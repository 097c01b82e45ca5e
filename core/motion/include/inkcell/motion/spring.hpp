// A damped spring in closed form: no state, any order of times.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"

namespace inkcell::motion {

/// A spring that is released at 0 and settles at 1:
///
///     1 - 2^(-t / h) (cos(2 pi t / p) + ln(2) p / (2 pi h) sin(2 pi t / p))
///
/// with the period p and the half-life h. Its initial speed is 0.
struct Spring {
  /// [ms] 0: critical damping, without swing: 1 - 2^(-t / h) (1 + ln(2) t / h).
  int32_t period_ms = 400;
  int32_t half_life_ms = 80;  // at least 1
};

/// The time at which the spring rests: 16 half-lives. [ms]
constexpr int32_t rest_ms(const Spring& spring) noexcept {
  constexpr int32_t kMost = INT32_MAX / 16;
  const int32_t half = spring.half_life_ms < 1       ? 1
                       : spring.half_life_ms > kMost ? kMost
                                                     : spring.half_life_ms;
  return 16 * half;
}

/// The position at a time, between 0 and 2. 0 before 0 ms, exactly 1 from
/// rest_ms() on.
Q16_16 spring_at(const Spring& spring, int32_t time_ms) noexcept;

}  // namespace inkcell::motion
