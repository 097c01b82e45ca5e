// Checking a strip, and clipping a run to it.
#include "run.hpp"

namespace inkcell {
namespace port {
namespace {

// 65535 rows of it still fit 32 bits.
constexpr int32_t kMaxStride = 65535;  // [bytes]

// Sink::window lies within this, and no sum below overflows.
bool in_range(int32_t origin, int32_t size) noexcept {
  return origin >= -kMaxSide && origin <= kMaxSide && size >= 0 &&
         size <= kMaxSide && size <= kMaxSide - origin;
}

}  // namespace

namespace detail {

int32_t count_within(const Strip& strip,
                     int32_t x,
                     int32_t y,
                     int32_t count) noexcept {
  if (y < 0 || y >= strip.height || count <= 0) {
    return 0;
  }
  if (x < 0) {
    if (x <= -count) {
      return 0;
    }
    count += x;
    x = 0;
  }
  const int32_t room = strip.width - x;
  const int32_t left = count > room ? room : count;
  return left > 0 ? left : 0;
}

Status open_sink(const Strip& strip,
                 PixelFormat format,
                 const Sink& functions,
                 Sink& out) noexcept {
  INKCELL_TRY(check_strip(strip, format));
  out = functions;
  out.window = strip.rect();
  return Status::ok;
}

}  // namespace detail

Status check_strip(const Strip& strip, PixelFormat format) noexcept {
  if (!in_range(strip.x0, strip.width) || !in_range(strip.y0, strip.height)) {
    return Status::bad_argument;
  }
  const int32_t row_bytes = stride_bytes(format, strip.width);
  if (strip.stride < row_bytes || strip.stride > kMaxStride) {
    return Status::bad_argument;
  }
  // Nothing is divided unless it must be: some cores take long.
  const int32_t per_stride = rows_per_stride(format);
  const int32_t rows = per_stride == 1
                           ? strip.height
                           : (strip.height + per_stride - 1) / per_stride;
  if (rows > 0) {
    // The last row need not be followed by the stride's padding.
    const uint32_t before_last =
        static_cast<uint32_t>(rows - 1) * static_cast<uint32_t>(strip.stride);
    const size_t size = strip.pixels.size;
    if (size < before_last ||
        size - before_last < static_cast<uint32_t>(row_bytes)) {
      return Status::buffer_small;
    }
  }
  return Status::ok;
}

}  // namespace port
}  // namespace inkcell
