// The example ssd1681.cpp: a full refresh and two partial ones; and the first
// of those as a full one, in another run.
#include "epaper_model.hpp"
#include "example.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;

constexpr uint32_t kWhite = 0xffffff;
constexpr int32_t kFrames = 4;
constexpr int32_t kFirstRun = 3;
constexpr const char* kValues[] = {"21.5", "-9.8", "21.5", "-9.8"};

epaper_model::EpaperModel model(200, 200);
example::Screen<200, 200> screens[kFrames];
int64_t bytes_sent[kFrames];
uint8_t modes[kFrames];
int32_t frame = 0;
bool is_shown = false;

}  // namespace

void write_command(void*, const uint8_t* bytes, size_t count) {
  model.command(&model, bytes, count);
}

void write_data(void*, const uint8_t* bytes, size_t count) {
  bytes_sent[frame] += static_cast<int64_t>(count);
  model.data(&model, bytes, count);
}

void pulse_reset(void*) {
  ++model.resets;
  model.busy = true;
}

void wait_idle(void*) {
  model.busy = false;
}

void wait_ms(void*, uint32_t) {}

const char* read_temperature() {
  if (is_shown) {
    for (int32_t y = 0; y < 200; ++y) {
      for (int32_t x = 0; x < 200; ++x) {
        const int32_t bit = model.glass[y][x / 8] >> (7 - x % 8) & 1;
        screens[frame].pixels[y][x] = bit != 0 ? kWhite : 0;
      }
    }
    screens[frame].show("ssd1681", frame);
    modes[frame] = model.sequence;
    if (++frame >= kFirstRun) {
      example::stop();
    }
  }
  is_shown = true;
  return kValues[frame];
}

TEST(ssd1681_refreshes_a_value_alone) {
  example::run();
  CHECK_EQ(model.resets, 1);
  CHECK_EQ(model.refreshes, kFirstRun);
  model = epaper_model::EpaperModel(200, 200);
  is_shown = false;
  example::run();
  const Rect label = {10, 20, 200, 50};
  const Rect value = {10, 60, 200, 125};
  for (const auto& screen : screens) {
    const int32_t letters = screen.ink(label, kWhite);
    const int32_t digits = screen.ink(value, kWhite);
    CHECK(letters > 300);
    CHECK(digits > 2000);
    CHECK_EQ(letters + digits, screen.ink(kWhite));
  }
  CHECK(example::lies_in(screens[1].changes(screens[0]), value));
  CHECK(is_empty(screens[2].changes(screens[0])));
  CHECK(is_empty(screens[3].changes(screens[1])));
  CHECK_EQ(modes[0], 0xf7);  // full
  CHECK_EQ(modes[3], 0xf7);
  for (int32_t i = 1; i < kFirstRun; ++i) {
    CHECK_EQ(modes[i], 0xff);
    check::write_number(bytes_sent[i]);
    check::write(" bytes sent\n");
    CHECK(2 * bytes_sent[i] < bytes_sent[0]);
  }
}
