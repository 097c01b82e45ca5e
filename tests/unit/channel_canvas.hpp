// A mock sink for small pictures of several channels: red, green, blue, and
// then, if there are four, what a fill's sink is given. Grey goes to three.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "check.hpp"
#include "inkcell/strip.hpp"
#include "sink_calls.hpp"

template <int32_t kWidth, int32_t kHeight, int32_t kChannels>
struct ChannelCanvas : SinkCalls<ChannelCanvas<kWidth, kHeight, kChannels>> {
  using Calls = SinkCalls<ChannelCanvas>;
  static constexpr int32_t kColours = 3;

  uint8_t pixels[static_cast<size_t>(kHeight * kWidth * kChannels)];
  inkcell::Rect shown;

  static constexpr int32_t index(int32_t x, int32_t y) {
    return (y * kWidth + x) * kChannels;
  }
  uint8_t at(int32_t x, int32_t y) const { return pixels[index(x, y) + 1]; }

  void clear() {
    for (uint8_t& pixel : pixels) {
      pixel = 0;
    }
  }
  inkcell::Sink sink(const inkcell::Rect& part, bool takes_blocks = false) {
    shown = part;
    return {part,
            this,
            Calls::coverage,
            Calls::solid,
            takes_blocks ? Calls::block : nullptr,
            coverage_rgb};
  }
  inkcell::Sink fill(const inkcell::Rect& part) {
    static_assert(kChannels > kColours, "there is a channel for it");
    return {part, this, cover_fill, solid_fill};
  }

  // `value`: null for full coverage.
  void put(int32_t x, int32_t y, const uint8_t* value, int32_t count) {
    for (int32_t channel = 0; channel < kColours; ++channel) {
      put(x, y, channel, value, count, 1);
    }
  }
  void put(int32_t x,
           int32_t y,
           int32_t channel,
           const uint8_t* value,
           int32_t count,
           int32_t step) {
    const bool fits = Calls::fits(shown, x, y, count);
    for (int32_t i = 0; fits && i < count; ++i) {
      uint8_t& pixel = pixels[index(x + i, y) + channel];
      CHECK(pixel == 0 && "drawn once");
      pixel = value == nullptr ? 255 : value[i * step];
    }
  }

 private:
  static ChannelCanvas& of(void* context) {
    return *static_cast<ChannelCanvas*>(context);
  }
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* values,
                           int32_t count) {
    CHECK(count <= inkcell::kMaxSpan);
    for (int32_t channel = 0; channel < kColours; ++channel) {
      of(context).put(x, y, channel, values + channel, count, kColours);
    }
  }
  static void cover_fill(void* context,
                         int32_t x,
                         int32_t y,
                         const uint8_t* values,
                         int32_t count) {
    of(context).put(x, y, kColours, values, count, 1);
  }
  static void solid_fill(void* context, int32_t x, int32_t y, int32_t count) {
    of(context).put(x, y, kColours, nullptr, count, 1);
  }
};
