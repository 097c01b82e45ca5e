// Painted rows onto pixels, a word of four at a time: Sink::painted of formats
// that can.
#pragma once

#include <stdint.h>

#include "inkcell/painted.hpp"
#include "inkcell/strip.hpp"
#include "run.hpp"
#include "word.hpp"

namespace inkcell::port::detail {

/// It is speed for 400 bytes of code.
#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool kTakesPainted = false;
#else
inline constexpr bool kTakesPainted = kLittleEndian;
#endif

/// Masks of a word's bytes from `first` (0 to 3) on, and up to `last`.
inline uint32_t bytes_from(uint32_t first) noexcept {
  return kLittleEndian ? ~0u << 8 * first : ~0u >> 8 * first;
}
inline uint32_t bytes_to(uint32_t last) noexcept {
  return kLittleEndian ? ~0u >> (24 - 8 * last) : ~0u << (24 - 8 * last);
}

/// The bytes of a first and of a last word of a row that are drawn.
struct EndMasks {
  uint32_t first;
  uint32_t last;
};

/// A row of painted words, `from` to `last`; words of pixels have 4 * kBytes
/// bytes. put(pixel, coverage) draws four pixels.
template <int32_t kBytes, typename Words, typename Put>
inline void put_row(Words words,
                    uint8_t* pixel,
                    const uint8_t* from,
                    const uint8_t* const last,
                    const EndMasks& masks,
                    const Put& put) noexcept {
  const uint8_t* const first = from;
  const auto draw = [&](uint32_t coverage) noexcept {
    put(pixel + kBytes * (from - first), coverage);
  };
  uint32_t bytes = load_word(from);
  if (from != last) {
    const uint32_t coverage =
        (bytes == 0 ? words.same() : words.next(bytes)) & masks.first;
    if (coverage != 0) {
      draw(coverage);
    }
    from += 4;
    while (from != last) {
      bytes = load_word(from);
      if (bytes != 0) {
        draw(words.next(bytes));
        from += 4;
        continue;
      }
      // Most words lie outside or inside.
      const uint32_t same = words.same();
      if (same == 0) {
        from += 4;
        while (last - from >= 8 &&
               (load_word(from) | load_word(from + 4)) == 0) {
          from += 8;
        }
        if (from != last && load_word(from) == 0) {
          from += 4;
        }
      } else {
        do {
          draw(same);
          from += 4;
        } while (from != last && load_word(from) == 0);
      }
    }
    bytes = load_word(from);
  }
  const uint32_t coverage =
      (bytes == 0 ? words.same() : words.next(bytes)) & masks.last;
  if (coverage != 0) {
    draw(coverage);
  }
}

/// Sink::painted of pixels of kBytes bytes. False where words of four pixels do
/// not lie within the strip.
template <int32_t kBytes, typename Put>
inline bool put_painted(const Strip& strip,
                        const CoverageBlock& block,
                        Painted bytes,
                        const Put& put) noexcept {
  const Rect& pixels = block.pixels;
  const int32_t first = pixels.x0 & ~3;
  const int32_t last = (pixels.x1 - 1) & ~3;
  if (first < strip.x0 || last + 4 > strip.x0 + strip.width ||
      pixels.y0 < strip.y0 || pixels.y1 > strip.y0 + strip.height) {
    return false;
  }
  const auto before = static_cast<uint32_t>(pixels.x0 - first);
  EndMasks masks = {bytes_from(before),
                    bytes_to(static_cast<uint32_t>(pixels.x1 - 1 - last))};
  if (first == last) {
    masks.last &= masks.first;
  }
  uint8_t* to =
      row_at(strip, pixels.y0 - strip.y0) + kBytes * (first - strip.x0);
  const uint8_t* from = block.coverage;
  const uint8_t* end = from + (last - first);
  if (bytes == Painted::sums) {
    for (int32_t rows = pixels.y1 - pixels.y0; rows != 0; --rows) {
      put_row<kBytes>(SumWords{}, to, from, end, masks, put);
      to += strip.stride;
      from += block.stride;
      end += block.stride;
    }
    return true;
  }
  for (int32_t rows = pixels.y1 - pixels.y0; rows != 0; --rows) {
    RampWords words;
    if (before == 0) {
      // The pixel before has a word of its own.
      static_cast<void>(words.next(load_word(from)));
    }
    const int32_t skipped = before == 0 ? 4 : 0;
    put_row<kBytes>(words, to, from + skipped, end + skipped, masks, put);
    to += strip.stride;
    from += block.stride;
    end += block.stride;
  }
  return true;
}

}  // namespace inkcell::port::detail
