// SSD1306 and SH1106 against a model of their command streams.
#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/port/i2c_display.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/sh1106.hpp"
#include "inkcell/port/ssd1306.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr PixelFormat kFormat = PixelFormat::mono_pages;

// Both controllers: a memory of pages, and the outputs that show it. SSD1306
// fills windows; SH1106 fills a page from a column on, and knows no windows.
struct MonoModel {
  bool windows = true;
  int32_t columns = 128;

  uint8_t memory[8][132] = {};
  int32_t first_column = 0, last_column = 127, column = 0;
  int32_t first_page = 0, last_page = 7, page = 0;
  int32_t multiplex = 64;
  uint8_t row_pins = 0, supply = 0;
  bool reverse_segments = false, reverse_rows = false, on = false;
  bool horizontal = false;
  int resets = 0, commands = 0, transfers = 0;

  explicit MonoModel(bool has_windows)
      : windows(has_windows), columns(has_windows ? 128 : 132) {}

  DisplayBus bus() {
    DisplayBus bus = {this, command, data};
    bus.reset = [](void* context) {
      ++static_cast<MonoModel*>(context)->resets;
    };
    return bus;
  }

  // How many bytes follow a command. -1: there is no such command.
  int32_t parameters(uint8_t c) const {
    if (c >= 0xb0 && c <= 0xb7) {
      return windows ? -1 : 0;
    }
    if (c < 0x20) {
      return windows ? -1 : 0;
    }
    switch (c) {
      case 0x20:
        return windows ? 1 : -1;
      case 0x21:
      case 0x22:
        return windows ? 2 : -1;
      case 0x8d:
        return windows ? 1 : -1;
      case 0xad:
        return windows ? -1 : 1;
      case 0xa8:
      case 0xd3:
      case 0xda:
        return 1;
      case 0x40:
      case 0xa0:
      case 0xa1:
      case 0xa4:
      case 0xa6:
      case 0xae:
      case 0xaf:
      case 0xc0:
      case 0xc8:
        return 0;
      default:
        return -1;
    }
  }

  void run(const uint8_t* c) {
    switch (c[0]) {
      case 0x20:
        horizontal = c[1] == 0;
        break;
      case 0x21:
        CHECK(c[1] <= c[2] && c[2] < columns);
        column = first_column = c[1];
        last_column = c[2];
        break;
      case 0x22:
        CHECK(c[1] <= c[2] && c[2] < 8);
        page = first_page = c[1];
        last_page = c[2];
        break;
      case 0x8d:
      case 0xad:
        supply = c[1];
        break;
      case 0xa0:
      case 0xa1:
        reverse_segments = c[0] == 0xa1;
        break;
      case 0xa8:
        multiplex = c[1] + 1;
        break;
      case 0xae:
      case 0xaf:
        on = c[0] == 0xaf;
        break;
      case 0xc0:
      case 0xc8:
        reverse_rows = c[0] == 0xc8;
        break;
      case 0xd3:
        CHECK_EQ(c[1], 0);
        break;
      case 0xda:
        row_pins = c[1];
        break;
      default:
        run_page_command(c[0]);
    }
  }

  void run_page_command(uint8_t c) {
    if (c >= 0xb0 && c <= 0xb7) {
      page = c & 7;
    } else if (c < 0x10) {
      column = (column & 0xf0) | c;
    } else if (c < 0x20) {
      column = (column & 0x0f) | (c & 15) << 4;
    }
  }

  void put(uint8_t byte) {
    CHECK(page < 8 && column < columns);
    if (page >= 8 || column >= columns) {
      return;
    }
    memory[page][column++] = byte;
    if (windows && column > last_column) {
      CHECK(horizontal);
      column = first_column;
      page = page == last_page ? first_page : page + 1;
    }
  }

  static void command(void* context, const uint8_t* c, size_t count) {
    auto& model = *static_cast<MonoModel*>(context);
    ++model.commands;
    for (size_t i = 0; i < count;) {
      const int32_t follow = model.parameters(c[i]);
      CHECK(follow >= 0 && i + 1 + static_cast<size_t>(follow) <= count);
      if (follow < 0) {
        return;
      }
      model.run(c + i);
      i += 1 + static_cast<size_t>(follow);
    }
  }

  static void data(void* context, const uint8_t* bytes, size_t count) {
    auto& model = *static_cast<MonoModel*>(context);
    ++model.transfers;
    for (size_t i = 0; i < count; ++i) {
      model.put(bytes[i]);
    }
  }

  // The pixel that the glass shows at segment output `s` and row output `r`.
  bool shown(int32_t s, int32_t r) const {
    const int32_t x = reverse_segments ? columns - 1 - s : s;
    const int32_t y = reverse_rows ? multiplex - 1 - r : r;
    return (memory[y / 8][x] >> (y % 8) & 1) != 0;
  }
};

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
  for (int32_t y = 0; y < place.height && !check::failed(); ++y) {
    for (int32_t x = 0; x < place.width; ++x) {
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
    display.charge_pump = p.height != 40;
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
  for (int32_t y = 0; y < 16; ++y) {
    for (int32_t x = 0; x < 19; ++x) {
      picture.pixels[static_cast<size_t>((2 + y / 8) * 128 + 77 + x)] =
          pixels[y / 8 * 19 + x];
    }
  }
  check_shown(window, picture, place);
  check_shown(page, picture, {128, 64, 2, true, 64, 0});
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
