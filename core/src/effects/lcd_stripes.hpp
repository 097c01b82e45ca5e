// What both ways to draw sub-pixels share.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "distance/point_walk.hpp"
#include "inkcell/lcd.hpp"

namespace inkcell {
namespace detail {

inline constexpr int32_t kThird = (1 << 10) / 3;  // [px, Q10]

// How much steeper than the filter the ramp of a stripe is, by 1/32 of the
// gradient's component across the stripes: a stripe is a third of a pixel wide
// and a pixel long, and a straight edge of normal (n, m) takes a way of
// n / 3 + m to cover it. [Q8]
inline constexpr uint16_t kSteepness[33] = {
    256, 253, 251, 249, 248, 246, 245, 244, 243, 243, 243,
    243, 243, 244, 245, 246, 248, 250, 252, 255, 259, 263,
    268, 274, 281, 289, 300, 313, 330, 353, 388, 448, 768};

// The mean of three to within a level, without a division.
inline uint8_t third(int32_t sum) noexcept {
  return static_cast<uint8_t>((sum * 171 + 85) >> 9);
}
inline uint8_t mean(int32_t a, int32_t b, int32_t c) noexcept {
  return third(a + b + c);
}

inline bool is_vertical(SubPixels order) noexcept {
  return order == SubPixels::rgb_vertical || order == SubPixels::bgr_vertical;
}

// What the flattest ramp of all reaches beyond the filter's. [px, Q10]
inline constexpr int32_t kFlattest = 1 << 6;

// From what changes from a stripe to the next. [px, Q10]
inline int32_t steepness_q8(int32_t change_q10) noexcept {
  const int32_t part = (3 * change_q10 + 16) >> 5;
  return kSteepness[part < 32 ? part : 32];
}

// What the stripes of a pixel cover, from their distances. [px, Q10]
template <uint32_t kCount>
inline void cover_stripes(const Filter& filter,
                          const int32_t* d,
                          uint8_t* out) noexcept {
  int32_t most_q10 = 0;  // of what changes from one to the next
  for (uint32_t i = 1; i < kCount; ++i) {
    most_q10 = max(most_q10, abs(d[i] - d[i - 1]));
  }
  const int32_t steepness = steepness_q8(most_q10);
  const int32_t centre = (filter.outside_q10 + filter.inside_q10) >> 1;
  for (uint32_t i = 0; i < kCount; ++i) {
    out[i] = filter.coverage(centre + (((d[i] - centre) * steepness) >> 8));
  }
}

inline bool is_red_first(SubPixels order) noexcept {
  return order == SubPixels::rgb || order == SubPixels::rgb_vertical;
}

// Hands on pixels of three coverages, which may be changed.
__attribute__((noinline)) inline void hand_on(const Sink& sink,
                                              const LcdOptions& lcd,
                                              int32_t x,
                                              int32_t y,
                                              uint8_t* rgb,
                                              int32_t count) noexcept {
  const bool is_grey = sink.coverage_rgb == nullptr;
  if (is_grey || lcd.colour != 255) {
    for (int32_t i = 0; i < count; ++i) {
      uint8_t* const pixel = rgb + 3 * i;
      const int32_t grey = mean(pixel[0], pixel[1], pixel[2]);
      for (int32_t j = 0; j < 3; ++j) {
        pixel[j] =
            static_cast<uint8_t>(grey + (pixel[j] - grey) * lcd.colour / 255);
      }
    }
  }
  if (!is_grey) {
    sink.coverage_rgb(sink.context, x, y, rgb, count);
    return;
  }
  for (int32_t i = 0; i < count; ++i) {
    rgb[i] = mean(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
  }
  sink.coverage(sink.context, x, y, rgb, count);
}

// Pixels of three coverages on their way to a sink.
class RgbSpans {
 public:
  RgbSpans(const Sink& sink, const LcdOptions& lcd, int32_t y) noexcept
      : sink_(sink), lcd_(lcd), y_(y) {}

  // Five stripes around a pixel; the three in the middle are its own. Each
  // channel is the mean of its stripe and the two beside it.
  __attribute__((noinline)) void put(int32_t x,
                                     const uint8_t* stripes) noexcept {
    const uint8_t first = mean(stripes[0], stripes[1], stripes[2]);
    const uint8_t second = mean(stripes[1], stripes[2], stripes[3]);
    const uint8_t third = mean(stripes[2], stripes[3], stripes[4]);
    if ((first | second | third) == 0) {
      flush();
      return;
    }
    if ((first & second & third) == 255) {
      solid(x);
      return;
    }
    if (solid_count_ != 0 || count_ == kMaxSpan) {
      flush();
    }
    x_ = count_ == 0 ? x : x_;
    const bool red_first = is_red_first(lcd_.order);
    uint8_t* const rgb = buffer_ + 3 * count_++;
    rgb[0] = red_first ? first : third;
    rgb[1] = second;
    rgb[2] = red_first ? third : first;
  }

  // To the row below.
  void next_row() noexcept {
    flush();
    ++y_;
  }

 private:
  void solid(int32_t x) noexcept {
    if (count_ != 0) {
      flush();
    }
    x_ = solid_count_ == 0 ? x : x_;
    ++solid_count_;
  }

  void flush() noexcept {
    if (solid_count_ != 0) {
      sink_.solid(sink_.context, x_, y_, solid_count_);
    } else if (count_ != 0) {
      hand_on(sink_, lcd_, x_, y_, buffer_, count_);
    }
    count_ = 0;
    solid_count_ = 0;
  }

  const Sink& sink_;
  const LcdOptions& lcd_;
  int32_t y_;
  int32_t x_ = 0;
  // At most one of the two is not 0.
  int32_t count_ = 0;
  int32_t solid_count_ = 0;
  uint8_t buffer_[3 * kMaxSpan];
};

// What drawing takes, in frames of their own: none shall be large.
struct LcdRows {
  const TextStyle& style;
  const FinePoint& origin;
  Rect all;  // the pixels that may show something
  Rect box;  // those in the window

  __attribute__((noinline)) FieldPosition at(int32_t x,
                                             int32_t y,
                                             int32_t right_q10,
                                             int32_t up_q10) const noexcept {
    return sample_position(style, origin, x, y, {right_q10, up_q10});
  }
};

// Draws stripes of an upright glyph of fields.
void draw_stripe_rows(const GlyphField& field,
                      const LcdRows& rows,
                      const LcdOptions& lcd,
                      const Sink& sink) noexcept;

}  // namespace detail
}  // namespace inkcell
