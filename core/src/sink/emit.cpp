#include "sink/emit.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/assert.hpp"

namespace inkcell {
namespace detail {
namespace {

constexpr uint32_t kMixed = 1;

// What the pixels of a row up to the end of a word are: 0 or ~0 if all are that
// and fill the word, else kMixed.
inline uint32_t kind_of(const uint8_t* at, int32_t count) noexcept {
  const uint32_t word = count == 4 ? load_pixels(at) : kMixed;
  return word + 1 > 1 ? kMixed : word;
}

}  // namespace

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
             (kind != kMixed || x - from <= kMaxSpan - 4));
    if (kind == kMixed) {
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

void emit_rgb(const Sink& sink,
              const Rect& pixels,
              const uint8_t* coverage,
              int32_t stride) noexcept {
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    const uint8_t* at = coverage;
    for (int32_t x = pixels.x0; x < pixels.x1; x += kMaxSpan) {
      sink.coverage_rgb(sink.context, x, y, at, min(kMaxSpan, pixels.x1 - x));
      at += kMaxSpan * 3;
    }
    coverage += stride;
  }
}

}  // namespace detail
}  // namespace inkcell
