// A mock sink of any size that keeps no pixels: how much ink there is, and
// where.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"
#include "pixels.hpp"
#include "sink_calls.hpp"

struct Ink : SinkCalls<Ink> {
  int64_t sum = 0;    // of all coverages
  inkcell::Rect box;  // around pixels that are not empty

  /// Valid as long as this stays where it is.
  inkcell::Sink sink(const inkcell::Rect& window = {-32767, -32767, 32767,
                                                    32767}) {
    return {window, this, coverage, solid, nullptr, coverage_rgb};
  }
  bool operator==(const Ink& other) const {
    return sum == other.sum && is_same(box, other.box);
  }

 private:
  friend SinkCalls;

  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    for (int32_t i = 0; values != nullptr && i < count; ++i) {
      add(x + i, y, 1, values[i]);
    }
    if (values == nullptr) {
      add(x, y, count, 255);
    }
  }
  void add(int32_t x, int32_t y, int32_t count, uint8_t value) {
    sum += int64_t{value} * count;
    if (value == 0) {
      return;
    }
    if (inkcell::is_empty(box)) {
      box = {x, y, x + count, y + 1};
    }
    box = {x < box.x0 ? x : box.x0, y < box.y0 ? y : box.y0,
           x + count > box.x1 ? x + count : box.x1,
           y + 1 > box.y1 ? y + 1 : box.y1};
  }
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* values,
                           int32_t count) {
    for (int32_t i = 0; i < 3 * count; ++i) {
      static_cast<Ink*>(context)->add(x + i / 3, y, 1, values[i]);
    }
  }
};
