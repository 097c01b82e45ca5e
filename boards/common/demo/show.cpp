// The buffer of the demo, and its strip loop.
#include "show.hpp"

#include "canvas.hpp"
#include "display.hpp"
#include "inkcell/port/strip_loop.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

constexpr int32_t kRows = INKCELL_DEMO_ROWS;

alignas(4) uint8_t buffer[port::strip_bytes(kFormat, kWidth, kRows)];

}  // namespace

void show(Status (*draw)(void*, const Strip&)) noexcept {
  port::StripLoop loop;
  loop.buffer = buffer;
  loop.format = kFormat;
  loop.width = kWidth;
  loop.height = kHeight;
  loop.draw = draw;
  loop.flush = [](void*, const Strip& strip) {
    return board::display_write(strip);
  };
  static_cast<void>(run_strips(loop));  // the buffer is made for it
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
