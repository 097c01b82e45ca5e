// The sink for 8-bit coverage.
#include "inkcell/port/a8.hpp"

#include "run.hpp"
#include "word.hpp"

namespace inkcell {
namespace port {

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

// Whether two addresses lie alike in a word, and whether one begins none.
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

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const Strip& strip = static_cast<const A8Target*>(context)->strip;
  Run run{x, y, count, 0};
  if (!detail::clip(strip, run)) {
    return;
  }
  coverage += run.skipped;
  uint8_t* pixel = detail::row_at(strip, run.y) + run.x;
  uint8_t* const end = pixel + run.count;
  // Most pixels are drawn where nothing was.
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

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const Strip& strip = static_cast<const A8Target*>(context)->strip;
  Run run{x, y, count, 0};
  if (detail::clip(strip, run)) {
    __builtin_memset(detail::row_at(strip, run.y) + run.x, 255,
                     static_cast<size_t>(run.count));
  }
}

}  // namespace

Status make_sink(A8Target& target, Sink& out) noexcept {
  static constexpr detail::SinkKind kKind = {
      coverage, solid, detail::layout_of(PixelFormat::a8)};
  return detail::open_sink(target.strip, kKind, &target, out);
}

}  // namespace port
}  // namespace inkcell
