// The commands of SSD1680 and SSD1681, and strips sent as windows of a plane.
#include "inkcell/port/ssd1680.hpp"

#include "bounds.hpp"
#include "send_command.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace ssd1680 {
namespace {

enum Command : uint8_t {
  kSetGates = 0x01,      // rows - 1, low byte first; scan order
  kDeepSleep = 0x10,     // mode
  kSetDataEntry = 0x11,  // direction of both counters
  kReset = 0x12,
  kSetSensor = 0x18,    // of the temperature
  kActivate = 0x20,     // as set by kSetSequence
  kSetPlanes = 0x21,    // how both planes are read; source outputs
  kSetSequence = 0x22,  // of kActivate
  kWriteNext = 0x24,    // pixels
  kWriteShown = 0x26,   // pixels
  kSetColumns = 0x44,   // first, last [8 px]
  kSetRows = 0x45,      // first, last; 16 bits each, low byte first
  kSetColumn = 0x4e,    // [8 px]
  kSetRow = 0x4f,       // 16 bits, low byte first
};

// Parameters.
constexpr uint8_t kKeepMemory = 0x01;
constexpr uint8_t kRightThenDown = 0x03;
constexpr uint8_t kInternalSensor = 0x80;
constexpr uint8_t kShownAsZeros = 0x40;
constexpr uint8_t kBothPlanes = 0x00;
constexpr uint8_t kFromOutput8 = 0x80;
// Clock, supply and temperature on, display mode 1 or 2, then all off.
constexpr uint8_t kDisplayFull = 0xf7;
constexpr uint8_t kDisplayPartial = 0xff;

Status check(const Ssd1680& display) noexcept {
  const bool first = display.controller == EpaperController::ssd1680;
  const int32_t columns = first ? 176 : 200;  // of a plane [px]
  const int32_t rows = first ? 296 : 200;
  return display.width == 0 || display.width > columns ||
                 display.width % 8 != 0 || display.height == 0 ||
                 display.height > rows || (display.from_output_8 && !first) ||
                 display.bus.wait_idle == nullptr
             ? Status::bad_argument
             : Status::ok;
}

void send_byte(const DisplayBus& bus,
               uint8_t command,
               int32_t parameter) noexcept {
  const uint8_t byte[] = {static_cast<uint8_t>(parameter)};
  send_command(bus, command, byte);
}

}  // namespace
}  // namespace ssd1680

Status init(const Ssd1680& display) noexcept {
  using namespace ssd1680;
  const DisplayBus& bus = display.bus;
  INKCELL_TRY(check(display));
  if (bus.reset != nullptr) {
    bus.reset(bus.context);
  }
  bus.wait_idle(bus.context);
  send_command(bus, kReset);
  bus.wait_idle(bus.context);
  const int32_t last = display.height - 1;
  const uint8_t gates[] = {static_cast<uint8_t>(last),
                           static_cast<uint8_t>(last >> 8), 0};
  send_command(bus, kSetGates, gates);
  send_byte(bus, kSetDataEntry, kRightThenDown);
  send_byte(bus, kSetSensor, kInternalSensor);
  return Status::ok;
}

Status write(const Ssd1680& display,
             const Strip& strip,
             EpaperPlane plane) noexcept {
  using namespace ssd1680;
  const DisplayBus& bus = display.bus;
  INKCELL_TRY(check(display));
  INKCELL_TRY(
      check_on_screen(strip, Ssd1680::kFormat, display.width, display.height));
  const int32_t bottom = strip.y0 + strip.height - 1;
  const uint8_t columns[] = {
      static_cast<uint8_t>(strip.x0 / 8),
      static_cast<uint8_t>((strip.x0 + strip.width) / 8 - 1)};
  const uint8_t rows[] = {
      static_cast<uint8_t>(strip.y0), static_cast<uint8_t>(strip.y0 >> 8),
      static_cast<uint8_t>(bottom), static_cast<uint8_t>(bottom >> 8)};
  send_command(bus, kSetColumns, columns);
  send_command(bus, kSetRows, rows);
  send_byte(bus, kSetColumn, columns[0]);
  send_command(bus, kSetRow, {rows, 2});
  send_command(bus, plane == EpaperPlane::next ? kWriteNext : kWriteShown);
  send_pixels(bus, strip, Ssd1680::kFormat);
  return Status::ok;
}

Status refresh(const Ssd1680& display, EpaperRefresh kind) noexcept {
  using namespace ssd1680;
  const DisplayBus& bus = display.bus;
  INKCELL_TRY(check(display));
  const bool full = kind == EpaperRefresh::full;
  const uint8_t planes[] = {
      full ? kShownAsZeros : kBothPlanes,
      static_cast<uint8_t>(display.from_output_8 ? kFromOutput8 : 0)};
  send_command(bus, kSetPlanes, planes);
  send_byte(bus, kSetSequence, full ? kDisplayFull : kDisplayPartial);
  send_command(bus, kActivate);
  bus.wait_idle(bus.context);
  return Status::ok;
}

Status sleep(const Ssd1680& display) noexcept {
  using namespace ssd1680;
  INKCELL_TRY(check(display));
  if (display.bus.reset == nullptr) {
    return Status::bad_argument;
  }
  send_byte(display.bus, kDeepSleep, kKeepMemory);
  return Status::ok;
}

}  // namespace inkcell::port
