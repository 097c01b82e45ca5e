// Numbers that look random and are the same everywhere.
#pragma once

#include <stddef.h>
#include <stdint.h>

/// 32 bits that become a number of any type.
struct AnyNumber {
  uint32_t bits;

  template <typename Number>
  operator Number() const {  // NOLINT(google-explicit-constructor)
    return static_cast<Number>(bits);
  }
};

/// Marsaglia's xorshift: 32 bits of state, never 0.
class Random {
 public:
  explicit Random(uint32_t seed) : state_(seed) {}

  uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  /// 0 <= result < count.
  uint32_t below(uint32_t count) {
    return static_cast<uint32_t>(uint64_t{next()} * count >> 32);
  }
  /// low <= result <= high.
  int32_t between(int32_t low, int32_t high) {
    const auto count =
        static_cast<uint32_t>(int64_t{high} - low + 1);  // 0: all of 2^32
    const uint32_t step = count == 0 ? next() : below(count);
    return static_cast<int32_t>(low + int64_t{step});
  }
  /// `speed.raw = random.any();`
  AnyNumber any() { return {next()}; }
  int8_t byte() { return static_cast<int8_t>(next() >> 24); }

  template <typename Byte, size_t kCount>
  void fill(Byte (&bytes)[kCount]) {
    for (Byte& each : bytes) {
      each = static_cast<Byte>(byte());
    }
  }

 private:
  uint32_t state_;
};
