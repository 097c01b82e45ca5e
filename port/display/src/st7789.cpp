// The ST7789's memory and pixel format.
#include "inkcell/port/st7789.hpp"

#include "dcs_commands.hpp"

namespace inkcell::port {
namespace {

constexpr detail::DcsController kController = {240, 320, 0x55};

}  // namespace

Status init(const St7789& display) noexcept {
  return detail::init(display, kController);
}

Status write(const St7789& display, const Strip& strip) noexcept {
  return detail::write(display, kController, strip);
}

}  // namespace inkcell::port
