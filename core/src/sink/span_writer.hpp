// Rows of coverage on their way to a sink.
#pragma once

#include <stdint.h>

#include "base/config.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// Pixels of a row: begin <= x < end.
struct Range {
  int32_t begin;
  int32_t end;
};

// Collects coverage from left to right along one row and hands it on in spans:
// transparent pixels around them are dropped, solid ones of saturated cells
// join to runs. Between two rows it must be flushed.
class SpanWriter {
 public:
  SpanWriter(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  // Call before append(), with the first of the pixels to come: after a flush,
  // or when it follows the last pixel.
  void begin(int32_t x) noexcept {
    if (solid_count_ != 0) {
      flush_all();
    }
    if (count_ == 0) {
      x_ = x;
    }
  }

  // A pixel. True if a span is full: begin anew with the next one.
  bool append(uint8_t coverage) noexcept {
    buffer_[count_++] = coverage;
    if (count_ != kBuffer) {
      return false;
    }
    flush_all();
    return true;
  }

  // The same, given where the next one is.
  void append(uint8_t coverage, int32_t next_x) noexcept {
    if (append(coverage)) {
      x_ = next_x;
    }
  }

  void put(int32_t x, uint8_t coverage) noexcept {
    if (coverage == 0 && count_ == 0) {
      flush();
    } else {
      begin(x);
      append(coverage);
    }
  }

  void solid(int32_t x, int32_t count) noexcept {
    if (count_ != 0) {
      flush_all();
    }
    if (solid_count_ == 0) {
      x_ = x;
    }
    solid_count_ += count;
  }

  // `count` pixels that are all solid or all transparent.
  void saturated(int32_t x, int32_t count, bool inside) noexcept {
    // Few of them stay in the span around them.
    constexpr int32_t kMinSolid = 4;
    if (!inside && count_ == 0) {
      flush();
    } else if (count < kMinSolid) {
      for (const int32_t end = x + count; x < end; ++x) {
        begin(x);
        append(inside ? 255 : 0);
      }
    } else if (inside) {
      solid(x, count);
    } else {
      flush();
    }
  }

  void flush() noexcept {
    if ((count_ | solid_count_) != 0) {
      flush_all();
    }
  }

  // To the row below.
  void next_row() noexcept {
    flush();
    ++y_;
  }

 private:
  __attribute__((noinline)) void flush_all() noexcept {
    if (solid_count_ != 0) {
      sink_.solid(sink_.context, x_, y_, solid_count_);
      solid_count_ = 0;
      return;
    }
    const uint8_t* begin = buffer_;
    const uint8_t* end = buffer_ + count_;
    while (end > begin && end[-1] == 0) {
      --end;
    }
    while (begin < end && *begin == 0) {
      ++begin;
    }
    count_ = 0;
    if (begin < end) {
      sink_.coverage(sink_.context, x_ + static_cast<int32_t>(begin - buffer_),
                     y_, begin, static_cast<int32_t>(end - begin));
    }
  }

  // Pixel order is for boards with little RAM.
  static constexpr int32_t kBuffer = kObjectOrder ? kMaxSpan : 8;

  const Sink& sink_;
  int32_t y_;
  int32_t x_ = 0;
  // At most one of the two is not 0.
  int32_t count_ = 0;
  int32_t solid_count_ = 0;
  uint8_t buffer_[kBuffer];
};

}  // namespace detail
}  // namespace inkcell
