#include "inkcell/strip.hpp"

namespace inkcell {
namespace {

constexpr int32_t kMaxScreen = 32767;

Status check(const StripLoop& loop) noexcept {
  const bool sizes_fit = loop.width > 0 && loop.width <= kMaxScreen &&
                         loop.height > 0 && loop.height <= kMaxScreen &&
                         loop.rows > 0 && loop.stride > 0 &&
                         loop.rows_per_stride > 0;
  if (!sizes_fit || loop.rows % loop.rows_per_stride != 0 ||
      loop.draw == nullptr || loop.flush == nullptr) {
    return Status::bad_argument;
  }
  // No strip is higher than the screen, rounded up to whole strides.
  const int64_t strides = loop.rows < loop.height
                              ? loop.rows / loop.rows_per_stride
                              : (loop.height - 1) / loop.rows_per_stride + 1;
  return strides * loop.stride > static_cast<int64_t>(loop.buffer.size)
             ? Status::buffer_small
             : Status::ok;
}

}  // namespace

Status run_strips(const StripLoop& loop) noexcept {
  INKCELL_TRY(check(loop));
  Strip strip;
  strip.pixels = loop.buffer;
  strip.width = loop.width;
  strip.stride = loop.stride;
  for (int32_t y = 0; y < loop.height;) {
    const int32_t left = loop.height - y;
    strip.y0 = y;
    strip.height = left < loop.rows ? left : loop.rows;
    loop.draw(loop.context, strip);
    loop.flush(loop.context, strip);
    y += strip.height;
  }
  return Status::ok;
}

}  // namespace inkcell
