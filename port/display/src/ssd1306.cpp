// The SSD1306's commands (data sheet Rev 1.1), and strips sent as windows of
// its memory.
#include "inkcell/port/ssd1306.hpp"

#include "bounds.hpp"
#include "mono_oled.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace ssd1306 {
namespace {

enum Command : uint8_t {
  kSetAddressing = 0x20,  // mode
  kSetColumns = 0x21,     // first, last
  kSetPages = 0x22,       // first, last
  kSetChargePump = 0x8d,
  kSetRowPins = 0xda,
};

// Parameters.
constexpr uint8_t kHorizontal = 0x00;  // to the right, then to the next page
constexpr uint8_t kPumpOff = 0x10;
constexpr uint8_t kPumpOn = 0x14;
constexpr uint8_t kSequential = 0x02;
constexpr uint8_t kAlternating = 0x12;

constexpr int32_t kColumns = 128;   // of the controller's memory [px]
constexpr int32_t kLeastRows = 16;  // of the multiplex ratio

}  // namespace
}  // namespace ssd1306

Status init(const Ssd1306& display) noexcept {
  using namespace ssd1306;
  INKCELL_TRY(check_size(display, kColumns, kLeastRows));
  const uint8_t own[] = {
      kSetAddressing, kHorizontal,
      kSetRowPins,    display.sequential_rows ? kSequential : kAlternating,
      kSetChargePump, display.external_supply ? kPumpOff : kPumpOn,
  };
  start(display, own);
  return Status::ok;
}

Status write(const Ssd1306& display, const Strip& strip) noexcept {
  using namespace ssd1306;
  INKCELL_TRY(check_size(display, kColumns, kLeastRows));
  INKCELL_TRY(
      check_on_screen(strip, Ssd1306::kFormat, display.width, display.height));
  const int32_t left = left_column(display, kColumns);
  const uint8_t window[] = {
      kSetColumns,
      static_cast<uint8_t>(left + strip.x0),
      static_cast<uint8_t>(left + strip.x0 + strip.width - 1),
      kSetPages,
      static_cast<uint8_t>(strip.y0 / 8),
      static_cast<uint8_t>((strip.y0 + strip.height) / 8 - 1),
  };
  display.bus.command(display.bus.context, window, sizeof window);
  send_pixels(display.bus, strip, Ssd1306::kFormat);
  return Status::ok;
}

}  // namespace inkcell::port
