// The sink for 1-bit pages of 8 rows.
#include "inkcell/port/mono_pages.hpp"

#include "run.hpp"
#include "word.hpp"

namespace inkcell::detail {
// Null in a program that draws no glyphs: few_levels.hpp.
extern __attribute__((weak)) const LevelRule kTwoLevelRule;
}  // namespace inkcell::detail

namespace inkcell::port {
namespace {

using detail::Run;

// The byte of a run's first pixel, and the bit of its row in each byte.
uint8_t* first_byte(const Strip& strip, const Run& run) noexcept {
  return detail::row_at(strip, run.y >> 3) + run.x;
}

uint32_t row_bit(const Run& run) noexcept {
  return 1u << (run.y & 7);
}

// The new value of the row's bit where a pixel is drawn.
uint32_t drawn_bit(const detail::MonoPagesPixels& pixels,
                   uint32_t bit) noexcept {
  return pixels.level != 0 ? bit : 0;
}

void cover(const detail::MonoPagesPixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  uint8_t* byte = first_byte(pixels.strip, run);
  const uint32_t bit = row_bit(run);
  const uint32_t drawn = drawn_bit(pixels, bit);
  const uint32_t threshold = pixels.threshold;
  for (uint8_t* const end = byte + run.count; byte != end; ++byte) {
    if (*coverage++ >= threshold) {
      *byte = static_cast<uint8_t>((*byte & ~bit) | drawn);
    }
  }
}

void fill_run(const detail::MonoPagesPixels& pixels, const Run& run) noexcept {
  uint8_t* byte = first_byte(pixels.strip, run);
  uint8_t* const end = byte + run.count;
  const uint32_t bit = row_bit(run);
  const uint32_t drawn = drawn_bit(pixels, bit);
  constexpr uint32_t kFour = 0x01010101;
  while (byte != end) {
    if ((reinterpret_cast<uintptr_t>(byte) & 3) == 0) {
      for (; end - byte >= 4; byte += 4) {
        detail::store_word(
            byte, (detail::load_word(byte) & ~(bit * kFour)) | drawn * kFour);
      }
      if (byte == end) {
        return;
      }
    }
    *byte = static_cast<uint8_t>((*byte & ~bit) | drawn);
    ++byte;
  }
}

}  // namespace

const detail::SinkKind detail::MonoPagesPixels::kKind = {
    detail::coverage_of<detail::MonoPagesPixels, cover>,
    detail::solid_of<detail::MonoPagesPixels, fill_run>,
    nullptr,
    nullptr,
    layout_of(PixelFormat::mono_pages),
    &inkcell::detail::kTwoLevelRule};

}  // namespace inkcell::port
