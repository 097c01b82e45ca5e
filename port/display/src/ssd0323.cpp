// The SSD0323's commands, and strips sent as windows of its memory.
#include "inkcell/port/ssd0323.hpp"

#include "bounds.hpp"
#include "send_pixels.hpp"

namespace inkcell::port {
namespace ssd0323 {
namespace {

enum Command : uint8_t {
  kSetColumns = 0x15,  // first, last [bytes of two pixels]
  kSetRows = 0x75,     // first, last
  kSetRemap = 0xa0,
  kSetStartLine = 0xa1,
  kSetOffset = 0xa2,
  kNormalDisplay = 0xa4,
  kSetMultiplex = 0xa8,  // rows - 1
};

constexpr int32_t kMaxWidth = 128;  // of the controller's memory [px]
constexpr int32_t kMaxHeight = 80;

}  // namespace
}  // namespace ssd0323

void init(const Ssd0323& display) noexcept {
  using namespace ssd0323;
  const uint8_t commands[] = {
      detail::kOledOff,
      kSetRemap,
      0,  // rows first, columns and nibbles from the left
      kSetStartLine,
      0,
      kSetOffset,
      0,
      kNormalDisplay,
      kSetMultiplex,
      static_cast<uint8_t>(display.height - 1),
      detail::kOledOn,
  };
  display.bus.command(display.bus.context, commands, sizeof commands);
}

Status write(const Ssd0323& display, const Strip& strip) noexcept {
  using namespace ssd0323;
  if (display.width > kMaxWidth || display.height > kMaxHeight) {
    return Status::bad_argument;
  }
  INKCELL_TRY(
      check_on_screen(strip, Ssd0323::kFormat, display.width, display.height));
  const uint8_t window[] = {
      kSetColumns,
      static_cast<uint8_t>(strip.x0 / 2),
      static_cast<uint8_t>((strip.x0 + strip.width) / 2 - 1),
      kSetRows,
      static_cast<uint8_t>(strip.y0),
      static_cast<uint8_t>(strip.y0 + strip.height - 1),
  };
  display.bus.command(display.bus.context, window, sizeof window);
  send_pixels(display.bus, strip, Ssd0323::kFormat);
  return Status::ok;
}

}  // namespace inkcell::port
