// When things change: repeats, keyframes and staggering, as functions of time.
//
// Nothing here has state: a frame is asked for by its time, in any order, and
// next_due() says until when the picture stays as it is.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/kinetic/easing.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace kinetic {

/// Nothing will change any more. [ms]
inline constexpr int32_t kNever = INT32_MAX;

/// Which way each repeat runs.
enum class Playback : uint8_t { forward, reverse, ping_pong, pong_ping };

/// When something runs, and how often. Before it begins its first moment holds,
/// after the end its last.
struct Timing {
  int32_t delay_ms = 0;        // at least -2^30
  int32_t duration_ms = 1000;  // of one repeat; 1 to 2^30
  uint16_t repeats = 1;        // 0: for ever
  Playback playback = Playback::forward;
};

/// How far the repeat that runs at `now_ms` has come, 0 to 1.
Q16_16 progress_at(const Timing& timing, int32_t now_ms) noexcept;

/// The same in ms, 0 to duration_ms.
int32_t local_time(const Timing& timing, int32_t now_ms) noexcept;

/// The next time, `now_ms` or later, at which progress differs from what it is
/// just before; kNever after the end.
int32_t next_due(const Timing& timing, int32_t now_ms) noexcept;

/// A number at a time, and how it goes on to the next.
struct Keyframe {
  int32_t at_ms = 0;
  int32_t value = 0;
  Easing easing;
};

/// The value of keyframes at a time: the first before them, the last after
/// them, 0 if there are none. Their times must ascend.
int32_t value_at(Span<const Keyframe> keys, int32_t time_ms) noexcept;

/// Like next_due() of a timing: values that stay the same are not due.
int32_t next_due(Span<const Keyframe> keys, int32_t time_ms) noexcept;

/// How far `time_ms` lies between two times. 0 to 1; 1 if they do not ascend.
Q16_16 fraction(int32_t from_ms, int32_t to_ms, int32_t time_ms) noexcept;

/// Who comes first when units of a text move one after the other.
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

/// The delay of unit `index` of `count`, of which there are less than 2^31; an
/// index beyond counts as the last. [ms] In random order units may share one.
int32_t delay_of(const Stagger& stagger, size_t index, size_t count) noexcept;

/// The longest delay of any unit. [ms]
int32_t longest_delay(const Stagger& stagger, size_t count) noexcept;

}  // namespace kinetic
}  // namespace inkcell
