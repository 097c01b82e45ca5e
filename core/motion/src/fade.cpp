// Coverage times opacity, span by span.
#include "inkcell/motion/fade.hpp"

#include "limits.hpp"

namespace inkcell::motion {
namespace {

// coverage opacity / 255, to the nearest.
uint8_t faded(uint32_t coverage, uint32_t opacity) noexcept {
  const uint32_t product = coverage * opacity + 128;
  return static_cast<uint8_t>((product + (product >> 8)) >> 8);
}

// Full coverage, by a function of a sink that takes coverage.
void pass_full(void* context,
               int32_t x,
               int32_t y,
               int32_t count,
               decltype(Sink::coverage) take) {
  uint8_t full[kMaxSpan];
  __builtin_memset(full, 255, sizeof full);
  for (; count > 0; count -= kMaxSpan, x += kMaxSpan) {
    take(context, x, y, full, min(count, kMaxSpan));
  }
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
  pass_full(context, x, y, count, pass_coverage);
}

// The opacity of a pixel between two sides, 0 to 255.
uint32_t opacity_between(int32_t low,
                         int32_t high,
                         uint8_t soft_low,
                         uint8_t soft_high,
                         int32_t at) noexcept {
  const auto near = [](int32_t inside, uint8_t soft) -> uint32_t {
    return inside < 0 ? 0
           : inside >= soft
               ? 255
               : static_cast<uint32_t>((2 * inside + 1) * 255 / (2 * soft));
  };
  const uint32_t first = near(at - low, soft_low);
  const uint32_t second = near(high - 1 - at, soft_high);
  return first < second ? first : second;
}

// Whether a span lies where the window is not soft.
bool is_clear(const SoftWindow& soft,
              int32_t x,
              int32_t y,
              int32_t count) noexcept {
  const Rect& window = soft.window;
  return x >= window.x0 + soft.soft.left &&
         x + count <= window.x1 - soft.soft.right &&
         y >= window.y0 + soft.soft.top && y < window.y1 - soft.soft.bottom;
}

void pass_soft(void* context,
               int32_t x,
               int32_t y,
               const uint8_t* coverage,
               int32_t count) {
  const SoftWindow& soft = *static_cast<const SoftWindow*>(context);
  if (is_clear(soft, x, y, count)) {
    soft.target->coverage(soft.target->context, x, y, coverage, count);
    return;
  }
  const Rect& window = soft.window;
  const uint32_t row =
      opacity_between(window.y0, window.y1, soft.soft.top, soft.soft.bottom, y);
  uint8_t buffer[kMaxSpan];
  for (int32_t i = 0; i < count; ++i) {
    const uint32_t column = opacity_between(
        window.x0, window.x1, soft.soft.left, soft.soft.right, x + i);
    buffer[i] = faded(faded(coverage[i], row), column);
  }
  soft.target->coverage(soft.target->context, x, y, buffer, count);
}

void pass_soft_solid(void* context, int32_t x, int32_t y, int32_t count) {
  const SoftWindow& soft = *static_cast<const SoftWindow*>(context);
  if (is_clear(soft, x, y, count)) {
    soft.target->solid(soft.target->context, x, y, count);
    return;
  }
  pass_full(context, x, y, count, pass_soft);
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

Sink make_sink(const SoftWindow& soft) noexcept {
  Sink sink;
  sink.window = intersect(soft.target->window, soft.window);
  sink.context = const_cast<SoftWindow*>(&soft);
  sink.coverage = pass_soft;
  sink.solid = pass_soft_solid;
  sink.levels = soft.target->levels;
  return sink;
}

}  // namespace inkcell::motion
