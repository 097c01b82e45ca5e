// The mean of several pictures of a glyph, each moved by parts of a pixel.
#pragma once

#include <stdint.h>

#include "inkcell/mixer.hpp"

namespace inkcell::detail {

// For Mixer::mix, which adds pictures whose shares are 256 in sum. They
// are those of plain drawing, so that every filter of the style counts.
class Mean {
 public:
  // BandPlan::sample_bytes: of the band, and two of sums.
  static constexpr uint8_t kSampleBytes = 3;

  explicit Mean(GlyphBand& band) noexcept;

  // Adds the picture as it is painted.
  void add(uint32_t share) noexcept;
  // Adds another one, with the glyph so far from there. [px]
  void add(int32_t right_q8, int32_t down_q8, uint32_t share) noexcept {
    band_.repaint(right_q8 - right_q8_, down_q8 - down_q8_);
    right_q8_ = right_q8;
    down_q8_ = down_q8;
    add(share);
  }
  // Hands the mean to the sink.
  void emit() const noexcept;

 private:
  GlyphBand& band_;
  int32_t right_q8_ = 0;  // where the glyph is
  int32_t down_q8_ = 0;
};

}  // namespace inkcell::detail
