// The sink for 8-bit grey.
#include "inkcell/port/grey8.hpp"

#include "run.hpp"

namespace inkcell::port {

namespace {

using detail::Run;

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& pixels = *static_cast<const detail::Grey8Pixels*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(pixels.strip, run)) {
    return;
  }
  coverage += run.skipped;
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + run.x;
  for (uint8_t* const end = pixel + run.count; pixel != end; ++pixel) {
    *pixel = static_cast<uint8_t>(blend(*coverage++, pixels.level, *pixel));
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& pixels = *static_cast<const detail::Grey8Pixels*>(context);
  Run run{x, y, count, 0};
  if (detail::clip(pixels.strip, run)) {
    __builtin_memset(detail::row_at(pixels.strip, run.y) + run.x, pixels.level,
                     static_cast<size_t>(run.count));
  }
}

}  // namespace

const detail::SinkKind detail::Grey8Pixels::kKind = {
    coverage, solid, nullptr, nullptr, layout_of(PixelFormat::grey8)};

}  // namespace inkcell::port
