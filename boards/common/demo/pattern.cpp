// Draws the test picture pixel by pixel, with the sinks that text uses.
#include "pattern.hpp"

#include "canvas.hpp"
#include "display.hpp"
#include "show.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

constexpr Rect kWindow = {24, 8, 64, 16};

void draw_pattern(const Strip& strip, uint8_t inverted) noexcept {
  constexpr Ink kInks[] = {Ink::clock, Ink::text, Ink::moving, Ink::background};
  Canvas canvas(strip);
  const Rect rect = strip.rect();
  for (int32_t y = rect.y0; y < rect.y1; ++y) {
    for (int32_t x = rect.x0; x < rect.x1; ++x) {
      const bool edge = x == 0 || y == 0 || x == kWidth - 1 || y == kHeight - 1;
      const Ink ink = edge ? Ink::text : kInks[(x / 8 + y / 8) % 4];
      const uint8_t coverage =
          edge ? 255 : static_cast<uint8_t>((x * 3 + y * 5) & 255) ^ inverted;
      const Sink& sink = canvas.sink(ink);
      sink.coverage(sink.context, x, y, &coverage, 1);
    }
  }
}

}  // namespace

void show_pattern() noexcept {
  show([](void*, const Strip& strip) {
    draw_pattern(strip, 0);
    return Status::ok;
  });

  constexpr int32_t kWindowWidth = kWindow.x1 - kWindow.x0;
  constexpr int32_t kWindowHeight = kWindow.y1 - kWindow.y0;
  alignas(4)
      uint8_t pixels[port::strip_bytes(kFormat, kWindowWidth, kWindowHeight)] =
          {};
  Strip window;
  window.pixels = pixels;
  window.x0 = kWindow.x0;
  window.y0 = kWindow.y0;
  window.width = kWindowWidth;
  window.height = kWindowHeight;
  window.stride = port::stride_bytes(kFormat, kWindowWidth);
  draw_pattern(window, 255);
  static_cast<void>(board::display_write(window));
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
