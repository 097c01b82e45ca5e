// The chord of a circle over some rows.
#include "inkcell/port/round_strip.hpp"

namespace inkcell::port {
namespace {

// The distance of the circle's centre (at diameter / 2) from the nearest edge
// of the pixels [first, end); 0 inside. [1/2 px]
int32_t distance(int32_t first, int32_t end, int32_t diameter) noexcept {
  return 2 * first > diameter ? 2 * first - diameter
                              : (2 * end < diameter ? diameter - 2 * end : 0);
}

// The columns to the left of the circle, in rows `away` [1/2 px] from the
// centre: the chord begins at the first pixel whose right edge is inside.
int32_t hidden_columns(int32_t away, int32_t diameter) noexcept {
  const int64_t square = int64_t{diameter} * diameter - int64_t{away} * away;
  int32_t x = 0;
  while (2 * x < diameter) {
    const int64_t across = distance(x, x + 1, diameter);
    if (across * across < square) {
      return x;
    }
    ++x;
  }
  return x;
}

}  // namespace

Strip round_strip(const Strip& strip,
                  PixelFormat format,
                  int32_t diameter) noexcept {
  if (diameter < 1 || diameter > kMaxSide ||
      check_strip(strip, format) != Status::ok) {
    return strip;
  }
  const int32_t away = distance(strip.y0, strip.y0 + strip.height, diameter);
  const int32_t hidden =
      away < diameter ? hidden_columns(away, diameter) : diameter;
  const int32_t bits = bits_per_pixel(format);
  // Pixels in a byte along the row, less one: a mask.
  const int32_t low =
      format == PixelFormat::mono_pages || bits >= 8 ? 0 : 8 / bits - 1;
  const int32_t first = hidden & ~low;
  const int32_t last = (diameter - hidden + low) & ~low;
  const int32_t left = first > strip.x0 ? first : strip.x0;
  const int32_t right = strip.x0 + strip.width;
  const int32_t end = last < right ? last : right;
  Strip part = strip;
  part.x0 = left;
  part.width = hidden < diameter && left < end ? end - left : 0;
  part.stride = stride_bytes(format, part.width);
  return part;
}

}  // namespace inkcell::port
