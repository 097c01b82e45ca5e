// The GC9A01's memory and pixel format.
#include "inkcell/port/gc9a01.hpp"

#include "dcs_commands.hpp"

namespace inkcell::port {
namespace {

constexpr detail::DcsController kController = {240, 240, 0x55};

}  // namespace

Status init(const Gc9a01& display) noexcept {
  return detail::init(display, kController);
}

Status write(const Gc9a01& display, const Strip& strip) noexcept {
  return detail::write(display, kController, strip);
}

}  // namespace inkcell::port
