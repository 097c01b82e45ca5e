// The sink for 4-bit grey.
#include "inkcell/port/grey4.hpp"

#include "packed.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

constexpr uint32_t kBitsLog2 = 2;
constexpr uint8_t kMaxLevel = 15;
constexpr uint32_t kEveryPixel = 0x11;  // level 1 in all pixels of a byte

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const Grey4Target*>(context);
  Run run{x, y, count, 0};
  if (detail::clip(target.strip, run)) {
    detail::blend_packed(detail::row_at(target.strip, run.y),
                         static_cast<uint32_t>(run.x), coverage + run.skipped,
                         static_cast<uint32_t>(run.count), kBitsLog2,
                         target.level, target.order);
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const Grey4Target*>(context);
  Run run{x, y, count, 0};
  if (detail::clip(target.strip, run)) {
    detail::fill_packed(
        detail::row_at(target.strip, run.y), static_cast<uint32_t>(run.x),
        static_cast<uint32_t>(run.count), kBitsLog2,
        static_cast<uint8_t>(target.level * kEveryPixel), target.order);
  }
}

}  // namespace

Status make_sink(Grey4Target& target, Sink& out) noexcept {
  if (target.level > kMaxLevel) {
    return Status::bad_argument;
  }
  return detail::open_sink(target.strip, {1 << kBitsLog2, 0},
                           {{}, &target, coverage, solid}, out);
}

}  // namespace port
}  // namespace inkcell
