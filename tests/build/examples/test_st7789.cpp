// The example st7789.cpp: three temperatures, the last one as the first; and
// the second one as the first of another run.
#include "colour_screen.hpp"
#include "your_board.h"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr uint32_t kPaper = example::rgb888(rgb565(0, 50, 90));
constexpr int32_t kFrames = 4;
constexpr int32_t kFirstRun = 3;
constexpr const char* kValues[] = {"21.5", "-9.8", "21.5", "-9.8"};

dcs_model::DcsModel model(240, 320);
example::Screen<240, 240> screens[kFrames];
int64_t pixels_sent[kFrames];
int32_t frame = 0;
bool is_shown = false;

// A transfer by DMA reads its bytes as late as it may.
const uint8_t* sent_late = nullptr;
size_t late_count = 0;

void end_transfer() {
  if (sent_late != nullptr) {
    model.data(&model, sent_late, late_count);
    sent_late = nullptr;
  }
}

}  // namespace

void write_command(void*, const uint8_t* bytes, size_t count) {
  end_transfer();
  model.command(&model, bytes, count);
}

void write_data(void*, const uint8_t* bytes, size_t count) {
  end_transfer();
  model.data(&model, bytes, count);
}

void start_data(void*, const uint8_t* bytes, size_t count) {
  end_transfer();
  sent_late = bytes;
  late_count = count;
}

void wait_sent(void*) {
  end_transfer();
}

void pulse_reset(void*) {
  ++model.resets;
}

void wait_ms(void*, uint32_t ms) {
  model.waited_ms += ms;
}

const char* read_temperature() {
  CHECK(sent_late == nullptr);
  if (is_shown) {
    DcsPanel panel;
    panel.width = panel.height = 240;
    example::read_screen(model, panel, screens[frame]);
    screens[frame].show("st7789", frame);
    pixels_sent[frame] = model.pixels;
    model.pixels = 0;
    if (++frame >= kFirstRun) {
      example::stop();
    }
  }
  is_shown = true;
  return kValues[frame];
}

TEST(st7789_shows_a_label_and_a_value) {
  example::run();
  CHECK_EQ(model.resets, 1);
  CHECK(model.inverted);
  model = dcs_model::DcsModel(240, 320);
  is_shown = false;
  example::run();
  const Rect label = {16, 20, 220, 60};
  const Rect value = {16, 80, 240, 155};
  for (const auto& screen : screens) {
    const int32_t letters = screen.ink(label, kPaper);
    const int32_t digits = screen.ink(value, kPaper);
    CHECK(letters > 800);
    CHECK(digits > 2000);
    CHECK_EQ(letters + digits, screen.ink(kPaper));
  }
  // The icon, and the second hanzi.
  CHECK(screens[0].ink({16, 20, 40, 60}, kPaper) > 80);
  CHECK(screens[0].ink({150, 20, 175, 60}, kPaper) > 80);
  CHECK(example::lies_in(screens[1].changes(screens[0]), value));
  CHECK(is_empty(screens[2].changes(screens[0])));
  CHECK(is_empty(screens[3].changes(screens[1])));
  CHECK_EQ(pixels_sent[0], 240 * 240);
  CHECK_EQ(pixels_sent[3], 240 * 240);
  for (int32_t i = 1; i < kFirstRun; ++i) {
    check::write_number(pixels_sent[i]);
    check::write(" pixels sent\n");
    CHECK(pixels_sent[i] < 240 * 240 / 4);
  }
}
