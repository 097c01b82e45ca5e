// The examples clock.cpp and clock.c: 12:59, 13:00 and 12:59 again.
#include "colour_screen.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using Screen = example::Screen<320, 240>;

constexpr uint32_t kPaper = example::rgb888(rgb565(11, 15, 22));
constexpr int32_t kReadings = 3;
constexpr uint32_t kMinutes[] = {12 * 60 + 59, 13 * 60, 12 * 60 + 59};

dcs_model::DcsModel model(240, 320);
Screen screens[kReadings], between;
int32_t reading = -2;  // the first asks where to begin
int32_t frames = 0;
int32_t moving = 0;  // frames in which the picture is neither old nor new
Rect moved = {320, 240, 0, 0};

void read_screen(Screen& screen) {
  DcsPanel panel;
  panel.width = 240;
  panel.height = 320;
  panel.rotation = Rotation::quarter;
  panel.mirror_columns = true;
  example::read_screen(model, panel, screen);
}

}  // namespace

void write_command(void*, const uint8_t* bytes, size_t count) {
  model.command(&model, bytes, count);
}

void write_data(void*, const uint8_t* bytes, size_t count) {
  model.data(&model, bytes, count);
}

void pulse_reset(void*) {
  ++model.resets;
}

void wait_ms(void*, uint32_t ms) {
  model.waited_ms += ms;
  if (reading < 1 || ms >= 100) {
    return;
  }
  ++frames;
  if (reading == 1) {
    read_screen(between);
    if (frames % 5 == 0) {
      between.show("clock_change", frames);
    }
    const Rect changes = between.changes(screens[0]);
    moved.x0 = changes.x0 < moved.x0 ? changes.x0 : moved.x0;
    moved.y0 = changes.y0 < moved.y0 ? changes.y0 : moved.y0;
    moved.x1 = changes.x1 > moved.x1 ? changes.x1 : moved.x1;
    moved.y1 = changes.y1 > moved.y1 ? changes.y1 : moved.y1;
    moving += between.ink(kPaper) > 0 && !is_empty(changes) ? 1 : 0;
  }
}

uint32_t read_minutes() {
  if (reading >= 0) {
    read_screen(screens[reading]);
    screens[reading].show("clock", reading);
  }
  if (++reading == kReadings) {
    example::stop();
  }
  return kMinutes[reading < 0 ? 0 : reading];
}

TEST(clock_turns_digits_into_others) {
  example::run();
  CHECK_EQ(model.resets, 1);
  CHECK((model.access & 0x08) != 0);  // blue first
  constexpr Rect kDigits[] = {{20, 81, 82, 159},
                              {82, 81, 144, 159},
                              {176, 81, 238, 159},
                              {238, 81, 300, 159}};
  constexpr Rect kColon = {144, 81, 176, 159};
  for (const auto& screen : screens) {
    int32_t ink = screen.ink(kColon, kPaper);
    CHECK(ink > 150);
    for (const Rect& digit : kDigits) {
      CHECK(screen.ink(digit, kPaper) > 500);
      ink += screen.ink(digit, kPaper);
    }
    CHECK_EQ(ink, screen.ink(kPaper));
  }
  // 2, 5 and 9 change at once, 1 stays.
  CHECK(example::lies_in(screens[1].changes(screens[0]),
                         {kDigits[1].x0, 81, 300, 159}));
  CHECK(is_empty(screens[2].changes(screens[0])));
  CHECK_EQ(frames, 2 * 20);
  CHECK(moving >= 20 - 1);
  CHECK(example::lies_in(moved, {kDigits[1].x0, 81, 300, 159}));
}
