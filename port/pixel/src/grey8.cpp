// The sink for 8-bit grey.
#include "inkcell/port/grey8.hpp"

#include "run.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const Grey8Target*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  coverage += run.skipped;
  uint8_t* pixel = detail::row_at(target.strip, run.y) + run.x;
  for (uint8_t* const end = pixel + run.count; pixel != end; ++pixel) {
    *pixel = static_cast<uint8_t>(blend(*coverage++, target.level, *pixel));
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const Grey8Target*>(context);
  Run run{x, y, count, 0};
  if (detail::clip(target.strip, run)) {
    __builtin_memset(detail::row_at(target.strip, run.y) + run.x, target.level,
                     static_cast<size_t>(run.count));
  }
}

}  // namespace

Status make_sink(Grey8Target& target, Sink& out) noexcept {
  static constexpr detail::SinkKind kKind = {
      coverage, solid, detail::layout_of(PixelFormat::grey8)};
  return detail::open_sink(target.strip, kKind, &target, out);
}

}  // namespace port
}  // namespace inkcell
