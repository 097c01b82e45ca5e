// The example ssd1306.cpp, until its line has gone round once.
#include "example.hpp"
#include "mono_model.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;
using Screen = example::Screen<128, 64>;

constexpr int32_t kMostFrames = 600;
constexpr uint8_t kAddress = 0x3c;

mono_model::MonoModel model(true);
Screen first, screen;
int32_t frames = 0;
bool comes_again = false;

void read_screen() {
  for (int32_t y = 0; y < 64; ++y) {
    for (int32_t x = 0; x < 128; ++x) {
      screen.pixels[y][x] = model.shown(x, y) ? 0xffffff : 0;
    }
  }
}

}  // namespace

void write_i2c(void*, uint8_t address, const uint8_t* bytes, size_t count) {
  CHECK_EQ(address, kAddress);
  CHECK(count >= 2 && (bytes[0] == 0x00 || bytes[0] == 0x40));
  if (bytes[0] == 0x00) {
    model.command(&model, bytes + 1, count - 1);
  } else {
    model.data(&model, bytes + 1, count - 1);
  }
}

void wait_ms(void*, uint32_t) {
  CHECK(model.on);
  read_screen();
  if (frames == 0) {
    first = screen;
  }
  const Rect changes = screen.changes(first);
  if (frames % 60 == 0 || (frames > 0 && is_empty(changes))) {
    screen.show("ssd1306", frames);
  }
  if (frames > 0) {
    CHECK(is_empty(changes) || example::lies_in(changes, {0, 48, 128, 64}));
    comes_again = is_empty(changes);
  }
  if (comes_again || ++frames == kMostFrames) {
    example::stop();
  }
}

TEST(ssd1306_shows_a_paragraph_and_a_line_that_scrolls) {
  example::run();
  // Three lines of words, in the middle, and the line below.
  for (int32_t line = 0; line < 3; ++line) {
    const int32_t ink = first.ink({0, 16 * line, 128, 16 * line + 16}, 0);
    CHECK(ink > 150 && ink < 600);
  }
  CHECK(first.ink({0, 48, 128, 64}, 0) > 150);
  CHECK(comes_again);
  CHECK(frames > 200);
}
