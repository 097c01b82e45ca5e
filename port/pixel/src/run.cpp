// Checking a strip, and clipping a run to it.
#include "run.hpp"

namespace inkcell {
namespace port {
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

Status open_sink(const Strip& strip,
                 const SinkKind& kind,
                 void* context,
                 Sink& out) noexcept {
  INKCELL_TRY(check_layout(strip, kind.layout));
  out.window = strip.rect();
  out.context = context;
  out.coverage = kind.coverage;
  out.solid = kind.solid;
  out.block = nullptr;
  out.ramp = nullptr;
  out.coverage_rgb = nullptr;
  return Status::ok;
}

}  // namespace detail

Status check_strip(const Strip& strip, PixelFormat format) noexcept {
  return detail::check_layout(strip, detail::layout_of(format));
}

}  // namespace port
}  // namespace inkcell
