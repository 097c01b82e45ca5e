// The sink for 8-bit coverage.
#include "inkcell/port/a8.hpp"

#include "run.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

// blend(c, 255, a) with one multiplication: 255 - (255 - c) * (255 - a) / 255.
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
  for (uint8_t* const end = pixel + run.count; pixel != end; ++pixel) {
    const uint32_t above = *coverage++;
    const uint32_t below = *pixel;
    // Most pixels are drawn where nothing was.
    *pixel = static_cast<uint8_t>(
        below == 0 ? above
                   : 255 - divide_by_255((255 - above) * (255 - below)));
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
  return detail::open_sink(target.strip, PixelFormat::a8,
                           {{}, &target, coverage, solid}, out);
}

}  // namespace port
}  // namespace inkcell
