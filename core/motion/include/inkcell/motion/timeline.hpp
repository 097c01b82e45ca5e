// Repeats, keyframes and staggering as functions of time.
//
// There is no state: frames are computed from a time, in any order, and
// next_due() returns until when the picture does not change.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/span.hpp"

namespace inkcell::motion {

/// No further changes. [ms]
inline constexpr int32_t kNever = INT32_MAX;

/// The direction of each repeat.
enum class Playback : uint8_t { forward, reverse, ping_pong, pong_ping };

/// Start, duration and repeats. Before the start the first moment holds, after
/// the end the last.
struct Timing {
  int32_t delay_ms = 0;        // at least -2^30
  int32_t duration_ms = 1000;  // of one repeat; 1 to 2^30
  uint16_t repeats = 1;        // 0: for ever
  Playback playback = Playback::forward;
};

/// The progress of the repeat that runs at `now_ms`, 0 to 1.
Q16_16 progress_at(const Timing& timing, int32_t now_ms) noexcept;

/// The same in ms, 0 to duration_ms.
int32_t local_time(const Timing& timing, int32_t now_ms) noexcept;

/// The next time >= `now_ms` at which progress changes; kNever after the end.
int32_t next_due(const Timing& timing, int32_t now_ms) noexcept;

/// A number at a time, and the easing to the next.
struct Keyframe {
  int32_t at_ms = 0;
  int32_t value = 0;
  Easing easing;
};

/// The value at a time; outside of the keys that of the nearest, without keys
/// 0. Times must ascend.
int32_t value_at(Span<const Keyframe> keys, int32_t time_ms) noexcept;

/// The same for keyframes. Equal values are no change.
int32_t next_due(Span<const Keyframe> keys, int32_t time_ms) noexcept;

/// (time - from) / (to - from), clamped to 0..1; 1 if to <= from.
Q16_16 fraction(int32_t from_ms, int32_t to_ms, int32_t time_ms) noexcept;

/// The order in which units of a text start.
enum class StaggerOrder : uint8_t {
  forward,
  backward,
  from_centre,
  from_ends,
  random,
};

/// Delays from unit to unit.
struct Stagger {
  int32_t step_ms = 40;
  StaggerOrder order = StaggerOrder::forward;
  uint32_t seed = 0;  // of the random order
};

/// The delay of unit `index` of `count`, count < 2^31; a larger index counts as
/// the last. [ms] In random order units may have the same delay.
int32_t delay_of(const Stagger& stagger, size_t index, size_t count) noexcept;

/// The longest delay of any unit. [ms]
int32_t longest_delay(const Stagger& stagger, size_t count) noexcept;

}  // namespace inkcell::motion
