// The SSD0303's commands, and strips sent page by page.
#include "inkcell/port/ssd0303.hpp"

#include "bounds.hpp"
#include "send_pages.hpp"

namespace inkcell::port {
namespace ssd0303 {
namespace {

enum Command : uint8_t {
  kSetStartLine = 0x40,  // | line
  kSegmentsNormal = 0xa0,
  kNormalDisplay = 0xa4,
  kNotInverse = 0xa6,
  kScanNormal = 0xc0,
};

constexpr int32_t kColumns = 132;  // of the controller's memory [px]
constexpr int32_t kRows = 64;

}  // namespace
}  // namespace ssd0303

void init(const Ssd0303& display) noexcept {
  using namespace ssd0303;
  const uint8_t commands[] = {
      detail::kOledOff, kSegmentsNormal, kNormalDisplay,  kNotInverse,
      kSetStartLine,    kScanNormal,     detail::kOledOn,
  };
  display.bus.command(display.bus.context, commands, sizeof commands);
}

Status write(const Ssd0303& display, const Strip& strip) noexcept {
  using namespace ssd0303;
  if (display.first_column + display.width > kColumns ||
      display.height > kRows) {
    return Status::bad_argument;
  }
  INKCELL_TRY(
      check_on_screen(strip, Ssd0303::kFormat, display.width, display.height));
  send_pages(display.bus, display.first_column, strip);
  return Status::ok;
}

}  // namespace inkcell::port
