// Coverage times opacity, span by span.
#include "inkcell/kinetic/fade.hpp"

namespace inkcell {
namespace kinetic {
namespace {

// coverage opacity / 255, to the nearest.
uint8_t faded(uint32_t coverage, uint32_t opacity) noexcept {
  const uint32_t product = coverage * opacity + 128;
  return static_cast<uint8_t>((product + (product >> 8)) >> 8);
}

void pass_coverage(void* context,
                   int32_t x,
                   int32_t y,
                   const uint8_t* coverage,
                   int32_t count) {
  const Fade& fade = *static_cast<const Fade*>(context);
  uint8_t buffer[kMaxSpan];
  for (int32_t i = 0; i < count; ++i) {
    buffer[i] = faded(coverage[i], fade.opacity);
  }
  fade.target->coverage(fade.target->context, x, y, buffer, count);
}

void pass_solid(void* context, int32_t x, int32_t y, int32_t count) {
  const Fade& fade = *static_cast<const Fade*>(context);
  uint8_t buffer[kMaxSpan];
  for (uint8_t& value : buffer) {
    value = fade.opacity;
  }
  while (count > 0) {
    const int32_t part = count < kMaxSpan ? count : kMaxSpan;
    fade.target->coverage(fade.target->context, x, y, buffer, part);
    x += part;
    count -= part;
  }
}

}  // namespace

Sink make_sink(const Fade& fade) noexcept {
  if (fade.opacity == 255) {
    return *fade.target;
  }
  Sink sink;
  sink.window = fade.target->window;
  // Sinks pass their context back as it was given; `fade` is only read.
  sink.context = const_cast<Fade*>(&fade);
  sink.coverage = pass_coverage;
  sink.solid = pass_solid;
  return sink;
}

}  // namespace kinetic
}  // namespace inkcell
