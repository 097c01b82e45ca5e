// Checking a strip, and clipping a run to it.
#include "run.hpp"

namespace inkcell::port {
namespace {

// 65535 rows of this stride still fit 32 bits.
constexpr uint32_t kMaxStride = 65535;  // [bytes]

// Sink::window is within kMaxSide. Negative numbers become large.
bool in_range(int32_t origin, int32_t size) noexcept {
  constexpr auto kMax = static_cast<uint32_t>(kMaxSide);
  const auto length = static_cast<uint32_t>(size);
  return length <= kMax &&
         static_cast<uint32_t>(origin) + kMax <= 2 * kMax - length;
}

}  // namespace

namespace detail {

Status check_layout(const Strip& strip, Layout layout) noexcept {
  if (!in_range(strip.x0, strip.width) || !in_range(strip.y0, strip.height)) {
    return Status::bad_argument;
  }
  const auto stride = static_cast<uint32_t>(strip.stride);
  // Pixels of 32 bits are read and written as words.
  const auto address = reinterpret_cast<uintptr_t>(strip.pixels.data);
  if (layout.bits == 32 && ((address | stride) & 3) != 0) {
    return Status::misaligned;
  }
  const uint32_t row_bytes =
      (static_cast<uint32_t>(strip.width) * layout.bits + 7) / 8;
  if (stride < row_bytes || stride > kMaxStride) {
    return Status::bad_argument;
  }
  const uint32_t rows =
      (static_cast<uint32_t>(strip.height) + (1u << layout.rows_log2) - 1) >>
      layout.rows_log2;
  // The last row may lack the stride's padding.
  return rows != 0 && (rows - 1) * stride + row_bytes > strip.pixels.size
             ? Status::buffer_small
             : Status::ok;
}

Status cut_strip(Strip& strip, Layout layout) noexcept {
  Status status = Status::ok;
  for (;;) {
    const Status now = check_layout(strip, layout);
    if (now == Status::ok) {
      return status;
    }
    status = now;
    if (now == Status::buffer_small) {
      --strip.height;
    } else {
      strip = {};
    }
  }
}

Status open_sink(Strip& strip,
                 const SinkKind& kind,
                 void* pixels,
                 Sink& out) noexcept {
  const Status status = cut_strip(strip, kind.layout);
  out.window = strip.rect();
  out.context = pixels;
  out.coverage = kind.coverage;
  out.solid = kind.solid;
  out.block = kind.block;
  out.painted = kind.painted;
  out.levels = kind.levels;
  return status;
}

void fill(const Sink& sink) noexcept {
  const Rect& window = sink.window;
  if (is_empty(window)) {
    return;
  }
  for (int32_t y = window.y0; y < window.y1; ++y) {
    sink.solid(sink.context, window.x0, y, window.x1 - window.x0);
  }
}

}  // namespace detail

Status check_strip(const Strip& strip, PixelFormat format) noexcept {
  return detail::check_layout(strip, detail::layout_of(format));
}

}  // namespace inkcell::port
