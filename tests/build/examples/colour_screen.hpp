// The screen that a model of a colour panel shows.
#pragma once

#include "dcs_model.hpp"
#include "example.hpp"

namespace example {

/// An RGB565 pixel with its bits as the high ones of 24.
constexpr uint32_t rgb888(uint16_t pixel) {
  return static_cast<uint32_t>((pixel & 0xf800) << 8 | (pixel & 0x07e0) << 5 |
                               (pixel & 0x001f) << 3);
}

template <int32_t kWidth, int32_t kHeight>
void read_screen(const dcs_model::DcsModel& model,
                 const inkcell::port::DcsPanel& panel,
                 Screen<kWidth, kHeight>& screen) {
  CHECK(model.on && model.awake);
  for (int32_t y = 0; y < kHeight; ++y) {
    for (int32_t x = 0; x < kWidth; ++x) {
      screen.pixels[y][x] = rgb888(
          dcs_model::shown(model, panel, dcs_model::turned(panel, x, y)));
    }
  }
}

}  // namespace example
