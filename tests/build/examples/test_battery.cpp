// The example battery.cpp: 100, 50, 9 and 100 per cent.
#include "example.hpp"
#include "mono_model.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;
using Screen = example::Screen<128, 64>;

constexpr uint32_t kValues[] = {100, 50, 9, 100};
constexpr int32_t kReadings = 4;

mono_model::MonoModel model(true);
Screen screens[kReadings];
int32_t reading = 0;

}  // namespace

void write_i2c(void*, uint8_t, const uint8_t* bytes, size_t count) {
  if (bytes[0] == 0x00) {
    model.command(&model, bytes + 1, count - 1);
  } else {
    model.data(&model, bytes + 1, count - 1);
  }
}

void wait_ms(void*, uint32_t) {
  CHECK(model.on);
  Screen& screen = screens[reading - 1];
  for (int32_t y = 0; y < 64; ++y) {
    for (int32_t x = 0; x < 128; ++x) {
      screen.pixels[y][x] = model.shown(x, y) ? 0xffffff : 0;
    }
  }
  screen.show("battery", reading - 1);
  if (reading == kReadings) {
    example::stop();
  }
}

uint32_t read_percent() {
  return kValues[reading++];
}

TEST(battery_shows_what_is_left) {
  example::run();
  const Rect inside = {14, 12, 98, 36};
  for (const Screen& screen : screens) {
    // The case: 2 px on each side, without its corners; and the pole.
    CHECK_EQ(screen.ink({20, 7, 92, 9}, 0), 2 * 72);
    CHECK_EQ(screen.ink({20, 39, 92, 41}, 0), 2 * 72);
    CHECK_EQ(screen.ink({9, 18, 11, 30}, 0), 2 * 12);
    CHECK_EQ(screen.ink({12, 18, 14, 30}, 0), 0);
    CHECK_EQ(screen.ink({106, 18, 110, 30}, 0), 4 * 12);
    CHECK(screen.ink({40, 46, 90, 64}, 0) > 60);  // the number
  }
  // Corners of 3 px lack some pixels each.
  const int32_t whole = screens[0].ink(inside, 0);
  CHECK(whole < 84 * 24 && whole >= 84 * 24 - 4 * 3);
  const int32_t half = screens[1].ink(inside, 0);
  CHECK(half < 42 * 24 && half >= 42 * 24 - 4 * 3);
  CHECK_EQ(screens[1].ink({56, 12, 98, 36}, 0), 0);
  // A triangle with its sign.
  const int32_t sign = screens[2].ink(inside, 0);
  CHECK(sign > 120 && sign < 240);
  CHECK_EQ(screens[2].ink({55, 20, 57, 27}, 0), 2 * 7);
  CHECK(is_empty(screens[3].changes(screens[0])));
}
