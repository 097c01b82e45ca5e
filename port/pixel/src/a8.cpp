// The canvas of 8-bit coverage.
#include "inkcell/port/a8.hpp"

#include "painted.hpp"
#include "run.hpp"
#include "word.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

// blend(c, 255, a) with one multiplication: 255 - (255 - c) * (255 - a) / 255.
uint32_t add(uint32_t above, uint32_t below) noexcept {
  return 255 - divide_by_255((255 - above) * (255 - below));
}

inline void put(uint8_t& pixel, uint32_t coverage) noexcept {
  if (__builtin_expect(pixel != 0, 0)) {
    coverage = add(coverage, pixel);
  }
  pixel = static_cast<uint8_t>(coverage);
}

// Whether two addresses have the same offset in a word, which is not 0.
inline bool lie_alike(const uint8_t* a, const uint8_t* b) noexcept {
  return ((reinterpret_cast<uintptr_t>(a) ^ reinterpret_cast<uintptr_t>(b)) &
          3) == 0;
}
inline bool is_within_word(const uint8_t* at) noexcept {
  return (reinterpret_cast<uintptr_t>(at) & 3) != 0;
}

// Words, at addresses that the core may load them from.
inline uint32_t load(const uint8_t* at) noexcept {
  return detail::kAnyAddress ? detail::load_any_word(at)
                             : detail::load_word(at);
}
inline void store(uint8_t* at, uint32_t word) noexcept {
  if (detail::kAnyAddress) {
    detail::store_any_word(at, word);
  } else {
    detail::store_word(at, word);
  }
}

void cover(const detail::A8Pixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + run.x;
  uint8_t* const end = pixel + run.count;
  // Most pixels are drawn onto empty ones.
  if (detail::kAnyAddress || lie_alike(pixel, coverage)) {
    while (!detail::kAnyAddress && is_within_word(pixel) && pixel != end) {
      put(*pixel++, *coverage++);
    }
    while (end - pixel >= 4 && load(pixel) == 0) {
      store(pixel, load(coverage));
      coverage += 4;
      pixel += 4;
    }
  }
  while (pixel != end) {
    put(*pixel++, *coverage++);
  }
}

constexpr auto kCoverage = detail::coverage_of<detail::A8Pixels, cover>;

// Four pixels onto any four.
__attribute__((noinline)) void put_four(uint8_t* pixel,
                                        uint32_t word) noexcept {
  uint8_t coverages[4];
  __builtin_memcpy(coverages, &word, 4);
  for (const uint8_t coverage : coverages) {
    put(*pixel++, coverage);
  }
}

// Coverage over what is there, for most pixels nothing.
inline void put_word(uint8_t* pixel, uint32_t word) noexcept {
  if (__builtin_expect(detail::load_word(pixel) == 0, 1)) {
    detail::store_word(pixel, word);
  } else {
    put_four(pixel, word);
  }
}

// The words of a row from `pixel` to `last`. The masks select the bytes of the
// first and the last word.
inline void put_words(uint8_t* pixel,
                      const uint8_t* last,
                      const uint8_t* from,
                      uint32_t first_mask,
                      uint32_t last_mask) noexcept {
  uint32_t word = detail::load_word(from) & first_mask;
  for (;;) {
    if (pixel == last) {
      word &= last_mask;
    }
    if (word != 0) {
      put_word(pixel, word);
    }
    if (pixel == last) {
      return;
    }
    pixel += 4;
    from += 4;
    word = detail::load_word(from);
  }
}

void block(void* context, const CoverageBlock& given) noexcept {
  const Strip& strip = static_cast<const detail::A8Pixels*>(context)->strip;
  CoverageBlock block = given;
  if (!detail::clip(strip, block)) {
    return;
  }
  const Rect& pixels = block.pixels;
  const int32_t rows = pixels.y1 - pixels.y0;
  const uint8_t* from = block.coverage;
  // Words begin where x is a multiple of 4.
  const int32_t before = pixels.x0 & 3;
  const int32_t first = pixels.x0 - before;
  const int32_t last = (pixels.x1 - 1) & ~3;
  uint8_t* to =
      detail::row_at(strip, pixels.y0 - strip.y0) + (first - strip.x0);
  if (first >= strip.x0 && last + 4 <= strip.x0 + strip.width &&
      !is_within_word(to) && (strip.stride & 3) == 0) {
    const uint32_t first_mask =
        detail::bytes_from(static_cast<uint32_t>(before));
    const uint32_t last_mask =
        detail::bytes_to(static_cast<uint32_t>(pixels.x1 - 1 - last));
    from -= before;
    for (int32_t row = 0; row != rows; ++row) {
      put_words(to, to + (last - first), from, first_mask, last_mask);
      from += block.stride;
      to += strip.stride;
    }
    return;
  }
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    kCoverage(context, pixels.x0, y, from, pixels.x1 - pixels.x0);
    from += block.stride;
  }
}

bool cover_painted(void* context,
                   const CoverageBlock& block,
                   Painted bytes) noexcept {
  const Strip& strip = static_cast<const detail::A8Pixels*>(context)->strip;
  // Words begin where x is a multiple of 4.
  const uintptr_t first = reinterpret_cast<uintptr_t>(strip.pixels.data) -
                          static_cast<uintptr_t>(strip.x0);
  if (((first | static_cast<uintptr_t>(strip.stride)) & 3) != 0) {
    return false;
  }
  return detail::put_painted<1>(
      strip, block, bytes,
      [](uint8_t* pixel, uint32_t word) noexcept { put_word(pixel, word); });
}

void fill_run(const detail::A8Pixels& pixels, const Run& run) noexcept {
  __builtin_memset(detail::row_at(pixels.strip, run.y) + run.x, 255,
                   static_cast<size_t>(run.count));
}

}  // namespace

const detail::SinkKind detail::A8Pixels::kKind = {
    kCoverage, detail::solid_of<detail::A8Pixels, fill_run>, block,
    detail::kTakesPainted ? cover_painted : nullptr,
    layout_of(PixelFormat::a8)};

}  // namespace inkcell::port
