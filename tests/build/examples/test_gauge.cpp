// The example gauge.cpp: 71, 30, 12 and 71 per cent again.
#include "colour_screen.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using Screen = example::Screen<240, 240>;

constexpr uint32_t kPaper = example::rgb888(rgb565(16, 20, 28));
constexpr uint32_t kTrack = example::rgb888(rgb565(52, 60, 76));
constexpr uint32_t kFull = example::rgb888(rgb565(80, 200, 120));
constexpr uint32_t kLow = example::rgb888(rgb565(240, 96, 64));
constexpr uint32_t kValues[] = {71, 30, 12, 71};
constexpr int32_t kReadings = 4;

dcs_model::DcsModel model(240, 320);
Screen screens[kReadings];
int64_t pixels_sent[kReadings];
int32_t reading = 0;

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
}

uint32_t read_percent() {
  if (reading != 0) {
    DcsPanel panel;
    panel.width = panel.height = 240;
    Screen& screen = screens[reading - 1];
    example::read_screen(model, panel, screen);
    screen.show("gauge", reading - 1);
    pixels_sent[reading - 1] = model.pixels;
    model.pixels = 0;
    if (reading == kReadings) {
      example::stop();
    }
  }
  return kValues[reading++];
}

TEST(gauge_draws_what_changes) {
  example::run();
  CHECK_EQ(model.resets, 1);
  // Where the middle of the arc is at a value, a little beside it.
  const auto colour = [](int32_t frame, int32_t x, int32_t y) {
    return screens[frame].pixels[y][x];
  };
  for (int32_t frame = 0; frame < kReadings; ++frame) {
    const uint32_t value = kValues[frame];
    const uint32_t full = value < 20 ? kLow : kFull;
    // 5, 50 and 95 per cent.
    CHECK_EQ(colour(frame, 41, 173), full);
    CHECK_EQ(colour(frame, 120, 24), value > 50 ? full : kTrack);
    CHECK_EQ(colour(frame, 199, 173), kTrack);
    CHECK_EQ(colour(frame, 120, 216), kPaper);
    CHECK_EQ(colour(frame, 2, 2), kPaper);
    // The number, and the mark above it.
    CHECK(screens[frame].ink({80, 92, 160, 146}, kPaper) > 500);
    CHECK(screens[frame].ink({116, 40, 124, 54}, kPaper) > 20);
  }
  CHECK(!is_empty(screens[1].changes(screens[0])));
  CHECK(is_empty(screens[3].changes(screens[0])));
  CHECK_EQ(pixels_sent[0], 240 * 240);
  for (int32_t frame = 1; frame < kReadings; ++frame) {
    check::write_number(pixels_sent[frame]);
    check::write(" pixels sent\n");
    // Another colour takes all of the arc.
    CHECK(frame != 1 || pixels_sent[frame] < 240 * 240 / 2);
  }
}
