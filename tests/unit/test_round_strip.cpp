// Round screens: which pixels of a strip are drawn and sent.
#include "inkcell/port/round_strip.hpp"

#include "check.hpp"
#include "dcs_model.hpp"
#include "display_page.hpp"
#include "inkcell/port/gc9a01.hpp"

namespace {

using namespace dcs_model;

// Whether a round panel shows a part of a pixel: its nearest corner lies within
// the circle. [1/2 px]
bool in_circle(int32_t x, int32_t y, int32_t diameter) {
  const auto away = [diameter](int32_t at) {
    const int32_t first = 2 * at - diameter;
    const int32_t last = first + 2;
    return first > 0 ? first : (last < 0 ? -last : 0);
  };
  return away(x) * away(x) + away(y) * away(y) < diameter * diameter;
}

TEST(gc9a01_shows_all_of_its_circle) {
  for (const int32_t rows : each_of({1, 10, 64})) {
    DcsModel model(240, 240);
    auto display = make_display<Gc9a01>(model, 240, 240);
    display.mirror_columns = true;
    CHECK_OK(init(display));
    Rgb565Canvas canvas = make_canvas();
    static uint8_t pixels[2 * 240 * 64];
    for (int32_t y = 0; y < 240; y += rows) {
      const int32_t height = 240 - y < rows ? 240 - y : rows;
      const Strip whole = {
          pixels, 0, y, 240, height, 480, ByteOrder::high_first};
      canvas.set_strip(round_strip(whole, kFormat, 240));
      const Strip& strip = canvas.strip();
      CHECK_EQ(strip.height, height);
      CHECK_EQ(strip.stride, 2 * strip.width);
      CHECK(strip.width > 0 && strip.width <= 240);
      display_page::draw_page(canvas, 0x10);
      CHECK_OK(write(display, strip));
    }
    const Strip picture =
        display_page::reference(canvas, kFormat, 240, 240, 0x10);
    // Each strip has the columns of its row that is nearest to the centre.
    check_shown(model, display, picture, [rows](int32_t x, int32_t y) {
      const int32_t first = y / rows * rows;
      const int32_t end = first + rows < 240 ? first + rows : 240;
      for (int32_t row = first; row < end; ++row) {
        if (in_circle(x, row, 240)) {
          return true;
        }
      }
      return false;
    });
    // A circle has pi / 4 of its square.
    if (rows == 1) {
      CHECK(model.pixels > 45200 && model.pixels < 46000);
    }
  }
}

TEST(round_strips_are_cut_at_bytes) {
  uint8_t pixels[128];
  // A circle of 32 px has columns 8..23 in rows 0 and 1, 10..21 in row 0 alone.
  Strip part = round_strip({pixels, 0, 0, 32, 2, 64}, kFormat, 32);
  CHECK_EQ(part.x0, 8);
  CHECK_EQ(part.width, 16);
  part = round_strip({pixels, 0, 0, 32, 1, 64}, kFormat, 32);
  CHECK_EQ(part.x0, 10);
  CHECK_EQ(part.width, 12);
  part = round_strip({pixels, 0, 0, 32, 1, 4}, PixelFormat::mono_rows, 32);
  CHECK_EQ(part.x0, 8);
  CHECK_EQ(part.width, 16);
  CHECK_EQ(part.stride, 2);
  part = round_strip({pixels, 0, 0, 32, 1, 8}, PixelFormat::grey2, 32);
  CHECK_EQ(part.x0, 8);
  CHECK_EQ(part.width, 16);
  part = round_strip({pixels, 0, 0, 32, 1, 16}, PixelFormat::grey4, 32);
  CHECK_EQ(part.x0, 10);
  CHECK_EQ(part.width, 12);
  // Nothing below the circle and beside it, nor of what is no strip.
  CHECK_EQ(round_strip({pixels, 0, 32, 32, 2, 64}, kFormat, 32).width, 0);
  CHECK_EQ(round_strip({pixels, 0, 0, 4, 1, 8}, kFormat, 32).width, 0);
  CHECK_EQ(round_strip({pixels, 30, 0, 2, 1, 8}, kFormat, 32).width, 0);
  CHECK_EQ(round_strip({pixels, 0, 0, 32, 2, 63}, kFormat, 32).width, 32);
  CHECK_EQ(round_strip({pixels, 0, 0, 32, 2, 64}, kFormat, 0).width, 32);
}

}  // namespace
