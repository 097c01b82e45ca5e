// Coverage of LCD sub-pixels.
#include "inkcell/port/lcd.hpp"

#include "run.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

void cover_565(const detail::Rgb565Pixels& pixels,
               const Run& run,
               const uint8_t* coverage) noexcept {
  const uint32_t red = pixels.colour >> 11;
  const uint32_t green = pixels.colour >> 5 & 0x3f;
  const uint32_t blue = pixels.colour & 0x1f;
  const int low = pixels.strip.order == ByteOrder::low_first ? 0 : 1;
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 2 * run.x;
  for (uint8_t* const end = pixel + 2 * run.count; pixel != end; pixel += 2) {
    const uint32_t old = pixel[low] | static_cast<uint32_t>(pixel[low ^ 1])
                                          << 8;
    const uint32_t result = blend(coverage[0], red, old >> 11) << 11 |
                            blend(coverage[1], green, old >> 5 & 0x3f) << 5 |
                            blend(coverage[2], blue, old & 0x1f);
    pixel[low] = static_cast<uint8_t>(result);
    pixel[low ^ 1] = static_cast<uint8_t>(result >> 8);
    coverage += 3;
  }
}

// Pixels of kBytes bytes; the first three are channels.
template <int kBytes>
void blend_bytes(const Strip& strip,
                 uint32_t colour,
                 bool red_first,
                 const Run& run,
                 const uint8_t* coverage) noexcept {
  const uint32_t red = colour >> 16 & 0xff;
  const uint32_t green = colour >> 8 & 0xff;
  const uint32_t blue = colour & 0xff;
  const uint32_t first = red_first ? 0 : 2;
  uint8_t* pixel = detail::row_at(strip, run.y) + kBytes * run.x;
  for (uint8_t* const end = pixel + kBytes * run.count; pixel != end;
       pixel += kBytes, coverage += 3) {
    const uint32_t c0 = coverage[0];
    const uint32_t c1 = coverage[1];
    const uint32_t c2 = coverage[2];
    if ((c0 | c1 | c2) == 0) {
      continue;
    }
    pixel[first] = static_cast<uint8_t>(blend(c0, red, pixel[first]));
    pixel[1] = static_cast<uint8_t>(blend(c1, green, pixel[1]));
    pixel[2 - first] = static_cast<uint8_t>(blend(c2, blue, pixel[2 - first]));
  }
}

void cover_888(const detail::Rgb888Pixels& pixels,
               const Run& run,
               const uint8_t* coverage) noexcept {
  blend_bytes<3>(pixels.strip, pixels.colour,
                 pixels.order == ChannelOrder::red_first, run, coverage);
}

void cover_8888(const detail::Xrgb8888Pixels& pixels,
                const Run& run,
                const uint8_t* coverage) noexcept {
  blend_bytes<4>(pixels.strip, pixels.colour, false, run, coverage);
}

}  // namespace

namespace detail {

void set_sub_pixels(const Rgb565Pixels&, Sink& sink) noexcept {
  sink.coverage_rgb = coverage_of<Rgb565Pixels, cover_565, 3>;
}

void set_sub_pixels(const Rgb888Pixels&, Sink& sink) noexcept {
  sink.coverage_rgb = coverage_of<Rgb888Pixels, cover_888, 3>;
}

void set_sub_pixels(const Xrgb8888Pixels&, Sink& sink) noexcept {
  sink.coverage_rgb = coverage_of<Xrgb8888Pixels, cover_8888, 3>;
}

}  // namespace detail
}  // namespace inkcell::port
