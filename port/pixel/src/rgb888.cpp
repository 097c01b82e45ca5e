// The sink for three bytes a pixel.
#include "inkcell/port/rgb888.hpp"

#include "run.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

// The colour's bytes in the order of memory.
struct Bytes {
  uint8_t byte[3];
};

Bytes bytes_of(const detail::Rgb888Pixels& pixels) noexcept {
  const auto red = static_cast<uint8_t>(pixels.colour >> 16);
  const auto green = static_cast<uint8_t>(pixels.colour >> 8);
  const auto blue = static_cast<uint8_t>(pixels.colour);
  if (pixels.order == ChannelOrder::red_first) {
    return {{red, green, blue}};
  }
  return {{blue, green, red}};
}

void cover(const detail::Rgb888Pixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  const Bytes colour = bytes_of(pixels);
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 3 * run.x;
  for (uint8_t* const end = pixel + 3 * run.count; pixel != end; pixel += 3) {
    const uint32_t c = *coverage++;
    if (c != 0) {
      for (int i = 0; i < 3; ++i) {
        pixel[i] = static_cast<uint8_t>(blend(c, colour.byte[i], pixel[i]));
      }
    }
  }
}

void fill_run(const detail::Rgb888Pixels& pixels, const Run& run) noexcept {
  const Bytes colour = bytes_of(pixels);
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 3 * run.x;
  for (uint8_t* const end = pixel + 3 * run.count; pixel != end; pixel += 3) {
    pixel[0] = colour.byte[0];
    pixel[1] = colour.byte[1];
    pixel[2] = colour.byte[2];
  }
}

}  // namespace

const detail::SinkKind detail::Rgb888Pixels::kKind = {
    detail::coverage_of<detail::Rgb888Pixels, cover>,
    detail::solid_of<detail::Rgb888Pixels, fill_run>, nullptr, nullptr,
    layout_of(PixelFormat::rgb888)};

}  // namespace inkcell::port
