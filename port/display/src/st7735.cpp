// The ST7735's memory, which pins choose, and its pixel format.
#include "inkcell/port/st7735.hpp"

#include "dcs_commands.hpp"

namespace inkcell::port {
namespace {

detail::DcsController controller_of(const St7735& display) noexcept {
  constexpr uint8_t k16Bits = 0x05;
  return display.gm_011 ? detail::DcsController{128, 160, k16Bits}
                        : detail::DcsController{132, 162, k16Bits};
}

}  // namespace

Status init(const St7735& display) noexcept {
  return detail::init(display, controller_of(display));
}

Status write(const St7735& display, const Strip& strip) noexcept {
  return detail::write(display, controller_of(display), strip);
}

}  // namespace inkcell::port
