// From painted rows to coverage, and into the sink.
#include "rows/band.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/assert.hpp"
#include "inkcell/ramp.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

// Sums that roundings carry below 0 or above 240, clamped, to coverage.
__attribute__((noinline)) uint32_t clamp_and_scale(uint32_t sums) noexcept {
  uint32_t coverage = 0;
  for (uint32_t shift = 0; shift != 32; shift += 8) {
    uint32_t sum = sums >> shift & 255;
    if (sum > 240) {
      sum = sum > 247 ? 0 : 240;
    }
    coverage |= (sum + (sum >> 4)) << shift;
  }
  return coverage;
}

// Four differences to coverage, 240 units to 255. `sum`: that of all pixels to
// the left, in both halves. Bytes 0 and 2 lie in one word, 1 and 3 in another,
// so that none carries into the next.
inline uint32_t cover_four(uint32_t bytes, uint32_t& sum) noexcept {
  uint32_t even = bytes & kEvenBytes;               // d0, d2
  uint32_t odd = even + (bytes >> 8 & kEvenBytes);  // d0 + d1, d2 + d3
  even += sum;
  even += odd << 16;
  even &= kEvenBytes;
  odd += sum + (odd << 16);
  odd &= kEvenBytes;
  sum = odd >> 16;
  sum |= sum << 16;
  const uint32_t sums = even | odd << 8;
  if (__builtin_expect(
          (((even + 0x000f000f) | (odd + 0x000f000f)) & 0x01000100) != 0, 0)) {
    return clamp_and_scale(sums);
  }
  return sums + (sums >> 4 & 0x0f0f0f0f);
}

// Four bytes of nearness and bits to coverage of any filter.
uint32_t filtered_word(uint32_t bytes,
                       uint32_t& inside,
                       const Filter& filter,
                       uint32_t step_q8) noexcept {
  uint32_t coverage = 0;
  for (uint32_t shift = 0; shift != 32; shift += 8) {
    const uint32_t byte = bytes >> shift & 255;
    inside ^= 0u - (byte & 1);
    // The middle of the step. [px, Q10]
    const auto distance_q10 =
        static_cast<int32_t>((255 - (byte & 254)) * step_q8 >> 8);
    coverage |=
        uint32_t{filter.coverage(inside != 0 ? distance_q10 : -distance_q10)}
        << shift;
  }
  return coverage;
}

constexpr uint32_t kSeveral = 1;

// What the pixels of a row up to the end of a word are: 0 or ~0 if all are that
// and fill the word, else kSeveral.
inline uint32_t kind_of(const uint8_t* at, int32_t count) noexcept {
  const uint32_t word = count == 4 ? load_pixels(at) : kSeveral;
  return word + 1 > 1 ? kSeveral : word;
}

// A band's words of four pixels, row by row. `cover` also has a `Left`, what it
// knows of the pixels to the left, all 0 at the beginning of a row.
template <typename Left, typename Cover>
inline void cover_words(const Band& band, const Cover& cover) noexcept {
  uint8_t* at = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    Left left = {};
    uint8_t* const end = at + row_bytes;
    do {
      store_pixels(at, cover(load_pixels(at), left));
      at += 4;
    } while (at != end);
    at += skipped;
  }
}

}  // namespace

void cover_areas(const Band& band, const Filter&) noexcept {
  struct Left {
    uint32_t sum;
    uint32_t last;  // the coverage of the pixel before, four times
  };
  cover_words<Left>(band, [](uint32_t bytes, Left& left) noexcept {
    if (__builtin_expect(bytes == 0, 1)) {
      return left.last;
    }
    const uint32_t coverage = cover_four(bytes, left.sum);
    left.last = (coverage >> 24) * 0x01010101u;
    return coverage;
  });
}

void cover_filtered(const Band& band, const Filter& filter) noexcept {
  // Half of what a 127th of the reach is. [px, Q18]
  const uint32_t step_q8 = static_cast<uint32_t>(band.reach_q8) * 1024 / 254;
  cover_words<uint32_t>(band, [&](uint32_t bytes, uint32_t& inside) noexcept {
    return bytes == 0 ? inside : filtered_word(bytes, inside, filter, step_q8);
  });
}

void cover_linear(const Band& band, const Filter&) noexcept {
  cover_words<uint32_t>(band, [](uint32_t bytes, uint32_t& inside) noexcept {
    return __builtin_expect(bytes == 0, 1) ? inside : ramp_word(bytes, inside);
  });
}

// To a sink that takes no blocks: runs of words that are covered, not covered,
// or in part.
void emit_row(const Sink& sink,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  INKCELL_ASSERT(sink.coverage != nullptr && sink.solid != nullptr);
  INKCELL_ASSERT(y >= sink.window.y0 && y < sink.window.y1);
  INKCELL_ASSERT(x >= sink.window.x0 && count >= 0 &&
                 count <= sink.window.x1 - x);
  const int32_t end = x + count;
  int32_t next = min((x | 3) + 1, end);
  uint32_t next_kind = kind_of(coverage, next - x);
  while (x != end) {
    const uint8_t* const begin = coverage;
    const int32_t from = x;
    const uint32_t kind = next_kind;
    do {
      coverage += next - x;
      x = next;
      next = min(x + 4, end);
      next_kind = kind_of(coverage, next - x);
    } while (x != end && next_kind == kind &&
             (kind != kSeveral || x - from <= kMaxSpan - 4));
    if (kind == kSeveral) {
      sink.coverage(sink.context, from, y, begin, x - from);
    } else if (kind != 0) {
      sink.solid(sink.context, from, y, x - from);
    }
  }
}

void emit(const Sink& sink,
          const Rect& pixels,
          const uint8_t* coverage,
          int32_t stride) noexcept {
  INKCELL_ASSERT(pixels.x0 >= sink.window.x0 && pixels.x1 <= sink.window.x1 &&
                 pixels.y0 >= sink.window.y0 && pixels.y1 <= sink.window.y1);
  INKCELL_ASSERT(stride % 4 == 0 && stride >= pixels.x1 - pixels.x0);
  if (sink.block != nullptr) {
    sink.block(sink.context, {pixels, coverage, stride});
    return;
  }
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    emit_row(sink, pixels.x0, y, coverage, pixels.x1 - pixels.x0);
    coverage += stride;
  }
}

void emit_band(GlyphJob& job) noexcept {
  const Band& band = job.band;
  const Rect& pixels = job.pixels;
  const BandKind& kind = *job.plan.band_kind;
  const Style& style = *job.style;
  if (const Effect* const effect = style.effect()) {
    effect->mixer().mix(*effect, job);
    return;
  }
  const Sink& sink = *job.sink;
  if (sink.ramp != nullptr && kind.is_ramp &&
      sink.ramp(sink.context, {pixels, band.bytes, band.stride})) {
    return;
  }
  kind.cover(band, style.filter());
  emit(sink, pixels, band.bytes + job.column, band.stride);
}

}  // namespace inkcell::detail
