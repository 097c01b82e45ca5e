// The sink for four bytes a pixel.
#include "inkcell/port/xrgb8888.hpp"

#include "run.hpp"
#include "word.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

// The colour in the byte order of load_word(): the blend below treats all four
// bytes alike.
uint32_t colour_word(const detail::Xrgb8888Pixels& pixels) noexcept {
  return detail::word_of(pixels.colour & 0xff, pixels.colour >> 8 & 0xff,
                         pixels.colour >> 16 & 0xff, pixels.colour >> 24);
}

// blend() of the bytes 0 and 2 of a word, each in its half: 255 * 255 + 128 and
// the rounding are below 65536, so there is no carry between them.
uint32_t blend_pair(uint32_t coverage,
                    uint32_t foreground,
                    uint32_t background) noexcept {
  constexpr uint32_t kPair = 0x00ff00ff;
  const uint32_t sum = coverage * (foreground & kPair) +
                       (255 - coverage) * (background & kPair) + 0x00800080;
  return (sum + (sum >> 8 & kPair)) >> 8 & kPair;
}

void cover(const detail::Xrgb8888Pixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  const uint32_t colour = colour_word(pixels);
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 4 * run.x;
  for (uint8_t* const end = pixel + 4 * run.count; pixel != end; pixel += 4) {
    const uint32_t c = *coverage++;
    if (c != 0) {
      const uint32_t old = detail::load_word(pixel);
      detail::store_word(pixel, blend_pair(c, colour, old) |
                                    blend_pair(c, colour >> 8, old >> 8) << 8);
    }
  }
}

void fill_run(const detail::Xrgb8888Pixels& pixels, const Run& run) noexcept {
  const uint32_t colour = colour_word(pixels);
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + 4 * run.x;
  for (uint8_t* const end = pixel + 4 * run.count; pixel != end; pixel += 4) {
    detail::store_word(pixel, colour);
  }
}

}  // namespace

const detail::SinkKind detail::Xrgb8888Pixels::kKind = {
    detail::coverage_of<detail::Xrgb8888Pixels, cover>,
    detail::solid_of<detail::Xrgb8888Pixels, fill_run>, nullptr, nullptr,
    layout_of(PixelFormat::xrgb8888)};

}  // namespace inkcell::port
