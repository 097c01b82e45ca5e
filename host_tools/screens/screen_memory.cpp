#include "screen_memory.hpp"

#include <array>
#include <fstream>

#include "canvas.hpp"
#include "display.hpp"
#include "inkcell/port/framebuffer.hpp"

namespace {

using inkcell::port::PixelFormat;
namespace demo = inkcell::demo;
namespace port = inkcell::port;

constexpr bool kShifted565 = INKCELL_SCREEN_SHIFTED_565 != 0;
constexpr int kScale = INKCELL_SCREEN_SCALE;
constexpr int32_t kStride = port::stride_bytes(demo::kFormat, demo::kWidth);

using Rgb = std::array<uint8_t, 3>;

alignas(4) std::array<
    uint8_t,
    port::strip_bytes(demo::kFormat, demo::kWidth, demo::kHeight)> memory;

uint8_t expand(uint32_t value, int bits) {
  const uint32_t shifted = value << (8 - bits);
  return static_cast<uint8_t>(kShifted565 ? shifted
                                          : shifted | value >> (2 * bits - 8));
}

Rgb grey(uint32_t level) {
  const auto value = static_cast<uint8_t>(level);
  return {value, value, value};
}

// The colour that the display shows for pixel (x, y) of its memory.
Rgb shown(int32_t x, int32_t y) {
  const auto byte = [](int32_t row, int32_t index) -> uint32_t {
    return memory.at(static_cast<size_t>(row * kStride + index));
  };
  switch (demo::kFormat) {
    case PixelFormat::grey4:
      return grey(17 * (byte(y, x / 2) >> (x % 2 == 0 ? 4 : 0) & 15));
    case PixelFormat::mono_pages:
      return grey(255 * (byte(y / 8, x) >> (y % 8) & 1));
    case PixelFormat::rgb565: {
      const uint32_t pixel = byte(y, 2 * x) | byte(y, 2 * x + 1) << 8;
      return {expand(pixel >> 11, 5), expand(pixel >> 5 & 63, 6),
              expand(pixel & 31, 5)};
    }
    default:
      return {static_cast<uint8_t>(byte(y, 4 * x + 2)),
              static_cast<uint8_t>(byte(y, 4 * x + 1)),
              static_cast<uint8_t>(byte(y, 4 * x))};
  }
}

}  // namespace

bool write_ppm(const std::string& name) {
  constexpr int kWide = demo::kWidth * kScale;
  constexpr int kHigh = demo::kHeight * kScale;
  std::ofstream file(name, std::ios::binary);
  file << "P6\n" << kWide << ' ' << kHigh << "\n255\n";
  for (int y = 0; y < kHigh; ++y) {
    for (int x = 0; x < kWide; ++x) {
      for (const uint8_t channel : shown(x / kScale, y / kScale)) {
        file.put(static_cast<char>(channel));
      }
    }
  }
  return static_cast<bool>(file.flush());
}

// The board of the demo on the host: its display is memory.
inkcell::Status inkcell::board::display_write(
    const Strip& strip) noexcept {
  const port::Framebuffer display = {{memory.data(), memory.size()},
                                     demo::kFormat,
                                     demo::kWidth,
                                     demo::kHeight,
                                     kStride};
  return port::write(display, strip);
}
