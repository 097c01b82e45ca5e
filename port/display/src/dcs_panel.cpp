// MIPI DCS commands that the drivers of colour panels share.
#include "inkcell/port/dcs_panel.hpp"

#include "bounds.hpp"
#include "send_command.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace detail {
namespace {

enum Command : uint8_t {
  kReset = 0x01,
  kSleepIn = 0x10,
  kSleepOut = 0x11,
  kNormalMode = 0x13,
  kInversionOff = 0x20,
  kInversionOn = 0x21,
  kDisplayOff = 0x28,
  kDisplayOn = 0x29,
  kSetColumns = 0x2a,  // first, last; 16 bits each, high byte first
  kSetRows = 0x2b,     // likewise
  kWriteMemory = 0x2c,
  kSetAccess = 0x36,       // AccessBit
  kSetPixelFormat = 0x3a,  // bits a pixel
  kSetBrightness = 0x51,   // of the backlight
  kSetBacklight = 0x53,    // BacklightBit
};

// MADCTL maps addresses of the host to addresses of the memory: kExchange swaps
// columns and rows, then the others mirror them.
enum AccessBit : uint8_t {
  kMirrorRows = 0x80,
  kMirrorColumns = 0x40,
  kExchange = 0x20,
  kBlueFirst = 0x08,
};

enum BacklightBit : uint8_t { kControlled = 0x20, kLit = 0x04 };

// The longest wait in the data sheets before any command, after a reset and
// after entering or leaving sleep. [ms]
constexpr uint32_t kWaitMs = 120;

// MADCTL and the panel's origin in addresses of the host, turned by k quarters:
// the panel's column is mirrored for k = 1 and 2, its row for k = 2 and 3.
struct Addressing {
  uint8_t bits;
  int32_t x;  // of the screen's left column [px]
  int32_t y;
};

Addressing addressing_of(const DcsPanel& panel,
                         const DcsController& controller) noexcept {
  const uint32_t quarters = static_cast<uint32_t>(panel.rotation) & 3;
  const bool exchange = (quarters & 1) != 0;
  const bool columns = panel.mirror_columns != (quarters == 1 || quarters == 2);
  const bool rows = panel.mirror_rows != (quarters >= 2);
  // Mirrored addresses count from the other end of the memory.
  const int32_t column =
      columns ? controller.columns - panel.first_column - panel.width
              : panel.first_column;
  const int32_t row =
      rows ? controller.rows - panel.first_row - panel.height : panel.first_row;
  const int32_t bits =
      (rows ? kMirrorRows : 0) | (columns ? kMirrorColumns : 0) |
      (exchange ? kExchange : 0) | (panel.blue_first ? kBlueFirst : 0);
  return {static_cast<uint8_t>(bits), exchange ? row : column,
          exchange ? column : row};
}

Status check(const DcsPanel& panel, const DcsController& controller) noexcept {
  return panel.width == 0 || panel.height == 0 ||
                 panel.first_column + panel.width > controller.columns ||
                 panel.first_row + panel.height > controller.rows
             ? Status::bad_argument
             : Status::ok;
}

// Whether each command of `setup` has its parameters.
bool is_complete(Span<const uint8_t> setup) noexcept {
  size_t at = 0;
  while (setup.size - at >= 2) {
    const size_t end = at + 2 + setup[at + 1];
    if (end > setup.size) {
      return false;
    }
    at = end;
  }
  return at == setup.size;
}

void send_range(const DisplayBus& bus,
                uint8_t command,
                int32_t first,
                int32_t count) noexcept {
  const int32_t last = first + count - 1;
  const uint8_t range[] = {
      static_cast<uint8_t>(first >> 8), static_cast<uint8_t>(first),
      static_cast<uint8_t>(last >> 8), static_cast<uint8_t>(last)};
  send_command(bus, command, range);
}

}  // namespace

Status init(const DcsPanel& panel, const DcsController& controller) noexcept {
  const DisplayBus& bus = panel.bus;
  INKCELL_TRY(check(panel, controller));
  if (bus.wait_ms == nullptr || !is_complete(panel.setup)) {
    return Status::bad_argument;
  }
  if (bus.reset != nullptr) {
    bus.reset(bus.context);
  }
  send_command(bus, kReset);
  bus.wait_ms(bus.context, kWaitMs);
  for (size_t at = 0; at < panel.setup.size;) {
    const size_t count = panel.setup[at + 1];
    send_command(bus, panel.setup[at], {panel.setup.data + at + 2, count});
    at += 2 + count;
  }
  send_command(bus, kSleepOut);
  bus.wait_ms(bus.context, kWaitMs);
  const uint8_t format[] = {controller.pixel_format};
  send_command(bus, kSetPixelFormat, format);
  const uint8_t access[] = {addressing_of(panel, controller).bits};
  send_command(bus, kSetAccess, access);
  send_command(bus, panel.inverted ? kInversionOn : kInversionOff);
  send_command(bus, kNormalMode);
  send_command(bus, kDisplayOn);
  return Status::ok;
}

Status write(const DcsPanel& panel,
             const DcsController& controller,
             const Strip& strip) noexcept {
  INKCELL_TRY(check(panel, controller));
  INKCELL_TRY(check_on_screen(strip, DcsPanel::kFormat, screen_width(panel),
                              screen_height(panel)));
  if (strip.order != ByteOrder::high_first) {
    return Status::bad_argument;
  }
  const Addressing screen = addressing_of(panel, controller);
  send_range(panel.bus, kSetColumns, screen.x + strip.x0, strip.width);
  send_range(panel.bus, kSetRows, screen.y + strip.y0, strip.height);
  send_command(panel.bus, kWriteMemory);
  send_pixels(panel.bus, strip, DcsPanel::kFormat);
  return Status::ok;
}

}  // namespace detail

Status sleep(const DcsPanel& panel) noexcept {
  if (panel.bus.wait_ms == nullptr) {
    return Status::bad_argument;
  }
  send_command(panel.bus, detail::kDisplayOff);
  send_command(panel.bus, detail::kSleepIn);
  panel.bus.wait_ms(panel.bus.context, detail::kWaitMs);
  return Status::ok;
}

Status wake(const DcsPanel& panel) noexcept {
  if (panel.bus.wait_ms == nullptr) {
    return Status::bad_argument;
  }
  send_command(panel.bus, detail::kSleepOut);
  panel.bus.wait_ms(panel.bus.context, detail::kWaitMs);
  send_command(panel.bus, detail::kDisplayOn);
  return Status::ok;
}

void set_brightness(const DcsPanel& panel, uint8_t brightness) noexcept {
  const uint8_t level[] = {brightness};
  send_command(panel.bus, detail::kSetBrightness, level);
  const uint8_t control[] = {detail::kControlled | detail::kLit};
  send_command(panel.bus, detail::kSetBacklight, control);
}

}  // namespace inkcell::port
