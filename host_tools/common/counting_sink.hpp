// A sink that counts what passes through it.
#pragma once

#include <cstdint>

#include "inkcell/strip.hpp"

namespace inkcell::tools {

/// The cost of drawing.
struct DrawStats {
  int64_t strips = 0;
  int64_t coverage_spans = 0;
  int64_t coverage_blocks = 0;  // of several rows
  int64_t coverage_pixels = 0;  // given one by one, and so computed
  int64_t solid_runs = 0;
  int64_t solid_pixels = 0;  // filled, not computed
};

/// Must not move; `stats` must outlive it.
class CountingSink {
 public:
  CountingSink(const Sink& target, DrawStats& stats)
      : target_(target), stats_(stats) {}
  CountingSink(const CountingSink&) = delete;
  CountingSink& operator=(const CountingSink&) = delete;

  /// A sink that forwards to the target.
  Sink sink();

 private:
  void add_span(int32_t count);

  Sink target_;
  DrawStats& stats_;
};

}  // namespace inkcell::tools
