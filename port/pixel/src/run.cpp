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

// The difference modulo 2^32. `b` is a strip's corner, so it wraps only for an
// `a` some 2^31 px away, which clip() then cuts like any other.
int32_t wrapping_difference(int32_t a, int32_t b) noexcept {
  return static_cast<int32_t>(static_cast<uint32_t>(a) -
                              static_cast<uint32_t>(b));
}

}  // namespace

namespace detail {

bool clip_any(const Strip& strip, Run& run) noexcept {
  run.y = wrapping_difference(run.y, strip.y0);
  if (run.y < 0 || run.y >= strip.height) {
    return false;
  }
  run.x = wrapping_difference(run.x, strip.x0);
  run.skipped = 0;
  if (run.x < 0) {
    if (run.count <= 0 || run.x <= -run.count) {
      return false;
    }
    run.skipped = -run.x;
    run.count += run.x;
    run.x = 0;
  }
  const int32_t room = strip.width - run.x;
  if (run.count > room) {
    run.count = room;
  }
  return run.count > 0;
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
  const int32_t per_stride = rows_per_stride(format);
  const int32_t rows = (strip.height + per_stride - 1) / per_stride;
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
