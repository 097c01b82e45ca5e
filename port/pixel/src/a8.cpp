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
  int32_t left = run.count;
  // Most pixels are drawn where nothing was.
  while (detail::kAnyAddress && left >= 4 &&
         detail::load_any_word(pixel) == 0) {
    detail::store_any_word(pixel, detail::load_any_word(coverage));
    coverage += 4;
    pixel += 4;
    left -= 4;
  }
  for (uint8_t* const end = pixel + left; pixel != end; ++pixel) {
    uint32_t sum = *coverage++;
    if (__builtin_expect(*pixel != 0, 0)) {
      sum = add(sum, *pixel);
    }
    *pixel = static_cast<uint8_t>(sum);
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
