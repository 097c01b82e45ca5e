#include "counting_sink.hpp"

namespace inkcell::tools {

Sink CountingSink::sink() {
  // Not a copy: functions that are not counted here would get this context.
  Sink result;
  result.window = target_.window;
  result.context = this;
  result.coverage = [](void* context, int32_t x, int32_t y,
                       const uint8_t* coverage, int32_t count) noexcept {
    CountingSink& self = *static_cast<CountingSink*>(context);
    self.add_span(count);
    self.target_.coverage(self.target_.context, x, y, coverage, count);
  };
  if (target_.coverage_rgb != nullptr) {
    result.coverage_rgb = [](void* context, int32_t x, int32_t y,
                             const uint8_t* coverage, int32_t count) noexcept {
      CountingSink& self = *static_cast<CountingSink*>(context);
      self.add_span(count);
      self.target_.coverage_rgb(self.target_.context, x, y, coverage, count);
    };
  }
  if (target_.block != nullptr) {
    result.block = [](void* context, const CoverageBlock& block) noexcept {
      CountingSink& self = *static_cast<CountingSink*>(context);
      const Rect& pixels = block.pixels;
      self.stats_.coverage_blocks += 1;
      self.stats_.coverage_pixels +=
          int64_t{pixels.x1 - pixels.x0} * (pixels.y1 - pixels.y0);
      self.target_.block(self.target_.context, block);
    };
  }
  result.solid = [](void* context, int32_t x, int32_t y,
                    int32_t count) noexcept {
    CountingSink& self = *static_cast<CountingSink*>(context);
    ++self.stats_.solid_runs;
    self.stats_.solid_pixels += count;
    self.target_.solid(self.target_.context, x, y, count);
  };
  return result;
}

void CountingSink::add_span(int32_t count) {
  ++stats_.coverage_spans;
  stats_.coverage_pixels += count;
}

}  // namespace inkcell::tools
