// SSD1306 and SH1106 against the model of their commands.
#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/port/i2c_display.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/sh1106.hpp"
#include "inkcell/port/ssd1306.hpp"
#include "mono_model.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;
using mono_model::MonoModel;

constexpr PixelFormat kFormat = PixelFormat::mono_pages;

struct Place {
  uint8_t width, height, first_column;
  bool turned;
  int32_t rows, gap;
};

// The glass, whose outputs begin at first_column, must show the picture;
// turned, the picture stands upside down on it.
void check_shown(const MonoModel& model,
                 const Strip& picture,
                 const Place& place) {
  CHECK(model.on);
  CHECK_EQ(model.multiplex, place.height);
  for (const auto [x, y] : pixels_of(place.width, place.height)) {
    const bool drawn =
        (picture.pixels[static_cast<size_t>(y / 8 * picture.stride + x)] >>
             (y % 8) &
         1) != 0;
    const int32_t s =
        place.first_column + (place.turned ? place.width - 1 - x : x);
    const int32_t r = place.turned ? place.height - 1 - y : y;
    CHECK_EQ(model.shown(s, r), drawn);
  }
}

// Draws the page through a driver and compares the glass with the core's
// picture.
template <typename Display>
void check_page(MonoModel& model, const Display& display, const Place& place) {
  const MonoPagesCanvas canvas;
  const Strip picture =
      display_page::reference(canvas, kFormat, place.width, place.height, 0);
  CHECK_OK(init(display));
  const Rect all = {0, 0, place.width, place.height};
  display_page::show_page(
      canvas, kFormat, all, place.rows, place.gap, 0,
      [&display](const Strip& strip) { return write(display, strip); });
  check_shown(model, picture, place);
}

TEST(ssd1306_shows_text) {
  constexpr Place kPlaces[] = {{128, 64, 0, false, 8, 0},
                               {128, 64, 0, true, 24, 0},
                               {128, 32, 0, true, 32, 5},
                               {72, 40, 28, false, 16, 3},
                               {72, 40, 30, true, 40, 0}};
  for (const Place& p : kPlaces) {
    MonoModel model(true);
    Ssd1306 display = {model.bus(), p.width, p.height, p.first_column,
                       p.turned};
    display.sequential_rows = p.height == 32;
    display.external_supply = p.height == 40;
    check_page(model, display, p);
    CHECK_EQ(model.resets, 1);
    CHECK_EQ(model.row_pins, p.height == 32 ? 0x02 : 0x12);
    CHECK_EQ(model.supply, p.height != 40 ? 0x14 : 0x10);
  }
}

TEST(sh1106_shows_text) {
  constexpr Place kPlaces[] = {{128, 64, 2, false, 8, 0},
                               {128, 64, 2, true, 64, 0},
                               {132, 64, 0, true, 24, 1},
                               {96, 32, 3, false, 16, 0},
                               {96, 32, 3, true, 16, 0}};
  for (const Place& p : kPlaces) {
    MonoModel model(false);
    const Sh1106 display = {model.bus(), p.width, p.height, p.first_column,
                            p.turned};
    check_page(model, display, p);
    CHECK_EQ(model.resets, 1);
    CHECK_EQ(model.supply, 0x8b);
  }
}

// Strips without gaps take one transfer, those with gaps one a page.
TEST(ssd1306_sends_a_strip_at_once) {
  MonoModel model(true);
  const Ssd1306 display = {model.bus()};
  CHECK_OK(init(display));
  uint8_t pixels[4 * 40] = {};
  CHECK_OK(write(display, {pixels, 16, 8, 40, 32, 40}));
  CHECK_EQ(model.transfers, 1);
  CHECK_OK(write(display, {pixels, 16, 8, 36, 32, 40}));
  CHECK_EQ(model.transfers, 5);
}

// A part of the screen: what is around it stays.
TEST(parts_are_replaced) {
  MonoModel window(true), page(false);
  const Ssd1306 ssd1306 = {window.bus(), 128, 64, 0, true};
  const Sh1106 sh1106 = {page.bus(), 128, 64, 2, true};
  const Place place = {128, 64, 0, true, 64, 0};
  check_page(window, ssd1306, place);
  check_page(page, sh1106, {128, 64, 2, true, 64, 0});
  uint8_t pixels[2 * 19];
  for (size_t i = 0; i < sizeof pixels; ++i) {
    pixels[i] = static_cast<uint8_t>(5 * i + 1);
  }
  const Strip part = {pixels, 77, 16, 19, 16, 19};
  CHECK_OK(write(ssd1306, part));
  CHECK_OK(write(sh1106, part));
  const Strip picture =
      display_page::reference(MonoPagesCanvas(), kFormat, 128, 64, 0);
  for (const auto [x, y] : pixels_of(19, 16)) {
    picture.pixels[static_cast<size_t>((2 + y / 8) * 128 + 77 + x)] =
        pixels[y / 8 * 19 + x];
  }
  check_shown(window, picture, place);
  check_shown(page, picture, {128, 64, 2, true, 64, 0});
}

template <typename Display>
void check_sleep_and_contrast(const MonoModel& model, const Display& display) {
  CHECK_OK(init(display));
  const int sent = model.resets + model.transfers;
  sleep(display);
  CHECK(!model.on);
  wake(display);
  CHECK(model.on);
  set_contrast(display, 207);
  CHECK_EQ(model.contrast, 207);
  CHECK_EQ(model.resets + model.transfers, sent);
}

TEST(panels_sleep_and_have_a_contrast) {
  MonoModel window(true);
  check_sleep_and_contrast(window, Ssd1306{window.bus()});
  MonoModel page(false);
  check_sleep_and_contrast(page, Sh1106{page.bus()});
}

// What an SSD1306 does with transfers: a control byte, then bytes of one kind.
struct I2cModel {
  MonoModel display{true};
  uint8_t address = 0;
  size_t longest = 0;

  static void write(void* context,
                    uint8_t address,
                    const uint8_t* bytes,
                    size_t count) {
    auto& model = *static_cast<I2cModel*>(context);
    model.address = address;
    model.longest = count > model.longest ? count : model.longest;
    CHECK(count >= 2);
    if (bytes[0] == 0x40) {
      MonoModel::data(&model.display, bytes + 1, count - 1);
    } else {
      CHECK_EQ(bytes[0], 0x00);
      MonoModel::command(&model.display, bytes + 1, count - 1);
    }
  }
};

TEST(i2c_shows_text) {
  I2cModel model;
  I2cDisplay i2c;
  i2c.context = &model;
  i2c.write = I2cModel::write;
  i2c.address = 0x3d;
  check_page(model.display, Ssd1306{make_bus(i2c), 128, 64, 0, true},
             {128, 64, 0, true, 24, 0});
  CHECK_EQ(model.address, 0x3d);
  CHECK_EQ(model.longest, kI2cTransfer);
}

template <typename Display>
void check_refused(const MonoModel& model, const Display& display) {
  uint8_t pixels[64] = {};
  CHECK_EQ(init(display), Status::bad_argument);
  CHECK_EQ(write(display, {pixels, 0, 0, 8, 8, 8}), Status::bad_argument);
  CHECK_EQ(model.resets + model.commands + model.transfers, 0);
}

TEST(displays_outside_the_memory_are_refused) {
  MonoModel model(true);
  const DisplayBus bus = model.bus();
  check_refused(model, Ssd1306{bus, 0, 64});
  check_refused(model, Ssd1306{bus, 129, 64});
  check_refused(model, Ssd1306{bus, 128, 64, 1});
  check_refused(model, Ssd1306{bus, 128, 72});
  check_refused(model, Ssd1306{bus, 128, 63});
  check_refused(model, Ssd1306{bus, 128, 8});
  check_refused(model, Sh1106{bus, 0, 64, 0});
  check_refused(model, Sh1106{bus, 133, 64, 0});
  check_refused(model, Sh1106{bus, 128, 64, 5});
  check_refused(model, Sh1106{bus, 128, 72, 2});
  check_refused(model, Sh1106{bus, 128, 12, 2});
  check_refused(model, Sh1106{bus, 128, 0, 2});
}

TEST(strips_outside_the_screen_are_refused) {
  MonoModel model(true);
  const DisplayBus bus = model.bus();
  uint8_t pixels[128] = {};
  const Strip wrong[] = {
      {pixels, 121, 0, 8, 8, 8}, {pixels, -1, 0, 8, 8, 8},
      {pixels, 0, 4, 8, 8, 8},   {pixels, 0, 0, 8, 12, 8},
      {pixels, 0, 64, 8, 8, 8},  {pixels, 0, 0, 8, 8, 7},
      {pixels, 0, 0, 0, 8, 8},   {pixels, 0x7fffffff, 0, 8, 8, 8}};
  for (const Strip& strip : wrong) {
    CHECK_EQ(write(Ssd1306{bus}, strip), Status::bad_argument);
    CHECK_EQ(write(Sh1106{bus}, strip), Status::bad_argument);
  }
  const Strip small = {{pixels, 15}, 0, 0, 8, 16, 8};
  CHECK_EQ(write(Ssd1306{bus}, small), Status::buffer_small);
  CHECK_EQ(write(Sh1106{bus}, small), Status::buffer_small);
  CHECK_EQ(model.commands + model.transfers, 0);
}

}  // namespace
