// Collects adjacent pixels of a row for a sink.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"
#include "limits.hpp"

namespace inkcell::simulation {

// Collects coverage of adjacent pixels of the window and emits it as runs.
class PixelRun {
 public:
  PixelRun(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  // `x` must be in the window.
  void add(int32_t x, uint32_t coverage) noexcept {
    if (coverage == 0) {
      return;
    }
    if (count_ == kMost || x != first_ + count_) {
      flush();
      first_ = x;
    }
    coverage_[count_++] = static_cast<uint8_t>(coverage);
  }
  // Full coverage for the part of [x, end) that is in the window.
  void fill(int32_t x, int32_t end) noexcept {
    flush();
    x = max(x, sink_.window.x0);
    end = min(end, sink_.window.x1);
    if (x < end) {
      sink_.solid(sink_.context, x, y_, end - x);
    }
  }
  void flush() noexcept {
    if (count_ != 0) {
      sink_.coverage(sink_.context, first_, y_, coverage_, count_);
      count_ = 0;
    }
  }

 private:
  static constexpr int32_t kMost = 32;

  const Sink& sink_;
  int32_t y_;
  int32_t first_ = 0;
  int32_t count_ = 0;
  uint8_t coverage_[kMost];
};

}  // namespace inkcell::simulation
