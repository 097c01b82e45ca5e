// The sink for 1-bit rows.
#include "inkcell/port/mono_rows.hpp"

#include "packed.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const MonoRowsTarget*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  coverage += run.skipped;
  uint8_t* const row = detail::row_at(target.strip, run.y);
  const auto begin = static_cast<uint32_t>(run.x);
  const uint32_t end = begin + static_cast<uint32_t>(run.count);
  for (uint32_t column = begin; column != end; ++column) {
    if (*coverage++ >= target.threshold) {
      const uint32_t bit = 1u << detail::packed_shift(column, 0, target.order);
      uint8_t& byte = row[column >> 3];
      byte = static_cast<uint8_t>(target.level != 0 ? byte | bit : byte & ~bit);
    }
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const MonoRowsTarget*>(context);
  Run run{x, y, count, 0};
  if (detail::clip(target.strip, run)) {
    detail::fill_packed(detail::row_at(target.strip, run.y),
                        static_cast<uint32_t>(run.x),
                        static_cast<uint32_t>(run.count), 0,
                        target.level != 0 ? 0xff : 0, target.order);
  }
}

}  // namespace

Status make_sink(MonoRowsTarget& target, Sink& out) noexcept {
  if (target.threshold == 0 || target.level > 1) {
    return Status::bad_argument;
  }
  return detail::open_sink(target.strip, PixelFormat::mono_rows,
                           {{}, &target, coverage, solid}, out);
}

}  // namespace port
}  // namespace inkcell
