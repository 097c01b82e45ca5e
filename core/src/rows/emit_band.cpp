// From painted rows to coverage, and into the sink.
#include "rows/band.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/assert.hpp"
#include "inkcell/painted.hpp"
#include "rows/cover_words.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

// Painted::ramp with any filter: a pixel at a time.
struct FilteredWords {
  const Filter& filter;
  uint32_t step_q8;  // half of what a 127th of the reach is [px, Q18]
  uint32_t inside = 0;

  uint32_t same() const noexcept { return inside; }

  uint32_t next(uint32_t bytes) noexcept {
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
};

constexpr uint32_t kSeveral = 1;

// What the pixels of a row up to the end of a word are: 0 or ~0 if all are that
// and fill the word, else kSeveral.
inline uint32_t kind_of(const uint8_t* at, int32_t count) noexcept {
  const uint32_t word = count == 4 ? load_pixels(at) : kSeveral;
  return word + 1 > 1 ? kSeveral : word;
}

}  // namespace

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

void cover_filtered(const Band& band, const Filter& filter) noexcept {
  const uint32_t step_q8 = static_cast<uint32_t>(band.reach_q8) * 1024 / 254;
  cover_words(band, FilteredWords{filter, step_q8});
}

void cover_linear(const Band& band, const Filter&) noexcept {
  cover_words(band, RampWords{});
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
  if (sink.painted != nullptr && kind.painted != Painted::other &&
      sink.painted(sink.context, {pixels, band.bytes, band.stride},
                   kind.painted)) {
    return;
  }
  kind.cover(band, style.filter());
  emit(sink, pixels, band.bytes + job.column, band.stride);
}

}  // namespace inkcell::detail
