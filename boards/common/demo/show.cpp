// The buffer of the demo, and its strip loop.
#include "show.hpp"

#include "canvas.hpp"
#include "display.hpp"

namespace inkcell {
namespace demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

constexpr int32_t kRows = INKCELL_DEMO_ROWS;

alignas(4) uint8_t buffer[port::strip_bytes(kFormat, kWidth, kRows)];

}  // namespace

void show(void* context, void (*draw)(void*, const Strip&)) noexcept {
  StripLoop loop;
  loop.buffer = buffer;
  loop.width = kWidth;
  loop.height = kHeight;
  loop.rows = kRows;
  loop.stride = port::stride_bytes(kFormat, kWidth);
  loop.rows_per_stride = port::rows_per_stride(kFormat);
  loop.context = context;
  loop.draw = draw;
  loop.flush = [](void*, const Strip& strip) { board::display_write(strip); };
  static_cast<void>(run_strips(loop));  // the buffer is made for it
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace demo
}  // namespace inkcell
