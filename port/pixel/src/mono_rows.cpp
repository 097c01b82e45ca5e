// The sink for 1-bit rows.
#include "inkcell/port/mono_rows.hpp"

#include "packed.hpp"

namespace inkcell::detail {
// Null in a program that draws no glyphs: few_levels.hpp.
extern __attribute__((weak)) const LevelRule kTwoLevelRule;
}  // namespace inkcell::detail

namespace inkcell::port {
namespace {

using detail::Run;

// Up to 32 pixels as bits; the left one is the highest or the lowest.
uint32_t drawn(const uint8_t* coverage,
               uint32_t count,
               uint32_t threshold,
               BitOrder order) noexcept {
  uint32_t bits = 0;
  if (order == BitOrder::high_left) {
    for (const uint8_t* const end = coverage + count; coverage != end;) {
      bits = 2 * bits + (*coverage++ >= threshold ? 1 : 0);
    }
    return bits << (32 - count);
  }
  for (const uint8_t* at = coverage + count; at != coverage;) {
    bits = 2 * bits + (*--at >= threshold ? 1 : 0);
  }
  return bits;
}

// Sets or clears the pixels of `bits`, from pixel `x` of a row on, byte by
// byte.
void put(uint8_t* row,
         uint32_t x,
         uint32_t bits,
         const detail::MonoRowsPixels& pixels) {
  uint8_t* byte = row + (x >> 3);
  const uint32_t pattern = pixels.level != 0 ? 0xff : 0;
  const auto merge = [&byte, pattern](uint32_t part) noexcept {
    *byte = static_cast<uint8_t>((*byte & ~part) | (part & pattern));
    ++byte;
  };
  const uint32_t begin = x & 7;
  if (pixels.order == BitOrder::high_left) {
    merge(bits >> (24 + begin));
    for (bits <<= 8 - begin; bits != 0; bits <<= 8) {
      merge(bits >> 24);
    }
  } else {
    merge(bits << begin & 0xff);
    for (bits >>= 8 - begin; bits != 0; bits >>= 8) {
      merge(bits & 0xff);
    }
  }
}

void cover(const detail::MonoRowsPixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  uint8_t* const row = detail::row_at(pixels.strip, run.y);
  auto column = static_cast<uint32_t>(run.x);
  const uint32_t end = column + static_cast<uint32_t>(run.count);
  while (column != end) {
    const uint32_t left = end - column;
    const uint32_t part = left < 32 ? left : 32;
    put(row, column, drawn(coverage, part, pixels.threshold, pixels.order),
        pixels);
    coverage += part;
    column += part;
  }
}

void fill_run(const detail::MonoRowsPixels& pixels, const Run& run) noexcept {
  detail::fill_packed(detail::row_at(pixels.strip, run.y),
                      static_cast<uint32_t>(run.x),
                      static_cast<uint32_t>(run.count), 0,
                      pixels.level != 0 ? 0xff : 0, pixels.order);
}

}  // namespace

const detail::SinkKind detail::MonoRowsPixels::kKind = {
    detail::coverage_of<detail::MonoRowsPixels, cover>,
    detail::solid_of<detail::MonoRowsPixels, fill_run>,
    nullptr,
    nullptr,
    layout_of(PixelFormat::mono_rows),
    &inkcell::detail::kTwoLevelRule};

}  // namespace inkcell::port
