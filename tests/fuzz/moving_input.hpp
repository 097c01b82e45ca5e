// What a fuzzer's input says of things that move: numbers in the order in which
// they are asked for, and a sink that knows its window.
#pragma once

#include <stdint.h>

#include "exercise.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/pose.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace moving_input {

using namespace inkcell;
using namespace inkcell::motion;
using hostile::require;

inline constexpr int32_t kSide = 24;  // of grids and windows
inline constexpr Rect kWindow = {-3, -2, kSide, kSide};

// Numbers from the input.
class Choices {
 public:
  explicit Choices(Span<const uint8_t> bytes) : bytes_(bytes) {}

  uint8_t byte() { return at_ < bytes_.size ? bytes_[at_++] : uint8_t{0}; }
  uint16_t u16() {
    const uint8_t low = byte();
    return static_cast<uint16_t>(low | byte() << 8);
  }
  // Any magnitude: the first byte says how far it is shifted.
  int32_t number() {
    const uint32_t shift = byte() % 32u;
    const uint32_t low = u16();
    const uint32_t value = low | static_cast<uint32_t>(u16()) << 16;
    return static_cast<int32_t>(value) >> shift;
  }
  int16_t i16() { return static_cast<int16_t>(u16()); }
  Q26_6 q6() { return Q26_6::from_raw(number()); }
  Q16_16 q16() { return Q16_16::from_raw(number()); }
  Point point() {
    const Q26_6 x = q6();
    return {x, q6()};
  }
  Rect rect() {
    const int32_t x0 = number();
    const int32_t y0 = number();
    const int32_t x1 = number();
    return {x0, y0, x1, number()};
  }

 private:
  Span<const uint8_t> bytes_;
  size_t at_ = 0;
};

// A sink that knows its window.
struct Canvas {
  Rect window = kWindow;

  void check(int32_t x, int32_t y, int32_t count) const {
    require(count >= 1 && x >= window.x0 && x <= window.x1 - count &&
                y >= window.y0 && y < window.y1,
            "pixels are in the window");
  }
  Sink sink() {
    Sink sink;
    sink.window = window;
    sink.context = this;
    sink.coverage = [](void* context, int32_t x, int32_t y, const uint8_t*,
                       int32_t count) {
      require(count <= kMaxSpan, "spans are short");
      static_cast<const Canvas*>(context)->check(x, y, count);
    };
    sink.solid = [](void* context, int32_t x, int32_t y, int32_t count) {
      static_cast<const Canvas*>(context)->check(x, y, count);
    };
    return sink;
  }
};

inline Easing easing_of(Choices& choices) {
  Easing easing;
  easing.kind = static_cast<Easing::Kind>(choices.byte());
  easing.steps = choices.byte();
  easing.x1_q14 = choices.i16();
  easing.y1_q14 = choices.i16();
  easing.x2_q14 = choices.i16();
  easing.y2_q14 = choices.i16();
  return easing;
}

inline Pose pose_of(Choices& choices) {
  Pose pose;
  pose.offset = choices.point();
  pose.angle.raw = choices.u16();
  pose.scale_x.raw = choices.i16();
  pose.scale_y.raw = choices.i16();
  pose.slant.raw = choices.i16();
  pose.weight.raw = choices.i16();
  pose.opacity = choices.byte();
  return pose;
}

}  // namespace moving_input
