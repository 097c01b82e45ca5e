// The demo's pictures, rendered by this machine as a display would show them:
//
//     scene_host scene FRAME OUT.ppm
//     scene_host pattern OUT.ppm
//
// The whole screen is one strip here. What becomes of a pixel is each
// controller's rule:
//
//     grey4        SSD0323: level g is grey 17 g; 4 x 4 points a pixel
//     mono_pages   SSD0303: white on black; 4 x 4 points a pixel
//     rgb565       PL110: channels shifted up; VGA: high bits repeated below
//     xrgb8888     as it is
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "canvas.hpp"
#include "display.hpp"
#include "inkcell/port/framebuffer.hpp"
#include "pattern.hpp"
#include "scene.hpp"
#include "show.hpp"

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

// What the display shows for the pixel at (x, y) of its memory.
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

bool render_scene(uint32_t frame) {
  static demo::Scene scene;
  if (scene.open() != inkcell::Status::ok) {
    std::cerr << "the scene's font does not open\n";
    return false;
  }
  if (scene.missing_characters() != 0) {
    std::cerr << scene.missing_characters()
              << " characters of the scene are not in its font\n";
    return false;
  }
  scene.set_frame(frame);
  demo::show(nullptr,
             [](void*, const inkcell::Strip& strip) { scene.draw(strip); });
  return true;
}

}  // namespace

// The board that the demo runs on here: its display is a piece of memory.
void inkcell::board::display_write(const Strip& strip) noexcept {
  const port::Framebuffer display = {{memory.data(), memory.size()},
                                     demo::kFormat,
                                     demo::kWidth,
                                     demo::kHeight,
                                     kStride};
  if (port::write(display, strip) != Status::ok) {
    std::abort();
  }
}

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 3 && arguments[0] == "scene") {
    const auto frame = static_cast<uint32_t>(std::stoul(arguments[1]));
    return render_scene(frame) && write_ppm(arguments[2]) ? 0 : 1;
  }
  if (arguments.size() == 2 && arguments[0] == "pattern") {
    demo::show_pattern();
    return write_ppm(arguments[1]) ? 0 : 1;
  }
  std::cerr << "usage: scene_host scene FRAME OUT.ppm | pattern OUT.ppm\n";
  return 64;
}
