// Lists of keys, in the order of their times.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/motion/timeline.hpp"
#include "inkcell/span.hpp"

namespace inkcell::motion {

// The keys around a time; before the first one, and from the last one on, both
// are that.
template <typename Key>
struct Segment {
  const Key& from;
  const Key& to;
  Q16_16 progress;  // eased
};

// There is a key at least.
template <typename Key>
Segment<Key> segment_at(Span<const Key> keys, int32_t time_ms) noexcept {
  size_t i = 0;
  while (i + 1 < keys.size && time_ms >= keys[i + 1].at_ms) {
    ++i;
  }
  const Key& from = keys[i];
  const Key& to = keys[i + 1 < keys.size ? i + 1 : i];
  return {from, to, ease(from.easing, fraction(from.at_ms, to.at_ms, time_ms))};
}

// When a value next differs from what it was: `time_ms` while it changes.
template <typename Key, typename Value>
int32_t next_change(Span<const Key> keys,
                    Value Key::*value,
                    int32_t time_ms) noexcept {
  for (size_t i = 0; i + 1 < keys.size; ++i) {
    const Key& from = keys[i];
    const Key& to = keys[i + 1];
    if (time_ms <= to.at_ms && !(from.*value == to.*value)) {
      return time_ms > from.at_ms ? time_ms : from.at_ms + 1;
    }
  }
  return kNever;
}

}  // namespace inkcell::motion
