// A model of colour controllers with MIPI DCS commands, and what a panel shows.
#pragma once

#include "check.hpp"
#include "display_page.hpp"
#include "inkcell/port/dcs_panel.hpp"
#include "inkcell/port/rgb565.hpp"
#include "pixels.hpp"

namespace dcs_model {

using namespace inkcell;
using namespace inkcell::port;

inline constexpr PixelFormat kFormat = PixelFormat::rgb565;
inline constexpr uint16_t kNever = 0x0bad;  // of memory that nobody wrote

inline uint16_t memory[320 * 240];

// A controller of `columns` x `rows`: a byte of command, its parameters as
// data, and pixels that go through MADCTL into the memory.
struct DcsModel {
  int32_t columns, rows;
  uint8_t command_byte = 0;
  int32_t parameter = 0;
  int32_t range[2][2] = {};  // of addresses: first and last column, row
  int32_t x = 0, y = 0;
  uint8_t access = 0, pixel_format = 0, high = 0;
  bool awake = false, on = false, inverted = false, normal = false;
  uint8_t brightness = 0, backlight = 0;
  uint32_t waited_ms = 0;
  int resets = 0, transfers = 0;
  int64_t pixels = 0;
  // Commands that the model does not know: the panel maker's.
  uint8_t setup[16] = {};
  size_t setup_bytes = 0;

  DcsModel(int32_t width, int32_t height) : columns(width), rows(height) {
    for (uint16_t& pixel : memory) {
      pixel = kNever;
    }
  }

  DisplayBus bus() {
    DisplayBus bus = {this, command, data};
    bus.reset = [](void* context) {
      ++static_cast<DcsModel*>(context)->resets;
    };
    bus.wait_ms = [](void* context, uint32_t ms) {
      static_cast<DcsModel*>(context)->waited_ms += ms;
    };
    return bus;
  }

  void note(uint8_t byte) {
    CHECK(!awake && setup_bytes < sizeof setup);
    setup[setup_bytes++ % sizeof setup] = byte;
  }

  static void command(void* context, const uint8_t* c, size_t count) {
    auto& model = *static_cast<DcsModel*>(context);
    CHECK_EQ(count, 1);
    ++model.transfers;
    model.command_byte = c[0];
    model.parameter = 0;
    switch (c[0]) {
      case 0x01:
        model.awake = model.on = false;
        model.waited_ms = 0;
        break;
      case 0x10:
        CHECK(!model.on);
        model.awake = false;
        model.waited_ms = 0;
        break;
      case 0x11:
        CHECK(model.waited_ms >= 120);
        model.awake = true;
        model.waited_ms = 0;
        break;
      case 0x13:
        model.normal = true;
        break;
      case 0x20:
      case 0x21:
        model.inverted = c[0] == 0x21;
        break;
      case 0x28:
        model.on = false;
        break;
      case 0x29:
        CHECK(model.awake && model.waited_ms >= 120);
        model.on = true;
        break;
      case 0x2c:
        model.x = model.range[0][0];
        model.y = model.range[1][0];
        break;
      case 0x2a:
      case 0x2b:
      case 0x36:
      case 0x3a:
      case 0x51:
      case 0x53:
        break;
      default:
        model.note(c[0]);
    }
  }

  static void data(void* context, const uint8_t* bytes, size_t count) {
    auto& model = *static_cast<DcsModel*>(context);
    ++model.transfers;
    for (size_t i = 0; i < count; ++i) {
      model.put(bytes[i]);
    }
  }

  void put(uint8_t byte) {
    const int32_t at = parameter++;
    if (command_byte == 0x2a || command_byte == 0x2b) {
      CHECK(at < 4);
      int32_t& limit = range[command_byte - 0x2a][at / 2 % 2];
      limit = at % 2 == 0 ? byte << 8 : limit | byte;
    } else if (command_byte == 0x36) {
      access = byte;
    } else if (command_byte == 0x3a) {
      pixel_format = byte;
    } else if (command_byte == 0x51) {
      brightness = byte;
    } else if (command_byte == 0x53) {
      backlight = byte;
    } else if (command_byte == 0x2c) {
      if (at % 2 == 0) {
        high = byte;
      } else {
        put_pixel(static_cast<uint16_t>(high << 8 | byte));
      }
    } else {
      note(byte);
    }
  }

  // MV exchanges the pointers; MX and MY then mirror those of the memory.
  void put_pixel(uint16_t pixel) {
    const bool exchange = (access & 0x20) != 0;
    int32_t column = exchange ? y : x;
    int32_t row = exchange ? x : y;
    CHECK(column < columns && row < rows);
    if (column >= columns || row >= rows) {
      return;
    }
    column = (access & 0x40) != 0 ? columns - 1 - column : column;
    row = (access & 0x80) != 0 ? rows - 1 - row : row;
    memory[row * columns + column] = pixel;
    ++pixels;
    if (++x > range[0][1]) {
      x = range[0][0];
      y = y == range[1][1] ? range[1][0] : y + 1;
    }
  }
};

// The panel's pixel that shows (x, y) of a screen turned clockwise: rows of the
// screen go from the panel's right column to its left one after a quarter.
struct PanelPoint {
  int32_t x, y;
};
inline PanelPoint turned(const DcsPanel& panel, int32_t x, int32_t y) {
  switch (panel.rotation) {
    case Rotation::quarter:
      return {panel.width - 1 - y, x};
    case Rotation::half:
      return {panel.width - 1 - x, panel.height - 1 - y};
    case Rotation::three_quarters:
      return {y, panel.height - 1 - x};
    default:
      return {x, y};
  }
}

inline uint16_t pixel_of(const Strip& picture, int32_t x, int32_t y) {
  const uint8_t* const bytes = picture.pixels.data + y * picture.stride + 2 * x;
  return static_cast<uint16_t>(bytes[0] << 8 | bytes[1]);
}

// The memory that a panel pixel shows.
inline uint16_t shown(const DcsModel& model,
                      const DcsPanel& panel,
                      PanelPoint at) {
  const int32_t column = panel.first_column +
                         (panel.mirror_columns ? panel.width - 1 - at.x : at.x);
  const int32_t row =
      panel.first_row + (panel.mirror_rows ? panel.height - 1 - at.y : at.y);
  return memory[row * model.columns + column];
}

// The panel must show the picture, where `is_drawn(x, y)`; the rest of the
// memory must be untouched.
template <typename IsDrawn>
void check_shown(const DcsModel& model,
                 const DcsPanel& panel,
                 const Strip& picture,
                 const IsDrawn& is_drawn) {
  int64_t drawn = 0;
  for (const auto [x, y] : pixels_of(picture.width, picture.height)) {
    const bool in = is_drawn(x, y);
    drawn += in ? 1 : 0;
    CHECK_EQ(shown(model, panel, turned(panel, x, y)),
             in ? pixel_of(picture, x, y) : kNever);
  }
  int64_t written = 0;
  for (int32_t i = 0; i < model.columns * model.rows; ++i) {
    written += memory[i] != kNever ? 1 : 0;
  }
  CHECK_EQ(written, drawn);
}

inline void check_shown(const DcsModel& model,
                        const DcsPanel& panel,
                        const Strip& picture,
                        const Rect& part) {
  check_shown(model, panel, picture,
              [&part](int32_t x, int32_t y) { return holds(part, x, y); });
}

inline constexpr auto kAll = [](int32_t, int32_t) { return true; };

template <typename Display>
Display make_display(DcsModel& model,
                     uint16_t width,
                     uint16_t height,
                     uint16_t column = 0,
                     uint16_t row = 0) {
  Display display;
  display.bus = model.bus();
  display.width = width;
  display.height = height;
  display.first_column = column;
  display.first_row = row;
  return display;
}

inline Rgb565Canvas make_canvas() {
  Strip strip;
  strip.order = ByteOrder::high_first;
  return Rgb565Canvas(strip, rgb565(0xff, 0x80, 0x20));
}

}  // namespace dcs_model
