// Fields, painted into bands: row by row, leaf by leaf.
//
// Samples lie on a lattice of whole steps, so that no picture depends on where
// a band begins. Along a row of an upright style the field of a leaf is a
// parabola. Its first sample in the leaf is computed; the others follow by two
// additions each. A new start every 16 samples, counted from the leaf's left
// edge, bounds the roundings.
//
//        |  leaf  |     leaf     | saturated |
//     .  o  +  +  o  +  +  +  +  o  .  .  .  .     o computed, + added
#pragma once

#include <stdint.h>

#include "field_sampler.hpp"
#include "inkcell/style.hpp"
#include "place/position.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

// A glyph at a place on the screen, sampled so many times a pixel. Has no
// constructor, because it lies in jobs (rows/source.hpp).
class FieldRows {
 public:
  // `shown_q8`: how far from the ink a sample may show something. [px] False:
  // none does.
  bool open(const GlyphField& field,
            const Style& style,
            const Placed& placed,
            int32_t shown_q8,
            int32_t columns,
            int32_t rows) noexcept;

  // The pixels that may show something.
  Rect box(const Placed& placed) const noexcept;

  // Fills a cleared band whose first sample begins there on the screen.
  // [samples]
  void fill(const Band& band,
            BandBytes kind,
            int32_t x_q8,
            int32_t y_q8) const noexcept;

  // Where the centre lies of the sample that begins there.
  FieldPlace place_of(int64_t x_q8, int64_t y_q8) const noexcept;

  const GlyphField& field() const noexcept { return *field_; }
  const Style& style() const noexcept { return *style_; }
  // From a sample to the next one.
  const GlyphStep& right() const noexcept { return right_; }
  const GlyphStep& up() const noexcept { return up_; }
  // The box of what may show, from the origin, y up. [u]
  const Rect& limits() const noexcept { return limits_; }

 private:
  void fill_crossings(const Band& band, FieldPlace first) const noexcept;

  const GlyphField* field_;
  const Style* style_;
  Rect limits_;
  GlyphStep right_;
  GlyphStep up_;
  int64_t x_q10_;  // the origin [samples, y down]
  int64_t y_q10_;
  uint8_t columns_;
  uint8_t rows_;
};

}  // namespace inkcell::detail
