#include "inkcell/strip.hpp"

namespace inkcell {

void run_strips(const StripLoop& loop) noexcept {
  if (loop.rows <= 0) {
    return;
  }
  Strip strip;
  strip.pixels = loop.buffer;
  strip.width = loop.width;
  strip.stride = loop.stride;
  for (int32_t y = 0; y < loop.height; y += loop.rows) {
    const int32_t left = loop.height - y;
    strip.y0 = y;
    strip.height = left < loop.rows ? left : loop.rows;
    loop.draw(loop.context, strip);
    loop.flush(loop.context, strip);
  }
}

}  // namespace inkcell
