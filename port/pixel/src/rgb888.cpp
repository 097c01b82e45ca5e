// The sink for three bytes a pixel.
#include "inkcell/port/rgb888.hpp"

#include "run.hpp"

namespace inkcell {
namespace port {

namespace {

using detail::Run;

// The colour's bytes in the order of memory.
struct Bytes {
  uint8_t byte[3];
};

Bytes bytes_of(const Rgb888Target& target) noexcept {
  const auto red = static_cast<uint8_t>(target.colour >> 16);
  const auto green = static_cast<uint8_t>(target.colour >> 8);
  const auto blue = static_cast<uint8_t>(target.colour);
  if (target.order == ChannelOrder::red_first) {
    return {{red, green, blue}};
  }
  return {{blue, green, red}};
}

void coverage(void* context,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const auto& target = *static_cast<const Rgb888Target*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  coverage += run.skipped;
  const Bytes colour = bytes_of(target);
  uint8_t* pixel = detail::row_at(target.strip, run.y) + 3 * run.x;
  for (uint8_t* const end = pixel + 3 * run.count; pixel != end; pixel += 3) {
    const uint32_t c = *coverage++;
    if (c != 0) {
      for (int i = 0; i < 3; ++i) {
        pixel[i] = static_cast<uint8_t>(blend(c, colour.byte[i], pixel[i]));
      }
    }
  }
}

void solid(void* context, int32_t x, int32_t y, int32_t count) noexcept {
  const auto& target = *static_cast<const Rgb888Target*>(context);
  Run run{x, y, count, 0};
  if (!detail::clip(target.strip, run)) {
    return;
  }
  const Bytes colour = bytes_of(target);
  uint8_t* pixel = detail::row_at(target.strip, run.y) + 3 * run.x;
  for (uint8_t* const end = pixel + 3 * run.count; pixel != end; pixel += 3) {
    pixel[0] = colour.byte[0];
    pixel[1] = colour.byte[1];
    pixel[2] = colour.byte[2];
  }
}

}  // namespace

Status make_sink(Rgb888Target& target, Sink& out) noexcept {
  static constexpr detail::SinkKind kKind = {
      coverage, solid, detail::layout_of(PixelFormat::rgb888)};
  return detail::open_sink(target.strip, kKind, &target, out);
}

}  // namespace port
}  // namespace inkcell
