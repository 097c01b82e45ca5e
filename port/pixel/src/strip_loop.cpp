// Strips of one window, in one buffer or in two by turns.
#include "inkcell/port/strip_loop.hpp"

namespace inkcell::port {
namespace {

bool is_side(int32_t px) noexcept {
  return px > 0 && px <= kMaxSide;
}

bool overlap(Span<uint8_t> a, Span<uint8_t> b) noexcept {
  const auto a_first = reinterpret_cast<uintptr_t>(a.data);
  const auto b_first = reinterpret_cast<uintptr_t>(b.data);
  return a_first < b_first + b.size && b_first < a_first + a.size;
}

Status check(const StripLoop& loop) noexcept {
  const bool is_double = loop.second.data != nullptr;
  return !is_side(loop.width) || !is_side(loop.height) ||
                 loop.draw == nullptr || loop.flush == nullptr ||
                 (is_double &&
                  (loop.wait == nullptr || overlap(loop.buffer, loop.second)))
             ? Status::bad_argument
             : Status::ok;
}

// The pixels whose bytes hold those of a part: its edges are edges of bytes or
// of the screen.
Rect whole_bytes(const StripLoop& loop, const Rect& part) noexcept {
  const Rect screen = {0, 0, loop.width, loop.height};
  Rect window = intersect(part, screen);
  const int32_t rows = rows_per_stride(loop.format);
  const int32_t bits = bits_per_pixel(loop.format);
  const int32_t low_x = rows == 1 && bits < 8 ? 8 / bits - 1 : 0;
  const int32_t low_y = rows - 1;
  window = {window.x0 & ~low_x, window.y0 & ~low_y,
            (window.x1 + low_x) & ~low_x, (window.y1 + low_y) & ~low_y};
  return intersect(window, screen);
}

}  // namespace

Status run_strips(const StripLoop& loop, const Rect& part) noexcept {
  INKCELL_TRY(check(loop));
  const Rect window = whole_bytes(loop, part);
  if (is_empty(window)) {
    return Status::ok;
  }
  const bool is_double = loop.second.data != nullptr;
  size_t size = loop.buffer.size;
  size = is_double && loop.second.size < size ? loop.second.size : size;
  Strip strip;
  strip.x0 = window.x0;
  strip.width = window.x1 - window.x0;
  strip.stride = stride_bytes(loop.format, strip.width);
  strip.order = loop.order;
  const size_t strides = size / static_cast<size_t>(strip.stride);
  if (strides == 0) {
    return Status::buffer_small;
  }
  const int32_t rows =
      strides < static_cast<size_t>(kMaxSide)
          ? static_cast<int32_t>(strides) * rows_per_stride(loop.format)
          : kMaxSide + 1;
  bool is_second = false;
  bool is_sending = false;
  Status status = Status::ok;
  for (int32_t y = window.y0; y < window.y1 && status == Status::ok;
       y += strip.height) {
    const int32_t left = window.y1 - y;
    strip.y0 = y;
    strip.height = left < rows ? left : rows;
    strip.pixels = {is_second ? loop.second.data : loop.buffer.data,
                    strip_bytes(loop.format, strip.width, strip.height)};
    status = loop.draw(loop.context, strip);
    if (is_sending) {
      const Status sent = loop.wait(loop.display);
      status = status == Status::ok ? sent : status;
      is_sending = false;
    }
    if (status == Status::ok) {
      status = loop.flush(loop.display, strip);
      is_sending = loop.wait != nullptr && status == Status::ok;
      is_second = is_double && !is_second;
      if (is_sending && !is_double) {
        status = loop.wait(loop.display);
        is_sending = false;
      }
    }
  }
  return is_sending ? loop.wait(loop.display) : status;
}

}  // namespace inkcell::port
