#include "rows/wide_areas.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/area_painter.hpp"

namespace inkcell::detail {
namespace {

struct WordRows {
  using Pixel = uint16_t;
};

// A pixel's sum, of whatever direction, to coverage.
uint32_t coverage_of(int32_t sum) noexcept {
  constexpr int32_t kFull = 240;
  const int32_t shown = min(abs(sum), kFull);
  return static_cast<uint32_t>(shown + (shown >> 4));
}

// Two pixels of 16 bits in a word, the first and the second.
int32_t first_of(uint32_t word) noexcept {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return static_cast<int32_t>(word) >> 16;
#else
  return static_cast<int16_t>(word);
#endif
}
int32_t second_of(uint32_t word) noexcept {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return static_cast<int16_t>(word);
#else
  return static_cast<int32_t>(word) >> 16;
#endif
}

struct FourPixels {
  uint32_t words[2];

  explicit FourPixels(const uint8_t* at) noexcept {
    __builtin_memcpy(words, __builtin_assume_aligned(at, 4), sizeof words);
  }
  bool is_zero() const noexcept { return (words[0] | words[1]) == 0; }

  // A pixel after the other.
  __attribute__((noinline)) uint32_t any_coverage(int32_t sum) const noexcept {
    uint32_t coverage = 0;
    for (uint32_t i = 0; i != 4; ++i) {
      const uint32_t word = words[i >> 1];
      sum += (i & 1) == 0 ? first_of(word) : second_of(word);
      coverage |= coverage_of(sum) << 8 * i;
    }
    return coverage;
  }

  // `sum` goes on behind them.
  uint32_t coverage(int32_t& sum) const noexcept {
    const int32_t before = sum;
    const int32_t a = before + first_of(words[0]);
    const int32_t b = a + second_of(words[0]);
    const int32_t c = b + first_of(words[1]);
    sum = c + second_of(words[1]);
    const uint32_t sums =
        static_cast<uint32_t>(a) | static_cast<uint32_t>(b) << 8 |
        static_cast<uint32_t>(c) << 16 | static_cast<uint32_t>(sum) << 24;
    // Most are from 0 to 240.
    const uint32_t over = ((sums & 0x7f7f7f7f) + 0x0f0f0f0f) & sums;
    return __builtin_expect(
               ((a | b | c | sum) & ~255) == 0 && (over & 0x80808080) == 0, 1)
               ? sums + (sums >> 4 & 0x0f0f0f0f)
               : any_coverage(before);
  }
};

}  // namespace

void paint_wide_areas(const Band& band,
                      OutlineCursor& cursor,
                      const ScreenPoint* points,
                      const ScreenPoint* end) noexcept {
  AreaPainter<WordRows>::paint(band, cursor, points, end);
}

void cover_wide_rows(const Band& band, const uint8_t* wide) noexcept {
  uint8_t* to = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    int32_t sum = 0;
    uint32_t last = 0;  // the coverage of the last four pixels
    uint8_t* const end = to + row_bytes;
    do {
      // Pixels are read before the word is written, which lies no farther.
      const FourPixels pixels(wide);
      if (!pixels.is_zero()) {
        last = pixels.coverage(sum);
        store_pixels(to, last);
        to += 4;
        wide += 8;
        continue;
      }
      // Most follow each other.
      last = (last >> 24) * 0x01010101u;
      do {
        store_pixels(to, last);
        to += 4;
        wide += 8;
      } while (to != end && FourPixels(wide).is_zero());
    } while (to != end);
    to += skipped;
    wide += 2 * skipped;
  }
}

void cover_wide_areas(const Band& band, const Filter&) noexcept {
  cover_wide_rows(band, band.bytes);
}

}  // namespace inkcell::detail
