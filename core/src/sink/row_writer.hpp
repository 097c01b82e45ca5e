// Coverage of a row on its way to a sink, pixel by pixel.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"
#include "inkcell/strip.hpp"
#include "sink/emit.hpp"

namespace inkcell {
namespace detail {

class RowWriter {
 public:
  RowWriter(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  // The pixel after the last one, or the first one after a flush.
  void put(int32_t x, uint8_t coverage) noexcept {
    if (count_ == 0) {
      x_ = x;
    }
    INKCELL_ASSERT(x == x_ + count_ && count_ < kMaxSpan);
    // Words as emit_row() takes them.
    reinterpret_cast<uint8_t*>(words_)[(x_ & 3) + count_++] = coverage;
    if (count_ == kMaxSpan) {
      flush();
    }
  }
  void next_row() noexcept {
    flush();
    ++y_;
  }

 private:
  __attribute__((noinline)) void flush() noexcept {
    if (count_ != 0) {
      emit_row(sink_, x_, y_,
               reinterpret_cast<const uint8_t*>(words_) + (x_ & 3), count_);
      count_ = 0;
    }
  }

  const Sink& sink_;
  int32_t y_;
  int32_t x_ = 0;
  int32_t count_ = 0;
  uint32_t words_[kMaxSpan / 4 + 1];
};

}  // namespace detail
}  // namespace inkcell
