// The ILI9341's memory and pixel format (data sheet V1.11).
#include "inkcell/port/ili9341.hpp"

#include "dcs_commands.hpp"

namespace inkcell::port {
namespace {

constexpr detail::DcsController kController = {240, 320, 0x55};

}  // namespace

Status init(const Ili9341& display) noexcept {
  return detail::init(display, kController);
}

Status write(const Ili9341& display, const Strip& strip) noexcept {
  return detail::write(display, kController, strip);
}

}  // namespace inkcell::port
