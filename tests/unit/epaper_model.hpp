// A model of SSD1680 and SSD1681: their commands, planes and the panel.
#pragma once

#include "check.hpp"
#include "inkcell/port/display_bus.hpp"
#include "pixels.hpp"

namespace epaper_model {

using inkcell::port::DisplayBus;

inline constexpr int32_t kStride = 25;  // of the largest plane [bytes]
inline constexpr int32_t kRows = 296;

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
    for (const auto [x, y] : pixels_of(columns, gates)) {
      const uint8_t next = planes[0][y][x];
      const uint8_t moved =
          full ? uint8_t{0xff} : static_cast<uint8_t>(next ^ planes[1][y][x]);
      glass[y][x] =
          static_cast<uint8_t>((glass[y][x] & ~moved) | (next & moved));
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

}  // namespace epaper_model
