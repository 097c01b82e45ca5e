// The SH1106's commands, and strips sent page by page: it has no windows.
#include "inkcell/port/sh1106.hpp"

#include "bounds.hpp"
#include "mono_oled.hpp"
#include "send_pages.hpp"

namespace inkcell::port {
namespace sh1106 {
namespace {

constexpr uint8_t kSetConverter = 0xad;
constexpr uint8_t kConverterOff = 0x8a;
constexpr uint8_t kConverterOn = 0x8b;

constexpr int32_t kColumns = 132;  // of the controller's memory [px]
constexpr int32_t kLeastRows = 8;

}  // namespace
}  // namespace sh1106

Status init(const Sh1106& display) noexcept {
  using namespace sh1106;
  INKCELL_TRY(check_size(display, kColumns, kLeastRows));
  const uint8_t own[] = {kSetConverter,
                         display.converter ? kConverterOn : kConverterOff};
  start(display, own);
  return Status::ok;
}

Status write(const Sh1106& display, const Strip& strip) noexcept {
  using namespace sh1106;
  INKCELL_TRY(check_size(display, kColumns, kLeastRows));
  INKCELL_TRY(
      check_on_screen(strip, Sh1106::kFormat, display.width, display.height));
  send_pages(display.bus, left_column(display, kColumns), strip);
  return Status::ok;
}

}  // namespace inkcell::port
