// The sink for RGB565.
#include "inkcell/port/rgb565.hpp"

#include "run.hpp"
#include "word.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

// Red and blue with room between them: each blends in a half word of its own,
// where blend() needs 13 bits and its rounding never carries into the other.
//
//     31    21 20    16 15     5 4      0
//     |  0   |  red   |   0   |  blue  |
constexpr uint32_t spread(uint32_t pixel) noexcept {
  return (pixel & 0xf800) << 5 | (pixel & 0x1f);
}

constexpr uint32_t green_of(uint32_t pixel) noexcept {
  return pixel >> 5 & 0x3f;
}

// blend() of the three channels, two of them in one word: spread() of red and
// blue, and green.
uint32_t blend565(uint32_t coverage,
                  uint32_t red_blue,
                  uint32_t green,
                  uint32_t background) noexcept {
  const uint32_t rest = 255 - coverage;
  uint32_t sum = coverage * red_blue + rest * spread(background) + 0x00800080;
  sum = (sum + ((sum >> 8) & 0x00ff00ff)) >> 8;
  return (sum >> 5 & 0xf800) | (sum & 0x1f) |
         blend(coverage, green, green_of(background)) << 5;
}

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const Rgb565Target*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  coverage += run.skipped;
  const uint32_t red_blue = spread(target.colour);
  const uint32_t green = green_of(target.colour);
  const int low = target.order == ByteOrder::low_first ? 0 : 1;
  uint8_t* pixel = detail::row_at(target.strip, run.y) + 2 * run.x;
  for (uint8_t* const end = pixel + 2 * run.count; pixel != end; pixel += 2) {
    const uint32_t c = *coverage++;
    if (c != 0) {
      const uint32_t old = pixel[low] | static_cast<uint32_t>(pixel[low ^ 1])
                                            << 8;
      const uint32_t result = blend565(c, red_blue, green, old);
      pixel[low] = static_cast<uint8_t>(result);
      pixel[low ^ 1] = static_cast<uint8_t>(result >> 8);
    }
  }
}

// Pixels from `pixel` up to `end`, two in a word where addresses permit.
// `colour` has the byte of the lower address in its low half.
void fill(uint8_t* pixel, uint8_t* end, uint16_t colour) noexcept {
  const uint32_t first = colour & 0xff;
  const uint32_t second = colour >> 8;
  const uint32_t pair = detail::word_of(first, second, first, second);
  const bool even = (reinterpret_cast<uintptr_t>(pixel) & 1) == 0;
  while (pixel != end) {
    if (even && (reinterpret_cast<uintptr_t>(pixel) & 2) == 0) {
      for (; end - pixel >= 4; pixel += 4) {
        detail::store_word(pixel, pair);
      }
      if (pixel == end) {
        return;
      }
    }
    pixel[0] = static_cast<uint8_t>(first);
    pixel[1] = static_cast<uint8_t>(second);
    pixel += 2;
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const Rgb565Target*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  uint8_t* pixel = detail::row_at(target.strip, run.y) + 2 * run.x;
  fill(pixel, pixel + 2 * run.count,
       target.order == ByteOrder::low_first
           ? target.colour
           : static_cast<uint16_t>(target.colour << 8 | target.colour >> 8));
}

}  // namespace

Status make_sink(Rgb565Target& target, Sink& out) noexcept {
  return detail::open_sink(target.strip, PixelFormat::rgb565,
                           {{}, &target, coverage, solid}, out);
}

}  // namespace port
}  // namespace inkcell
