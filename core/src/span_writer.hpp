// Rows of coverage on their way to a sink.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace detail {

// Pixels of a row: begin <= x < end.
struct Range {
  int32_t begin;
  int32_t end;
};

// Collects coverage from left to right along one row and hands it on in spans:
// transparent pixels are dropped, solid ones of saturated cells join to runs.
class SpanWriter {
 public:
  SpanWriter(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  void put(int32_t x, uint8_t coverage) noexcept {
    if (count_ == 0) {
      flush_solid();
      if (coverage == 0) {
        return;
      }
      x_ = x;
    }
    buffer_[count_++] = coverage;
    if (count_ == kMaxSpan) {
      flush_span();
    }
  }

  void solid(int32_t x, int32_t count) noexcept {
    flush_span();
    if (solid_count_ == 0) {
      x_ = x;
    }
    solid_count_ += count;
  }

  void flush() noexcept {
    flush_span();
    flush_solid();
  }

 private:
  void flush_span() noexcept {
    while (count_ > 0 && buffer_[count_ - 1] == 0) {
      --count_;
    }
    if (count_ > 0) {
      sink_.coverage(sink_.context, x_, y_, buffer_, count_);
      count_ = 0;
    }
  }

  void flush_solid() noexcept {
    if (solid_count_ > 0) {
      sink_.solid(sink_.context, x_, y_, solid_count_);
      solid_count_ = 0;
    }
  }

  const Sink& sink_;
  int32_t y_;
  int32_t x_ = 0;
  int32_t count_ = 0;
  int32_t solid_count_ = 0;
  uint8_t buffer_[kMaxSpan];
};

}  // namespace detail
}  // namespace inkcell
