// The pixel format that docs/PORTING.md adds: 8-bit colour, 3-3-2.
#include "check.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

using namespace inkcell;

struct Rgb332Target {
  Strip strip;
  uint8_t colour = 0xff;  // RRRGGGBB
};

void coverage_332(void* context,
                  int32_t x,
                  int32_t y,
                  const uint8_t* coverage,
                  int32_t count) {
  const auto& target = *static_cast<const Rgb332Target*>(context);
  const Strip& strip = target.strip;
  const uint32_t colour = target.colour;
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

void solid_332(void* context, int32_t x, int32_t y, int32_t count) {
  const auto& target = *static_cast<const Rgb332Target*>(context);
  const Strip& strip = target.strip;
  uint8_t* pixel =
      strip.pixels.data + (y - strip.y0) * strip.stride + (x - strip.x0);
  for (int32_t i = 0; i < count; ++i) {
    pixel[i] = target.colour;
  }
}

Sink make_sink(Rgb332Target& target) {
  return {target.strip.rect(), &target, coverage_332, solid_332};
}

TEST(own_sink_blends_each_channel) {
  uint8_t pixels[2][5] = {{0, 0, 0, 0, 0}, {0, 0, 0b10010010, 0, 0}};
  Rgb332Target target;
  target.strip = {{&pixels[0][0], sizeof pixels}, 10, 20, 5, 2, 5};
  target.colour = 0b11101001;  // 7, 2, 1
  const Sink sink = make_sink(target);
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
