// A model of SSD1306 and SH1106: their commands, and what the glass shows.
#pragma once

#include "check.hpp"
#include "inkcell/port/display_bus.hpp"

namespace mono_model {

using inkcell::port::DisplayBus;

// Both controllers: a memory of pages, and the outputs that show it. SSD1306
// fills windows; SH1106 fills a page from a column on, and knows no windows.
struct MonoModel {
  bool windows = true;
  int32_t columns = 128;

  uint8_t memory[8][132] = {};
  int32_t first_column = 0, last_column = 127, column = 0;
  int32_t first_page = 0, last_page = 7, page = 0;
  int32_t multiplex = 64;
  uint8_t row_pins = 0, supply = 0, contrast = 127;
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
      case 0x81:
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
      case 0x81:
        contrast = c[1];
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

}  // namespace mono_model
