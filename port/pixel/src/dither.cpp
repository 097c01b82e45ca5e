// Ordered dither.
#include "inkcell/port/dither.hpp"

#include "packed.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

// Bayer's 4 x 4 matrix: consecutive numbers are far apart.
constexpr uint8_t kOrder[4][4] = {
    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

// The coverage that rounds up at a pixel: the middle of one of 16 intervals.
// Only x and y modulo 4 count, so no sum overflows.
int32_t step_at(int32_t x, int32_t y) noexcept {
  return kOrder[y & 3][x & 3] * 16 + 8;
}

struct Bit {
  uint8_t& byte;
  uint32_t mask;
};

Bit bit_of(const detail::MonoRowsPixels& pixels,
           int32_t x,
           int32_t y) noexcept {
  const auto column = static_cast<uint32_t>(x);
  return {detail::row_at(pixels.strip, y)[column >> 3],
          1u << detail::packed_shift(column, 0, pixels.order)};
}

Bit bit_of(const detail::MonoPagesPixels& pixels,
           int32_t x,
           int32_t y) noexcept {
  return {detail::row_at(pixels.strip, y >> 3)[x], 1u << (y & 7)};
}

template <typename Pixels>
void mono(const Pixels& pixels,
          const Run& run,
          const uint8_t* coverage) noexcept {
  const Strip& strip = pixels.strip;
  for (int32_t i = 0; i < run.count; ++i) {
    const int32_t c = coverage[i];
    // The threshold moves all steps but those of 0 and 255.
    const int32_t needed =
        step_at(strip.x0 + run.x + i, strip.y0 + run.y) + pixels.threshold;
    if (c == 255 || (c != 0 && c + 128 >= needed)) {
      const Bit bit = bit_of(pixels, run.x + i, run.y);
      bit.byte = static_cast<uint8_t>(pixels.level != 0 ? bit.byte | bit.mask
                                                        : bit.byte & ~bit.mask);
    }
  }
}

template <typename Pixels, uint32_t kBitsLog2>
void grey(const Pixels& pixels,
          const Run& run,
          const uint8_t* coverage) noexcept {
  const Strip& strip = pixels.strip;
  uint8_t* const row = detail::row_at(strip, run.y);
  constexpr uint32_t kMask = (1u << (1u << kBitsLog2)) - 1;
  for (int32_t i = 0; i < run.count; ++i) {
    const uint32_t c = coverage[i];
    if (c != 0) {
      const auto column = static_cast<uint32_t>(run.x + i);
      const uint32_t shift =
          detail::packed_shift(column, kBitsLog2, pixels.order);
      uint8_t& byte = row[column >> (3 - kBitsLog2)];
      const uint32_t old = static_cast<uint32_t>(byte) >> shift & kMask;
      // As blend(), but rounded by the pixel's step.
      const auto step = static_cast<uint32_t>(
          step_at(strip.x0 + run.x + i, strip.y0 + run.y));
      const uint32_t mixed =
          (c * pixels.level + (255 - c) * old + 255 - step) / 255;
      byte = static_cast<uint8_t>(byte ^ ((old ^ mixed) & kMask) << shift);
    }
  }
}

}  // namespace

namespace detail {

void set_dither(const MonoRowsPixels&, Sink& sink) noexcept {
  sink.coverage = coverage_of<MonoRowsPixels, mono<MonoRowsPixels>>;
  sink.levels = shifted_two_level_rule();
}

void set_dither(const MonoPagesPixels&, Sink& sink) noexcept {
  sink.coverage = coverage_of<MonoPagesPixels, mono<MonoPagesPixels>>;
  sink.levels = shifted_two_level_rule();
}

void set_dither(const Grey2Pixels&, Sink& sink) noexcept {
  sink.coverage = coverage_of<Grey2Pixels, grey<Grey2Pixels, 1>>;
  sink.levels = shifted_four_level_rule();
}

void set_dither(const Grey4Pixels&, Sink& sink) noexcept {
  sink.coverage = coverage_of<Grey4Pixels, grey<Grey4Pixels, 2>>;
}

}  // namespace detail
}  // namespace inkcell::port
