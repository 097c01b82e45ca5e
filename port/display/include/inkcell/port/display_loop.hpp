// The loop over a display's screen: StripLoop, as its driver needs it.
#pragma once

#include <stdint.h>

#include "inkcell/port/dcs_panel.hpp"
#include "inkcell/port/strip_loop.hpp"

namespace inkcell::port {

/// A loop with the size, the format, the byte order and write() of a display,
/// which has a driver in this folder. `context` and `draw` are left to set, and
/// `flush` for e-paper, which refreshes. The display must outlive the loop.
///
/// With a second buffer the bus needs `start` and `wait_sent`; with one both,
/// or neither.
template <typename Display>
StripLoop loop_over(Display& display,
                    Span<uint8_t> buffer,
                    Span<uint8_t> second = {}) noexcept {
  StripLoop loop;
  loop.buffer = buffer;
  loop.second = second;
  loop.format = Display::kFormat;
  if constexpr (__is_base_of(DcsPanel, Display)) {
    loop.width = screen_width(display);
    loop.height = screen_height(display);
    loop.order = ByteOrder::high_first;
  } else {
    loop.width = display.width;
    loop.height = display.height;
  }
  loop.display = &display;
  loop.flush = [](void* to, const Strip& strip) {
    return write(*static_cast<const Display*>(to), strip);
  };
  if (display.bus.wait_sent != nullptr) {
    loop.wait = [](void* to) {
      const DisplayBus& bus = static_cast<const Display*>(to)->bus;
      bus.wait_sent(bus.context);
      return Status::ok;
    };
  }
  return loop;
}

}  // namespace inkcell::port
