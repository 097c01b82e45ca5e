// ST7735, ST7789, ILI9341 and GC9A01 against a model of MIPI DCS commands.
#include "check.hpp"
#include "dcs_model.hpp"
#include "display_page.hpp"
#include "inkcell/port/gc9a01.hpp"
#include "inkcell/port/ili9341.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/st7735.hpp"
#include "inkcell/port/st7789.hpp"

namespace {

using namespace dcs_model;

// Draws the page through a driver and compares the panel with the core's
// picture.
template <typename Display>
void check_page(DcsModel& model,
                const Display& display,
                int32_t rows,
                int32_t gap) {
  const DcsPanel& panel = display;
  const Rect all = {0, 0, screen_width(panel), screen_height(panel)};
  CHECK_OK(init(display));
  CHECK(model.on && model.normal);
  CHECK_EQ(model.inverted, panel.inverted);
  CHECK_EQ(model.pixel_format & 7, 5);
  CHECK_EQ((model.access & 0x08) != 0, panel.blue_first);
  CHECK_EQ(model.resets, 1);
  const Rgb565Canvas canvas = make_canvas();
  display_page::show_page(
      canvas, kFormat, all, rows, gap, 0x10,
      [&display](const Strip& strip) { return write(display, strip); });
  const Strip picture =
      display_page::reference(canvas, kFormat, all.x1, all.y1, 0x10);
  check_shown(model, panel, picture, kAll);
}

constexpr Rotation kRotations[] = {Rotation::none, Rotation::quarter,
                                   Rotation::half, Rotation::three_quarters};

TEST(st7735_shows_text_at_offsets) {
  for (const Rotation rotation : kRotations) {
    for (const bool mirrored : each_of({false, true})) {
      DcsModel model(132, 162);
      auto display = make_display<St7735>(model, 80, 160, 24, 1);
      display.rotation = rotation;
      display.mirror_columns = mirrored;
      display.blue_first = mirrored;
      display.inverted = true;
      check_page(model, display, 40, 2);
    }
  }
}

TEST(st7735_has_a_small_memory_by_pins) {
  DcsModel model(128, 160);
  auto display = make_display<St7735>(model, 128, 160);
  display.rotation = Rotation::half;
  display.gm_011 = true;
  check_page(model, display, 160, 0);
}

TEST(st7789_shows_text_at_offsets) {
  for (const Rotation rotation : kRotations) {
    DcsModel model(240, 320);
    auto display = make_display<St7789>(model, 135, 240, 52, 40);
    display.rotation = rotation;
    check_page(model, display, 64, 0);
  }
}

TEST(ili9341_shows_text_mirrored) {
  for (const Rotation rotation : kRotations) {
    for (const bool mirrored : each_of({false, true})) {
      DcsModel model(240, 320);
      auto display = make_display<Ili9341>(model, 240, 320);
      display.rotation = rotation;
      display.mirror_columns = true;
      display.mirror_rows = mirrored;
      check_page(model, display, 100, 0);
    }
  }
}

// Strips are one window each: any height gives the same picture.
TEST(strips_of_any_height_show_the_same) {
  for (const int32_t rows : each_of({1, 7, 160})) {
    DcsModel model(132, 162);
    check_page(model, make_display<St7735>(model, 128, 160, 2, 1), rows, 0);
  }
}

TEST(windows_have_their_own_place) {
  for (const Rotation rotation : kRotations) {
    DcsModel model(240, 320);
    auto display = make_display<St7789>(model, 240, 240);
    display.rotation = rotation;
    CHECK_OK(init(display));
    const Rect part = {31, 57, 140, 190};
    const Rgb565Canvas canvas = make_canvas();
    display_page::show_page(
        canvas, kFormat, part, 30, 0, 0,
        [&display](const Strip& strip) { return write(display, strip); });
    const Strip picture = display_page::reference(canvas, kFormat, 240, 240, 0);
    check_shown(model, display, picture, part);
  }
}

TEST(setup_is_sent_before_the_controller_wakes) {
  constexpr uint8_t kSetup[] = {0xb1, 2, 0x00, 0x18, 0xfe, 0, 0xf2, 1, 0x00};
  constexpr uint8_t kSent[] = {0xb1, 0x00, 0x18, 0xfe, 0xf2, 0x00};
  DcsModel model(240, 320);
  auto display = make_display<Ili9341>(model, 240, 320);
  display.setup = kSetup;
  CHECK_OK(init(display));
  CHECK_EQ(model.setup_bytes, sizeof kSent);
  for (size_t i = 0; i < sizeof kSent; ++i) {
    CHECK_EQ(model.setup[i], kSent[i]);
  }
  // Nothing of a list that ends within a command.
  model.transfers = model.resets = 0;
  constexpr size_t kCut[] = {1, 2, 3, 5, 8};
  for (const size_t size : kCut) {
    display.setup = {kSetup, size};
    CHECK_EQ(init(display), Status::bad_argument);
  }
  CHECK_EQ(model.transfers + model.resets, 0);
}

TEST(panels_sleep_and_wake_with_their_picture) {
  DcsModel model(240, 320);
  auto display = make_display<St7789>(model, 240, 320);
  check_page(model, display, 100, 0);
  const int64_t pixels = model.pixels;
  for (int i = 0; i < 2; ++i) {
    CHECK_OK(sleep(display));
    CHECK(!model.on && !model.awake);
    CHECK(model.waited_ms >= 5);
    CHECK_OK(wake(display));
    CHECK(model.on && model.awake);
  }
  CHECK_EQ(model.pixels, pixels);
  CHECK_EQ(model.resets, 1);
  set_brightness(display, 99);
  CHECK_EQ(model.brightness, 99);
  CHECK_EQ(model.backlight & 0x24, 0x24);
  model.transfers = 0;
  display.bus.wait_ms = nullptr;
  CHECK_EQ(sleep(display), Status::bad_argument);
  CHECK_EQ(wake(display), Status::bad_argument);
  CHECK_EQ(model.transfers, 0);
}

template <typename Display>
void check_refused(DcsModel& model, const Display& display) {
  uint8_t pixels[64] = {};
  model.transfers = model.resets = 0;
  CHECK_EQ(init(display), Status::bad_argument);
  CHECK_EQ(write(display, {pixels, 0, 0, 4, 4, 8, ByteOrder::high_first}),
           Status::bad_argument);
  CHECK_EQ(model.transfers + model.resets, 0);
}

TEST(panels_outside_the_memory_are_refused) {
  DcsModel model(240, 320);
  check_refused(model, make_display<St7735>(model, 133, 160));
  check_refused(model, make_display<St7735>(model, 128, 160, 5));
  check_refused(model, make_display<St7735>(model, 128, 160, 0, 3));
  check_refused(model, make_display<St7789>(model, 241, 320));
  check_refused(model, make_display<St7789>(model, 240, 240, 0, 81));
  check_refused(model, make_display<Ili9341>(model, 0, 320));
  check_refused(model, make_display<Ili9341>(model, 240, 0));
  check_refused(model,
                make_display<Ili9341>(model, 65535, 65535, 65535, 65535));
  check_refused(model, make_display<Gc9a01>(model, 240, 241));
  auto display = make_display<Gc9a01>(model, 240, 240);
  display.bus.wait_ms = nullptr;
  CHECK_EQ(init(display), Status::bad_argument);
  CHECK_EQ(model.transfers, 0);
}

TEST(strips_outside_the_screen_are_refused) {
  DcsModel model(240, 320);
  auto display = make_display<St7789>(model, 100, 40);
  display.rotation = Rotation::quarter;
  uint8_t pixels[128] = {};
  const Strip wrong[] = {{pixels, 37, 0, 4, 4, 8}, {pixels, 0, 97, 4, 4, 8},
                         {pixels, -1, 0, 4, 4, 8}, {pixels, 0, -1, 4, 4, 8},
                         {pixels, 0, 0, 0, 4, 8},  {pixels, 0, 0, 4, 0, 8},
                         {pixels, 0, 0, 4, 4, 7},  {pixels, 0, 0, -4, 4, 8}};
  for (Strip strip : wrong) {
    strip.order = ByteOrder::high_first;
    CHECK_EQ(write(display, strip), Status::bad_argument);
  }
  Strip strip = {{pixels, 31}, 0, 0, 4, 4, 8, ByteOrder::high_first};
  CHECK_EQ(write(display, strip), Status::buffer_small);
  // Its colours would be wrong.
  strip = {{pixels, 32}, 36, 96, 4, 4, 8, ByteOrder::low_first};
  CHECK_EQ(write(display, strip), Status::bad_argument);
  CHECK_EQ(model.transfers, 0);
  strip.order = ByteOrder::high_first;
  CHECK_OK(write(display, strip));
}

}  // namespace
