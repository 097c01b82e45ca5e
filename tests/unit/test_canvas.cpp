// Canvases: backgrounds, copies, other strips, and values out of range.
#include "check.hpp"
#include "inkcell/inkcell.hpp"
#include "inkcell/port/dither.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 5;
constexpr int32_t kHeight = 3;

alignas(4) uint8_t bytes[4 * kWidth * kHeight];

Strip strip_of(PixelFormat format) {
  for (uint8_t& byte : bytes) {
    byte = 0x5a;
  }
  return {{bytes, strip_bytes(format, kWidth, kHeight)},
          -2,
          40,
          kWidth,
          kHeight,
          stride_bytes(format, kWidth)};
}

void draw_dot(const Sink& sink) {
  sink.solid(sink.context, -1, 41, 1);
}

// A canvas on a background: all of that but the pixel at (1, 1).
template <typename Canvas>
void check_background(const Canvas& canvas,
                      int32_t pixel_bytes,
                      uint8_t background,
                      uint8_t drawn) {
  CHECK_OK(canvas.status());
  draw_dot(canvas);
  const int32_t dot = canvas.strip().stride + pixel_bytes;
  for (int32_t i = 0; i < canvas.strip().stride * kHeight; ++i) {
    CHECK_EQ(bytes[i], i >= dot && i < dot + pixel_bytes ? drawn : background);
  }
}

TEST(strips_are_filled_with_a_background) {
  check_background(Grey8Canvas(strip_of(PixelFormat::grey8), 200, 7), 1, 7,
                   200);
  check_background(Rgb565Canvas(strip_of(PixelFormat::rgb565), 0x1212, 0xe7e7),
                   2, 0xe7, 0x12);
  check_background(
      Rgb888Canvas(strip_of(PixelFormat::rgb888), 0x010101, 0x929292), 3, 0x92,
      1);
  check_background(
      Xrgb8888Canvas(strip_of(PixelFormat::xrgb8888), 0, 0xffffffff), 4, 255,
      0);
  draw_dot(Grey4Canvas(strip_of(PixelFormat::grey4), 9, 2));
  CHECK_EQ(bytes[0], 0x22);
  CHECK_EQ(bytes[3], 0x29);
  draw_dot(Grey2Canvas(strip_of(PixelFormat::grey2), 3, 1, BitOrder::low_left));
  CHECK_EQ(bytes[0], 0x55);
  CHECK_EQ(bytes[2], 0x5d);
  draw_dot(MonoRowsCanvas(strip_of(PixelFormat::mono_rows), 1, 0));
  CHECK_EQ(bytes[0], 0x02);
  CHECK_EQ(bytes[1], 0x42);
  draw_dot(MonoPagesCanvas(strip_of(PixelFormat::mono_pages), 0, 1));
  CHECK_EQ(bytes[0], 0x5f);
  CHECK_EQ(bytes[1], 0x5d);
}

// A copy draws with its own colour, also after the first one is gone.
TEST(copies_stand_alone) {
  Grey8Canvas first(strip_of(PixelFormat::grey8), 10);
  Grey8Canvas second = first;
  second.set_level(20);
  draw_dot(first);
  CHECK_EQ(bytes[kWidth + 1], 10);
  draw_dot(second);
  CHECK_EQ(bytes[kWidth + 1], 20);
  first = second;
  second.set_level(30);
  draw_dot(first);
  CHECK_EQ(bytes[kWidth + 1], 20);
}

TEST(canvases_take_other_strips) {
  MonoRowsCanvas canvas;
  CHECK_OK(canvas.status());
  CHECK(is_empty(canvas.window));
  draw_dot(canvas);
  set_dither(canvas);
  const auto dithers = canvas.coverage;
  canvas.set_strip(strip_of(PixelFormat::mono_rows));
  CHECK_OK(canvas.status());
  CHECK_EQ(canvas.window.y1, 40 + kHeight);
  CHECK(canvas.coverage == dithers);
  CHECK(dithers != MonoRowsCanvas().coverage);
  canvas.fill();
  CHECK_EQ(bytes[2], 0xfa);
  CHECK_EQ(bytes[3], 0x5a);
}

TEST(colours_change_between_calls) {
  Strip strip = {{bytes, 4}, 0, 0, 2, 1, 4, ByteOrder::high_first};
  Rgb565Canvas canvas(strip, 0);
  canvas.set_colour(rgb565(255, 0, 0));
  canvas.solid(canvas.context, 0, 0, 1);
  canvas.set_colour(rgb565(0, 0, 255));
  canvas.solid(canvas.context, 1, 0, 1);
  CHECK_EQ(bytes[0], 0xf8);
  CHECK_EQ(bytes[1], 0);
  CHECK_EQ(bytes[2], 0);
  CHECK_EQ(bytes[3], 0x1f);
  strip.order = ByteOrder::low_first;
  canvas.set_strip(strip);
  canvas.solid(canvas.context, 1, 0, 1);
  CHECK_EQ(bytes[2], 0x1f);
}

TEST(levels_out_of_range_are_clamped) {
  const uint8_t coverage[1] = {200};
  Grey4Canvas grey4({{bytes, 1}, 0, 0, 1, 1, 1}, 255, BitOrder::low_left);
  bytes[0] = 0;
  grey4.coverage(grey4.context, 0, 0, coverage, 1);
  CHECK_EQ(bytes[0], 12);
  grey4.set_level(16);
  grey4.fill();
  CHECK_EQ(bytes[0], 15);
  Grey2Canvas grey2({{bytes, 1}, 0, 0, 1, 1, 1}, 4);
  grey2.fill();
  CHECK_EQ(bytes[0], 0xcf);
  // No coverage draws nothing, whatever the threshold.
  const uint8_t nothing[1] = {0};
  MonoRowsCanvas rows({{bytes, 1}, 0, 0, 1, 1, 1}, 2);
  rows.set_threshold(0);
  bytes[0] = 0;
  rows.coverage(rows.context, 0, 0, nothing, 1);
  CHECK_EQ(bytes[0], 0);
  rows.coverage(rows.context, 0, 0, coverage, 1);
  CHECK_EQ(bytes[0], 0x80);
}

TEST(words_must_be_aligned) {
  Strip strip = {{bytes, 8}, 0, 0, 2, 1, 8};
  Xrgb8888Canvas canvas(strip);
  CHECK_OK(canvas.status());
  strip.stride = 10;
  canvas.set_strip(strip);
  CHECK_EQ(canvas.status(), Status::misaligned);
  CHECK(is_empty(canvas.window));
  strip.stride = 8;
  strip.pixels.data = bytes + 2;
  canvas.set_strip(strip);
  CHECK_EQ(canvas.status(), Status::misaligned);
  draw_dot(canvas);
  strip.pixels.data = bytes;
  canvas.set_strip(strip);
  CHECK_OK(canvas.status());
}

}  // namespace
