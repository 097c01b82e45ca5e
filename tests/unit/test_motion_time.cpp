// Numbers, easings, springs, repeats, keyframes and delays, beside values that
// real numbers give.
#include "check.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/spring.hpp"
#include "inkcell/motion/timeline.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;

constexpr int32_t kOne = 1 << 16;

int32_t off(int32_t value, int32_t expected) {
  return value < expected ? expected - value : value - expected;
}

Q16_16 q16(int32_t raw) {
  return Q16_16::from_raw(raw);
}

int32_t eased(const Easing& easing, int32_t progress) {
  return ease(easing, q16(progress)).raw;
}

}  // namespace

TEST(sines_are_within_one) {
  const int32_t kSines[][2] = {{0, 0},         {1000, 1568},   {5000, 7557},
                               {8192, 11585},  {12000, 14958}, {16383, 16384},
                               {20000, 15409}, {32768, 0},     {40000, -10471},
                               {60000, -8293}, {49152, -16384}};
  for (const auto& [angle, expected] : kSines) {
    const Angle a = Angle::from_raw(static_cast<uint16_t>(angle));
    CHECK(off(sine(a).raw, expected) <= 1);
    const Angle b = Angle::from_raw(static_cast<uint16_t>(angle - 16384));
    CHECK(off(cosine(b).raw, expected) <= 1);
  }
  CHECK_EQ(direction_of({}).cosine.raw, 1 << 30);
  CHECK_EQ(direction_of({}).sine.raw, 0);
}

TEST(directions_are_unit_vectors) {
  for (int32_t raw = 0; raw < kOne; raw += 7) {
    const Direction d =
        direction_of(Angle::from_raw(static_cast<uint16_t>(raw)));
    const int64_t c = d.cosine.raw >> 14;
    const int64_t s = d.sine.raw >> 14;
    CHECK(off(static_cast<int32_t>((c * c + s * s) >> 16), kOne) <= 10);
  }
}

TEST(angles_of_vectors) {
  const int32_t kAngles[][3] = {{0, 0, 0},
                                {1, 0, 0},
                                {0, 1, 16384},
                                {-1, 0, 32768},
                                {0, -1, 49152},
                                {100, 1, 104},
                                {5, 3, 5637},
                                {3, 5, 10747},
                                {-7, 2, 29865},
                                {-7, -2, 35671},
                                {1, -1000000, 49152},
                                {2000000000, -1999999999, 57344},
                                {INT32_MIN, INT32_MIN, 40960}};
  for (const auto& [x, y, expected] : kAngles) {
    CHECK(off(angle_of(x, y).raw, expected) <= 3);
  }
  // And back, all around.
  for (int32_t raw = 0; raw < kOne; raw += 13) {
    const Angle a = Angle::from_raw(static_cast<uint16_t>(raw));
    const Angle b = angle_of(cosine(a).raw, sine(a).raw);
    const auto difference = static_cast<int16_t>(b.raw - a.raw);
    CHECK(off(difference, 0) <= 4);
  }
}

TEST(roots_are_rounded_down) {
  CHECK_EQ(square_root(0), 0);
  CHECK_EQ(square_root(99), 9);
  CHECK_EQ(square_root(100), 10);
  CHECK_EQ(square_root(UINT64_MAX), UINT32_MAX);
  CHECK_EQ(length_of(3, -4), 5);
  CHECK_EQ(length_of(INT32_MIN, INT32_MIN), 3037000499u);
}

TEST(powers_of_two) {
  const int32_t kPowers[][2] = {{0, 65536},     {1000, 64847},  {30000, 47718},
                                {65535, 32768}, {65536, 32768}, {100000, 22759},
                                {300000, 2745}, {1000000, 2},   {INT32_MAX, 0}};
  for (const auto& [x, expected] : kPowers) {
    CHECK(off(half_to_the(q16(x)).raw, expected) <= 1);
  }
  int32_t last = kOne;
  for (int32_t x = 0; x < 20 * kOne; x += 97) {
    const int32_t power = half_to_the(q16(x)).raw;
    CHECK(power <= last);
    last = power;
  }
}

TEST(lerp_rounds_and_clamps) {
  CHECK_EQ(lerp(10, 20, q16(0)), 10);
  CHECK_EQ(lerp(10, 20, q16(kOne)), 20);
  CHECK_EQ(lerp(10, 21, q16(kOne / 2)), 16);
  CHECK_EQ(lerp(20, 10, q16(kOne / 4)), 18);
  CHECK_EQ(lerp(INT32_MIN, INT32_MAX, q16(kOne)), INT32_MAX);
  CHECK_EQ(lerp(INT32_MIN, INT32_MAX, q16(INT32_MAX)), INT32_MAX);
  CHECK_EQ(lerp(INT32_MAX, INT32_MIN, q16(INT32_MAX)), INT32_MIN);
}

TEST(random_numbers_fill_their_range) {
  RandomNumbers numbers(7);
  int32_t counts[10] = {};
  for (int i = 0; i < 10000; ++i) {
    ++counts[numbers.below(10)];
  }
  for (const int32_t count : counts) {
    CHECK(count > 850 && count < 1150);
  }
  CHECK_EQ(numbers.below(0), 0);
  CHECK(hash(1, 2) != hash(2, 1));
  CHECK_EQ(hash(1, 2), hash(1, 2));
}

TEST(easings_are_those_of_css) {
  const struct {
    Easing easing;
    int32_t values[7];  // at eighths [Q16]
  } kCases[] = {
      {kEase, {8971, 26772, 42292, 52586, 59072, 62945, 64944}},
      {kEaseIn, {1703, 6125, 12584, 20667, 30112, 40754, 52522}},
      {kEaseOut, {13014, 24782, 35424, 44869, 52952, 59411, 63833}},
      {kEaseInOut, {2039, 8465, 19187, 32768, 46349, 57071, 63497}},
      {kOvershoot, {31995, 53496, 65948, 71264, 71663, 69445, 66779}},
      {kAnticipate, {-1243, -3909, -6127, -5728, -412, 12040, 33541}}};
  for (const auto& c : kCases) {
    for (int32_t i = 0; i < 7; ++i) {
      CHECK(off(eased(c.easing, (i + 1) * kOne / 8), c.values[i]) <= 24);
    }
  }
}

TEST(easings_begin_at_0_and_end_at_1) {
  const Easing kAll[] = {kLinear,    kEase,       kEaseIn, kEaseOut,
                         kEaseInOut, kHold,       kArrive, kLeave,
                         kOvershoot, kAnticipate, kBounce, steps(5)};
  for (const Easing& easing : kAll) {
    CHECK_EQ(eased(easing, -5), 0);
    CHECK_EQ(eased(easing, 0), 0);
    CHECK_EQ(eased(easing, kOne), kOne);
    CHECK_EQ(eased(easing, INT32_MAX), kOne);
  }
}

TEST(easings_have_no_jumps) {
  const Easing kSmooth[] = {kEase,      kEaseIn,     kEaseOut, kEaseInOut,
                            kOvershoot, kAnticipate, kBounce};
  for (const Easing& easing : kSmooth) {
    int32_t last = 0;
    for (int32_t i = 1; i <= 1024; ++i) {
      const int32_t value = eased(easing, i * 64);
      CHECK(off(value, last) <= 64 * 7);
      last = value;
    }
  }
}

TEST(any_easing_is_bounded) {
  for (Random& random : Rounds(3, 20000)) {
    Easing easing;
    easing.kind = static_cast<Easing::Kind>(random.below(6));
    easing.steps = random.any();
    easing.x1_q14 = random.any();
    easing.y1_q14 = random.any();
    easing.x2_q14 = random.any();
    easing.y2_q14 = random.any();
    CHECK(off(eased(easing, random.any()), 0) <= 4 * kOne);
  }
}

TEST(steps_jump_at_their_ends) {
  CHECK_EQ(eased(steps(4), kOne / 4 - 1), 0);
  CHECK_EQ(eased(steps(4), kOne / 4), kOne / 4);
  CHECK_EQ(eased(kHold, kOne - 1), 0);
  CHECK_EQ(eased(steps(0), kOne - 1), 0);
}

TEST(a_bounce_touches_the_ground_three_times) {
  for (const int32_t eleventh : each_of({4, 8, 10})) {
    CHECK(off(eased(kBounce, kOne * eleventh / 11), kOne) <= 32);
  }
  CHECK(off(eased(kBounce, kOne * 6 / 11), kOne * 3 / 4) <= 8);
}

TEST(springs_swing_as_real_ones) {
  const int32_t kTimes[] = {20, 50, 100, 200, 300, 400, 700};
  const int32_t kSwing[] = {3731, 18913, 50337, 77121, 68223, 63488, 65620};
  const int32_t kCreep[] = {877, 4632, 14107, 33875, 48004, 56390, 64461};
  for (int i = 0; i < 7; ++i) {
    CHECK(off(spring_at({400, 80}, kTimes[i]).raw, kSwing[i]) <= 16);
    CHECK(off(spring_at({0, 80}, kTimes[i]).raw, kCreep[i]) <= 16);
  }
  const int32_t kPeriods[] = {0, 1, 400, INT32_MAX};
  for (const int32_t period : kPeriods) {
    const int32_t kHalfs[] = {-5, 0, 1, 80, INT32_MAX};
    for (const int32_t half : kHalfs) {
      const Spring spring = {period, half};
      CHECK_EQ(spring_at(spring, -1).raw, 0);
      CHECK_EQ(spring_at(spring, 0).raw, 0);
      CHECK_EQ(spring_at(spring, rest_ms(spring)).raw, kOne);
      CHECK_EQ(spring_at(spring, INT32_MAX).raw, kOne);
      const int32_t value = spring_at(spring, rest_ms(spring) / 3).raw;
      CHECK(value >= 0 && value <= 2 * kOne);
    }
  }
}

TEST(springs_come_to_rest_without_a_jump) {
  const Spring spring = {300, 50};
  const int32_t before = spring_at(spring, rest_ms(spring) - 1).raw;
  CHECK(off(before, kOne) <= 8);
}

TEST(repeats_and_directions) {
  Timing timing;
  timing.delay_ms = 100;
  timing.duration_ms = 400;
  timing.repeats = 3;
  CHECK_EQ(local_time(timing, -50), 0);
  CHECK_EQ(local_time(timing, 100), 0);
  CHECK_EQ(local_time(timing, 200), 100);
  CHECK_EQ(local_time(timing, 500), 0);
  CHECK_EQ(local_time(timing, 1299), 399);
  CHECK_EQ(local_time(timing, 1300), 400);
  CHECK_EQ(local_time(timing, INT32_MAX), 400);
  timing.playback = Playback::reverse;
  CHECK_EQ(local_time(timing, 0), 400);
  CHECK_EQ(local_time(timing, 200), 300);
  CHECK_EQ(local_time(timing, 1300), 0);
  timing.playback = Playback::ping_pong;
  CHECK_EQ(local_time(timing, 200), 100);
  CHECK_EQ(local_time(timing, 600), 300);
  CHECK_EQ(local_time(timing, 5000), 400);
  timing.playback = Playback::pong_ping;
  CHECK_EQ(local_time(timing, 200), 300);
  CHECK_EQ(local_time(timing, 600), 100);
  CHECK_EQ(local_time(timing, 5000), 0);
  timing.repeats = 0;
  timing.playback = Playback::forward;
  CHECK_EQ(local_time(timing, 100 + 400 * 1000 + 7), 7);
  CHECK_EQ(progress_at(timing, 300).raw, kOne / 2);
}

TEST(any_timing_is_bounded) {
  for (Random& random : Rounds(5, 5000)) {
    Timing timing;
    timing.delay_ms = random.any();
    timing.duration_ms = random.any();
    timing.repeats = random.any();
    timing.playback = static_cast<Playback>(random.below(6));
    const int32_t now = random.any();
    const int32_t progress = progress_at(timing, now).raw;
    CHECK(progress >= 0 && progress <= kOne);
    CHECK(next_due(timing, now) >= now ||
          next_due(timing, now) >= timing.delay_ms);
  }
}

// Nothing may change before it is due.
TEST(timings_tell_when_they_change) {
  Timing timing;
  timing.delay_ms = 100;
  timing.duration_ms = 50;
  CHECK_EQ(next_due(timing, 0), 101);
  CHECK_EQ(next_due(timing, 120), 120);
  CHECK_EQ(next_due(timing, 150), 150);
  CHECK_EQ(next_due(timing, 151), kNever);
  timing.repeats = 0;
  CHECK_EQ(next_due(timing, INT32_MAX - 1), INT32_MAX - 1);
}

TEST(keyframes_hold_and_ease) {
  const Keyframe kKeys[] = {{100, 50, kLinear},
                            {200, 150, kHold},
                            {300, -50, kLinear},
                            {400, -50, kLinear},
                            {500, 0, kLinear}};
  CHECK_EQ(value_at(kKeys, 0), 50);
  CHECK_EQ(value_at(kKeys, 150), 100);
  CHECK_EQ(value_at(kKeys, 200), 150);
  CHECK_EQ(value_at(kKeys, 299), 150);
  CHECK_EQ(value_at(kKeys, 300), -50);
  CHECK_EQ(value_at(kKeys, 999), 0);
  CHECK_EQ(value_at({}, 5), 0);
  for (int32_t time = 0; time < 600; ++time) {
    const int32_t due = next_due(Span<const Keyframe>(kKeys), time);
    CHECK(due >= time);
    for (int32_t t = time + 1; t < due && t < 600; ++t) {
      CHECK_EQ(value_at(kKeys, t), value_at(kKeys, time));
    }
  }
  CHECK_EQ(next_due(Span<const Keyframe>(kKeys), 501), kNever);
}

TEST(keyframes_out_of_order_do_no_harm) {
  const Keyframe kKeys[] = {{500, 1, kBounce},
                            {100, 2, kEase},
                            {INT32_MIN, 3, kEase},
                            {INT32_MAX, 4, kEase}};
  const int32_t kTimes[] = {INT32_MIN, -1, 0, 100, 499, 501, INT32_MAX};
  for (const int32_t time : kTimes) {
    const int32_t value = value_at(kKeys, time);
    CHECK(value >= 0 && value <= 5);
    CHECK(next_due(Span<const Keyframe>(kKeys), time) >= time);
  }
}

TEST(delays_go_from_unit_to_unit) {
  const auto delay = [](StaggerOrder order, uint32_t index, uint32_t count) {
    return delay_of({10, order, 0}, index, count);
  };
  CHECK_EQ(delay(StaggerOrder::forward, 3, 5), 30);
  CHECK_EQ(delay(StaggerOrder::forward, 9, 5), 40);
  CHECK_EQ(delay(StaggerOrder::backward, 3, 5), 10);
  CHECK_EQ(delay(StaggerOrder::from_centre, 2, 5), 0);
  CHECK_EQ(delay(StaggerOrder::from_centre, 0, 5), 20);
  CHECK_EQ(delay(StaggerOrder::from_centre, 1, 4), 0);
  CHECK_EQ(delay(StaggerOrder::from_centre, 3, 4), 10);
  CHECK_EQ(delay(StaggerOrder::from_ends, 0, 5), 0);
  CHECK_EQ(delay(StaggerOrder::from_ends, 2, 5), 20);
  CHECK_EQ(delay(StaggerOrder::forward, 3, 0), 0);
  for (uint32_t order = 0; order < 5; ++order) {
    const Stagger stagger = {10, static_cast<StaggerOrder>(order), 42};
    for (uint32_t count = 1; count < 20; ++count) {
      for (uint32_t i = 0; i < count; ++i) {
        const int32_t value = delay_of(stagger, i, count);
        CHECK(value >= 0 && value <= longest_delay(stagger, count));
      }
    }
  }
  CHECK_EQ(
      delay_of({INT32_MAX, StaggerOrder::forward, 0}, UINT32_MAX, UINT32_MAX),
      1 << 30);
}
