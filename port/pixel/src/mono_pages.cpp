// The sink for 1-bit pages of 8 rows.
#include "inkcell/port/mono_pages.hpp"

#include "run.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

// The byte of a run's first pixel, and the bit of its row in all its bytes.
uint8_t* first_byte(const Strip& strip, const Run& run) noexcept {
  return detail::row_at(strip, run.y >> 3) + run.x;
}

uint32_t row_bit(const Run& run) noexcept {
  return 1u << (run.y & 7);
}

void put(uint8_t& byte, uint32_t bit, uint8_t level) noexcept {
  byte = static_cast<uint8_t>(level != 0 ? byte | bit : byte & ~bit);
}

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const MonoPagesTarget*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  coverage += run.skipped;
  uint8_t* byte = first_byte(target.strip, run);
  for (uint8_t* const end = byte + run.count; byte != end; ++byte) {
    if (*coverage++ >= target.threshold) {
      put(*byte, row_bit(run), target.level);
    }
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const MonoPagesTarget*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  uint8_t* byte = first_byte(target.strip, run);
  for (uint8_t* const end = byte + run.count; byte != end; ++byte) {
    put(*byte, row_bit(run), target.level);
  }
}

}  // namespace

Status make_sink(MonoPagesTarget& target, Sink& out) noexcept {
  if (target.threshold == 0 || target.level > 1) {
    return Status::bad_argument;
  }
  return detail::open_sink(target.strip, PixelFormat::mono_pages,
                           {{}, &target, coverage, solid}, out);
}

}  // namespace port
}  // namespace inkcell
