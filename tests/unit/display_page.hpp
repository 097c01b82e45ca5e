// Text drawn at once, and strip by strip through a display driver.
#pragma once

#include "check.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"
#include "outline_record.hpp"

namespace display_page {

using namespace inkcell;

inline constexpr size_t kMaxBytes = 2 * 240 * 320;  // of the largest picture

/// The same words in each picture: a large line that leaves the screen on three
/// sides, and a small one. `Canvas` is one of
/// port/pixel.
template <typename Canvas>
void draw_words(const Canvas& canvas) {
  static uint8_t rom[outline_record::kSampleFontBytes];
  static const Font font = [] {
    Font opened;
    const size_t size = outline_record::build_sample_font(rom);
    CHECK_OK(Font::open({rom, size}, opened));
    return opened;
  }();
  Style large, small;
  large = Style(61_px, kFilterArea);
  small = Style(13_px, kFilterArea);
  CHECK_OK(canvas.status());
  const Painter painter(canvas);
  painter.text(font, large, {-9, 37}, "DEFACED");
  painter.text(font, small, {3, 50}, "BEAD FACE");
  painter.text(font, large, {30, 150}, "FADE");
}

/// Clears a strip to `background` and draws the words.
template <typename Canvas>
void draw_page(const Canvas& canvas, uint8_t background) {
  for (uint8_t& byte : canvas.strip().pixels) {
    byte = background;
  }
  draw_words(canvas);
}

/// The whole picture in memory of its own, as the core draws it.
template <typename Canvas>
Strip reference(Canvas canvas,
                port::PixelFormat format,
                int32_t width,
                int32_t height,
                uint8_t background) {
  static uint8_t pixels[kMaxBytes];
  const size_t bytes = port::strip_bytes(format, width, height);
  CHECK(bytes <= kMaxBytes);
  canvas.set_strip({{pixels, bytes},
                    0,
                    0,
                    width,
                    height,
                    port::stride_bytes(format, width),
                    canvas.strip().order});
  draw_page(canvas, background);
  int64_t drawn = 0;
  for (const uint8_t byte : canvas.strip().pixels) {
    drawn += byte != background ? 1 : 0;
  }
  CHECK(drawn > 100 && "there is text");
  return canvas.strip();
}

/// Draws the page strip by strip, each with `rows` rows and `gap` bytes behind
/// each, and has `write(strip)` send it.
template <typename Canvas, typename Write>
void show_page(const Canvas& canvas,
               port::PixelFormat format,
               const Rect& part,
               int32_t rows,
               int32_t gap,
               uint8_t background,
               const Write& write) {
  static uint8_t pixels[kMaxBytes];
  Canvas piece = canvas;
  Strip strip = canvas.strip();
  strip.x0 = part.x0;
  strip.width = part.x1 - part.x0;
  strip.stride = port::stride_bytes(format, strip.width) + gap;
  for (strip.y0 = part.y0; strip.y0 < part.y1; strip.y0 += rows) {
    const int32_t left = part.y1 - strip.y0;
    strip.height = left < rows ? left : rows;
    const int32_t per_stride = port::rows_per_stride(format);
    strip.pixels = {pixels, static_cast<size_t>(strip.stride) *
                                static_cast<size_t>(strip.height / per_stride)};
    CHECK(strip.pixels.size <= kMaxBytes);
    piece.set_strip(strip);
    draw_page(piece, background);
    CHECK_OK(write(strip));
  }
}

}  // namespace display_page
