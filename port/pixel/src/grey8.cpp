// The sink for 8-bit grey.
#include "inkcell/port/grey8.hpp"

#include "run.hpp"

namespace inkcell::port {
namespace {

using detail::Run;

void cover(const detail::Grey8Pixels& pixels,
           const Run& run,
           const uint8_t* coverage) noexcept {
  uint8_t* pixel = detail::row_at(pixels.strip, run.y) + run.x;
  for (uint8_t* const end = pixel + run.count; pixel != end; ++pixel) {
    *pixel = static_cast<uint8_t>(blend(*coverage++, pixels.level, *pixel));
  }
}

void fill_run(const detail::Grey8Pixels& pixels, const Run& run) noexcept {
  __builtin_memset(detail::row_at(pixels.strip, run.y) + run.x, pixels.level,
                   static_cast<size_t>(run.count));
}

}  // namespace

const detail::SinkKind detail::Grey8Pixels::kKind = {
    detail::coverage_of<detail::Grey8Pixels, cover>,
    detail::solid_of<detail::Grey8Pixels, fill_run>, nullptr, nullptr,
    layout_of(PixelFormat::grey8)};

}  // namespace inkcell::port
