// SSD1680 and SSD1681 against a model of their command streams.
#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/ssd1680.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr PixelFormat kFormat = PixelFormat::mono_rows;
constexpr int32_t kStride = 25;  // of the largest plane [bytes]
constexpr int32_t kRows = 296;

// Two planes, the panel, and a busy line that each reset and refresh raises.
struct EpaperModel {
  uint8_t planes[2][kRows][kStride];  // next, shown
  uint8_t glass[kRows][kStride];
  int32_t columns, rows;  // of the memory; columns in bytes
  uint8_t command_byte = 0;
  int32_t parameter = 0;
  uint8_t first_column = 0, last_column = 0;
  int32_t row_range[2] = {}, column = 0, row = 0, gates = 0;
  uint8_t entry = 0, planes_read = 0, outputs = 0, sequence = 0, sensor = 0;
  bool busy = false, asleep = false;
  int resets = 0, transfers = 0, refreshes = 0;

  EpaperModel(int32_t width, int32_t height)
      : columns(width / 8), rows(height) {
    for (auto& plane : planes) {
      fill(plane, 0x5a);
    }
    fill(glass, 0x5a);
  }

  static void fill(uint8_t (&plane)[kRows][kStride], uint8_t value) {
    for (auto& line : plane) {
      for (uint8_t& byte : line) {
        byte = value;
      }
    }
  }

  DisplayBus bus() {
    DisplayBus bus = {this, command, data};
    bus.reset = [](void* context) {
      auto& model = *static_cast<EpaperModel*>(context);
      ++model.resets;
      model.asleep = false;
      model.busy = true;
    };
    bus.wait_idle = [](void* context) {
      static_cast<EpaperModel*>(context)->busy = false;
    };
    return bus;
  }

  static void command(void* context, const uint8_t* c, size_t count) {
    auto& model = *static_cast<EpaperModel*>(context);
    CHECK(!model.busy && !model.asleep);
    CHECK_EQ(count, 1);
    ++model.transfers;
    model.command_byte = c[0];
    model.parameter = 0;
    if (c[0] == 0x12) {
      model.busy = true;
    } else if (c[0] == 0x20) {
      model.refresh();
    }
  }

  static void data(void* context, const uint8_t* bytes, size_t count) {
    auto& model = *static_cast<EpaperModel*>(context);
    CHECK(!model.busy && !model.asleep);
    ++model.transfers;
    for (size_t i = 0; i < count; ++i) {
      model.put(bytes[i]);
    }
  }

  // Display mode 1 drives all pixels; mode 2 those that differ between planes.
  void refresh() {
    CHECK(sequence == 0xf7 || sequence == 0xff);
    CHECK_EQ(sensor, 0x80);
    const bool full = sequence == 0xf7;
    CHECK_EQ(planes_read, full ? 0x40 : 0x00);
    for (int32_t y = 0; y < gates; ++y) {
      for (int32_t x = 0; x < columns; ++x) {
        const uint8_t next = planes[0][y][x];
        const uint8_t moved =
            full ? uint8_t{0xff} : static_cast<uint8_t>(next ^ planes[1][y][x]);
        glass[y][x] =
            static_cast<uint8_t>((glass[y][x] & ~moved) | (next & moved));
      }
    }
    busy = true;
    ++refreshes;
  }

  void put_pixels(uint8_t byte) {
    CHECK_EQ(entry, 0x03);
    CHECK(column < columns && row < rows);
    if (column < columns && row < rows) {
      planes[command_byte == 0x24 ? 0 : 1][row][column] = byte;
    }
    if (++column > last_column) {
      column = first_column;
      row = row == row_range[1] ? row_range[0] : row + 1;
    }
  }

  void put(uint8_t byte) {
    const int32_t at = parameter++;
    const int32_t shift = 8 * (at % 2);
    switch (command_byte) {
      case 0x01:
        gates =
            at < 2 ? gates * (at == 0 ? 0 : 1) + (byte << shift) : gates + 1;
        CHECK(at < 2 || byte == 0);
        break;
      case 0x10:
        CHECK_EQ(byte, 0x01);
        asleep = true;
        break;
      case 0x11:
        entry = byte;
        break;
      case 0x18:
        sensor = byte;
        break;
      case 0x21:
        (at == 0 ? planes_read : outputs) = byte;
        break;
      case 0x22:
        sequence = byte;
        break;
      case 0x24:
      case 0x26:
        put_pixels(byte);
        break;
      case 0x44:
        (at == 0 ? first_column : last_column) = byte;
        break;
      case 0x45:
        row_range[at / 2 % 2] =
            shift == 0 ? byte : row_range[at / 2 % 2] | byte << 8;
        break;
      case 0x4e:
        column = byte;
        break;
      case 0x4f:
        row = shift == 0 ? byte : row | byte << 8;
        break;
      default:
        const bool is_command_with_parameters = false;
        CHECK(is_command_with_parameters);
    }
  }
};

MonoRowsCanvas make_canvas() {
  return MonoRowsCanvas({}, 0);
}

void send_page(const Ssd1680& display,
               EpaperPlane plane,
               const Rect& part,
               int32_t rows,
               int32_t gap) {
  display_page::show_page(make_canvas(), kFormat, part, rows, gap, 0xff,
                          [&display, plane](const Strip& strip) {
                            return write(display, strip, plane);
                          });
}

// `plane` must hold the picture within `part`, and `around` outside.
void check_plane(const uint8_t (&plane)[kRows][kStride],
                 const Strip& picture,
                 const Rect& part,
                 uint8_t around) {
  for (int32_t y = 0; y < kRows && !check::failed(); ++y) {
    for (int32_t x = 0; x < kStride; ++x) {
      const bool inside =
          8 * x >= part.x0 && 8 * x < part.x1 && y >= part.y0 && y < part.y1;
      const auto at = static_cast<size_t>(y * picture.stride + x);
      CHECK_EQ(plane[y][x], inside ? picture.pixels[at] : around);
    }
  }
}

struct Place {
  EpaperController controller;
  int32_t columns, rows;  // of the memory
  uint16_t width, height;
  int32_t strip_rows, gap;
};

TEST(a_full_refresh_shows_text) {
  constexpr Place kPlaces[] = {
      {EpaperController::ssd1680, 176, 296, 128, 296, 20, 0},
      {EpaperController::ssd1680, 176, 296, 176, 264, 264, 3},
      {EpaperController::ssd1681, 200, 200, 200, 200, 33, 0}};
  for (const Place& p : kPlaces) {
    EpaperModel model(p.columns, p.rows);
    Ssd1680 display = {model.bus(), p.controller, p.width, p.height};
    display.from_output_8 = p.width == 128;
    const Rect all = {0, 0, p.width, p.height};
    const Strip picture = display_page::reference(make_canvas(), kFormat,
                                                  p.width, p.height, 0xff);
    CHECK_OK(init(display));
    CHECK_EQ(model.gates, p.height);
    send_page(display, EpaperPlane::next, all, p.strip_rows, p.gap);
    check_plane(model.planes[0], picture, all, 0x5a);
    check_plane(model.planes[1], picture, {}, 0x5a);
    check_plane(model.glass, picture, {}, 0x5a);
    CHECK_OK(refresh(display, EpaperRefresh::full));
    CHECK_EQ(model.outputs, p.width == 128 ? 0x80 : 0x00);
    check_plane(model.glass, picture, all, 0x5a);
    CHECK_EQ(model.refreshes, 1);
    CHECK(!model.busy);
  }
}

// A white panel, then the words in a part of it.
TEST(a_partial_refresh_changes_its_rectangle_alone) {
  EpaperModel model(200, 200);
  const Ssd1680 display = {model.bus(), EpaperController::ssd1681, 200, 200};
  CHECK_OK(init(display));
  EpaperModel::fill(model.planes[0], 0xff);
  EpaperModel::fill(model.planes[1], 0xff);
  EpaperModel::fill(model.glass, 0xff);
  const Rect part = {16, 21, 120, 57};
  send_page(display, EpaperPlane::next, part, 10, 0);
  CHECK_OK(refresh(display, EpaperRefresh::partial));
  const Strip picture =
      display_page::reference(make_canvas(), kFormat, 200, 200, 0xff);
  check_plane(model.glass, picture, part, 0xff);
  // Now the panel shows the part; the next refresh starts from there.
  send_page(display, EpaperPlane::shown, part, 10, 0);
  check_plane(model.planes[1], picture, part, 0xff);
  for (uint8_t& byte : picture.pixels) {
    byte = 0xff;
  }
  CHECK_OK(write(display,
                 {picture.pixels, part.x0, part.y0, part.x1 - part.x0,
                  part.y1 - part.y0, picture.stride},
                 EpaperPlane::next));
  CHECK_OK(refresh(display, EpaperRefresh::partial));
  check_plane(model.glass, picture, {}, 0xff);
  CHECK_EQ(model.refreshes, 2);
}

TEST(a_reset_wakes_the_controller) {
  EpaperModel model(176, 296);
  Ssd1680 display = {model.bus()};
  CHECK_OK(init(display));
  CHECK_OK(sleep(display));
  CHECK(model.asleep);
  CHECK_OK(init(display));
  CHECK(!model.asleep);
  CHECK_EQ(model.resets, 2);
  // What nothing could wake is not put to sleep.
  display.bus.reset = nullptr;
  CHECK_EQ(sleep(display), Status::bad_argument);
  CHECK(!model.asleep);
}

TEST(displays_outside_the_memory_are_refused) {
  EpaperModel model(176, 296);
  const DisplayBus bus = model.bus();
  DisplayBus no_busy_line = bus;
  no_busy_line.wait_idle = nullptr;
  constexpr auto k1680 = EpaperController::ssd1680;
  constexpr auto k1681 = EpaperController::ssd1681;
  const Ssd1680 wrong[] = {{bus, k1680, 184, 296}, {bus, k1680, 176, 297},
                           {bus, k1680, 122, 250}, {bus, k1680, 0, 296},
                           {bus, k1680, 128, 0},   {bus, k1681, 208, 200},
                           {bus, k1681, 200, 201}, {bus, k1681, 200, 200, true},
                           {no_busy_line, k1680}};
  uint8_t pixels[8] = {};
  for (const Ssd1680& display : wrong) {
    CHECK_EQ(init(display), Status::bad_argument);
    CHECK_EQ(write(display, {pixels, 0, 0, 8, 8, 1}, EpaperPlane::next),
             Status::bad_argument);
    CHECK_EQ(refresh(display, EpaperRefresh::full), Status::bad_argument);
    CHECK_EQ(sleep(display), Status::bad_argument);
  }
  CHECK_EQ(model.transfers + model.resets, 0);
}

TEST(strips_outside_the_screen_are_refused) {
  EpaperModel model(176, 296);
  const Ssd1680 display = {model.bus()};
  uint8_t pixels[32] = {};
  const Strip wrong[] = {{pixels, 4, 0, 8, 8, 1},   {pixels, 0, 0, 12, 8, 2},
                         {pixels, 128, 0, 8, 8, 1}, {pixels, 0, 289, 8, 8, 1},
                         {pixels, -8, 0, 8, 8, 1},  {pixels, 0, 0, 16, 8, 1},
                         {pixels, 0, 0, 0, 8, 1}};
  for (const Strip& strip : wrong) {
    CHECK_EQ(write(display, strip, EpaperPlane::shown), Status::bad_argument);
  }
  CHECK_EQ(write(display, {{pixels, 7}, 0, 0, 8, 8, 1}, EpaperPlane::next),
           Status::buffer_small);
  CHECK_EQ(model.transfers, 0);
}

}  // namespace
