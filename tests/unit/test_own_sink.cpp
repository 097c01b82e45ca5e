// The pixel format that docs/DISPLAY.md adds: 8-bit colour, 3-3-2.
#include "check.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

using namespace inkcell;

struct Rgb332Canvas : Sink {
  Strip strip;
  uint8_t colour;  // RRRGGGBB

  Rgb332Canvas(const Strip& rows, uint8_t foreground)
      : strip(rows), colour(foreground) {
    window = strip.rect();
    context = this;
    coverage = coverage_332;
    solid = solid_332;
  }
  Rgb332Canvas(const Rgb332Canvas&) =
      delete;  // the context would be the other's

  static void coverage_332(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* coverage,
                           int32_t count);
  static void solid_332(void* context, int32_t x, int32_t y, int32_t count);
};

void Rgb332Canvas::coverage_332(void* context,
                                int32_t x,
                                int32_t y,
                                const uint8_t* coverage,
                                int32_t count) {
  const auto& canvas = *static_cast<const Rgb332Canvas*>(context);
  const Strip& strip = canvas.strip;
  const uint32_t colour = canvas.colour;
  uint8_t* pixel =
      strip.pixels.data + (y - strip.y0) * strip.stride + (x - strip.x0);
  for (int32_t i = 0; i < count; ++i, ++pixel) {
    const uint32_t red = port::blend(coverage[i], colour >> 5, *pixel >> 5);
    const uint32_t green =
        port::blend(coverage[i], colour >> 2 & 7, *pixel >> 2 & 7);
    const uint32_t blue = port::blend(coverage[i], colour & 3, *pixel & 3);
    *pixel = static_cast<uint8_t>(red << 5 | green << 2 | blue);
  }
}

void Rgb332Canvas::solid_332(void* context,
                             int32_t x,
                             int32_t y,
                             int32_t count) {
  const auto& canvas = *static_cast<const Rgb332Canvas*>(context);
  const Strip& strip = canvas.strip;
  uint8_t* pixel =
      strip.pixels.data + (y - strip.y0) * strip.stride + (x - strip.x0);
  for (int32_t i = 0; i < count; ++i) {
    pixel[i] = canvas.colour;
  }
}

TEST(own_sink_blends_each_channel) {
  uint8_t pixels[2][5] = {{0, 0, 0, 0, 0}, {0, 0, 0b10010010, 0, 0}};
  const Rgb332Canvas sink({{&pixels[0][0], sizeof pixels}, 10, 20, 5, 2, 5},
                          0b11101001);  // 7, 2, 1
  CHECK_EQ(sink.window.x1, 15);
  sink.solid(sink.context, 11, 20, 3);
  CHECK_EQ(pixels[0][0], 0);
  CHECK_EQ(pixels[0][1], 0b11101001);
  CHECK_EQ(pixels[0][3], 0b11101001);
  CHECK_EQ(pixels[0][4], 0);
  // Half of 7, 2, 1 on 0; of the same on 4, 4, 2; all of it; none of it.
  const uint8_t coverage[] = {128, 128, 255, 0};
  sink.coverage(sink.context, 11, 21, coverage, 4);
  CHECK_EQ(pixels[1][0], 0);
  CHECK_EQ(pixels[1][1], 0b10000101);
  CHECK_EQ(pixels[1][2], 0b11001101);
  CHECK_EQ(pixels[1][3], 0b11101001);
  CHECK_EQ(pixels[1][4], 0);
}
