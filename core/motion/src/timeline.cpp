// Repeats, keyframes and delays.
#include "inkcell/motion/timeline.hpp"

#include "inkcell/motion/numbers.hpp"
#include "keys.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kLongest = 1 << 30;

// A timing, clamped, and its end. [ms since its start]
struct Period {
  int32_t begin;
  int32_t duration;
  int64_t length;  // of all repeats; 2^62: endless

  explicit Period(const Timing& timing) noexcept
      : begin(clamp(timing.delay_ms, -kLongest, kLongest)),
        duration(clamp(timing.duration_ms, 1, kLongest)),
        length(timing.repeats == 0 ? int64_t{1} << 62
                                   : int64_t{duration} * timing.repeats) {}
};

}  // namespace

Q16_16 fraction(int32_t from_ms, int32_t to_ms, int32_t time_ms) noexcept {
  int64_t whole = int64_t{to_ms} - from_ms;
  int64_t part = int64_t{time_ms} - from_ms;
  if (part >= whole) {
    return Q16_16::from_int(1);
  }
  if (part <= 0) {
    return {};
  }
  auto divisor = static_cast<uint32_t>(whole);
  auto dividend = static_cast<uint32_t>(part);
  // Reduced to 16 bits each: a 32-bit division is enough.
  while (divisor > 0xffff) {
    divisor >>= 1;
    dividend >>= 1;
  }
  return Q16_16::from_raw(static_cast<int32_t>((dividend << 16) / divisor));
}

int32_t local_time(const Timing& timing, int32_t now_ms) noexcept {
  const Period period(timing);
  int64_t passed = int64_t{now_ms} - period.begin;
  passed = passed < 0 ? 0 : passed;
  int64_t repeat = 0;
  int64_t time = passed;
  if (passed >= period.length) {
    repeat = timing.repeats - 1;
    time = period.duration;
  } else if (passed >= period.duration) {
    repeat = passed / period.duration;
    time = passed - repeat * period.duration;
  }
  const bool is_odd = (repeat & 1) != 0;
  const bool is_backward = timing.playback == Playback::reverse ||
                           (timing.playback == Playback::ping_pong && is_odd) ||
                           (timing.playback == Playback::pong_ping && !is_odd);
  return static_cast<int32_t>(is_backward ? period.duration - time : time);
}

Q16_16 progress_at(const Timing& timing, int32_t now_ms) noexcept {
  return fraction(0, clamp(timing.duration_ms, 1, kLongest),
                  local_time(timing, now_ms));
}

int32_t next_due(const Timing& timing, int32_t now_ms) noexcept {
  const Period period(timing);
  if (now_ms <= period.begin) {
    // The first moment holds until then.
    return period.begin + 1;
  }
  return int64_t{now_ms} - period.begin <= period.length ? now_ms : kNever;
}

int32_t value_at(Span<const Keyframe> keys, int32_t time_ms) noexcept {
  if (keys.size == 0) {
    return 0;
  }
  const Segment<Keyframe> at = segment_at(keys, time_ms);
  return lerp(at.from.value, at.to.value, at.progress);
}

int32_t next_due(Span<const Keyframe> keys, int32_t time_ms) noexcept {
  return next_change(keys, &Keyframe::value, time_ms);
}

int32_t delay_of(const Stagger& stagger, size_t unit, size_t units) noexcept {
  if (units == 0) {
    return 0;
  }
  const auto count =
      static_cast<uint32_t>(units > INT32_MAX ? INT32_MAX : units);
  const uint32_t last = count - 1;
  const uint32_t index = unit > last ? last : static_cast<uint32_t>(unit);
  // Twice the distance from the middle of the units.
  const uint32_t off_centre =
      2 * index > last ? 2 * index - last : last - 2 * index;
  uint32_t place = index;
  switch (stagger.order) {
    case StaggerOrder::backward:
      place = last - index;
      break;
    case StaggerOrder::from_centre:
      place = off_centre / 2;
      break;
    case StaggerOrder::from_ends:
      place = (last - off_centre) / 2;
      break;
    case StaggerOrder::random:
      place = static_cast<uint32_t>(
          uint64_t{hash(stagger.seed, index)} * count >> 32);
      break;
    default:
      break;
  }
  const int64_t delay = int64_t{stagger.step_ms} * place;
  return clamp_i64(delay, -kLongest, kLongest);
}

int32_t longest_delay(const Stagger& stagger, size_t count) noexcept {
  Stagger in_order = stagger;
  in_order.order = stagger.order == StaggerOrder::from_centre ||
                           stagger.order == StaggerOrder::from_ends
                       ? StaggerOrder::from_centre
                       : StaggerOrder::forward;
  return count == 0 ? 0 : delay_of(in_order, count - 1, count);
}

}  // namespace inkcell::motion
