// Strokes, and strokes with what they enclose.
#include "inkcell/stroke.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/band.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

// Distances as far as both edges, whatever the style's filter is.
void plan_edges(const Stroke& stroke, BandPlan& plan) noexcept {
  plan.outside_q8 = 0;
  plan.inside_q8 = 0;
  plan.widen(stroke.outer);
  plan.widen(stroke.inner);
  plan.show(stroke.outer);
}

void plan_stroke(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  plan_edges(static_cast<const Stroke&>(effect), plan);
}

void plan_both(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  const Stroke& stroke = *static_cast<const StrokeAndFill&>(effect).stroke;
  plan_edges(stroke, plan);
  // Fills may lie outside of their strokes.
  plan.ink_margin_q8 = max(plan.ink_margin_q8, -stroke.inner.outside_q10 >> 2);
}

// A filter's coverage by steps of distance, a 254th of a band's reach each.
class StepRamp {
 public:
  StepRamp(const Filter& filter, int32_t reach_q8) noexcept
      : table_(filter.table),
        base_q8_(-filter.outside_q10 * filter.scale >> 6),
        step_q8_((reach_q8 * 1024 / 254 * filter.scale >> 14)) {}

  int32_t coverage(int32_t steps) const noexcept {
    const int32_t entry_q8 = base_q8_ + steps * step_q8_;
    if (static_cast<uint32_t>(entry_q8) < Filter::kEntries << 8) {
      return table_[entry_q8 >> 8];
    }
    return entry_q8 < 0 ? 0 : 255;
  }

 private:
  const uint8_t* table_;
  int32_t base_q8_;  // the edge's entry
  int32_t step_q8_;
};

// In place. Words without a byte lie beyond both ramps and stay 0: both filters
// cover all there, or none.
void mix_stroke(const Effect& effect, GlyphBand& glyph) noexcept {
  const auto& stroke = static_cast<const Stroke&>(effect);
  const Band& band = static_cast<const GlyphJob&>(glyph).band;
  const StepRamp outer(stroke.outer, band.reach_q8);
  const StepRamp inner(stroke.inner, band.reach_q8);
  for (int32_t row = 0; row != band.rows; ++row) {
    uint8_t* at = band.row(row);
    DistanceRow distances(at, band.reach_q8);
    for (uint8_t* const end = at + band.stride; at != end; at += 4) {
      if (load_pixels(at) == 0) {
        distances.skip_empty_word();
        continue;
      }
      uint32_t word = 0;
      for (uint32_t shift = 0; shift != 32; shift += 8) {
        const int32_t steps = distances.next_steps();
        const int32_t covered = outer.coverage(steps);
        if (covered != 0) {
          word |= static_cast<uint32_t>(max(covered - inner.coverage(steps), 0))
                  << shift;
        }
      }
      store_pixels(at, word);
    }
  }
  glyph.emit();
}

// Up to kMaxSpan pixels of a row, to both sinks.
__attribute__((noinline)) void mix_span(const StrokeAndFill& both,
                                        const Sink& sink,
                                        DistanceRow& distances,
                                        int32_t x,
                                        int32_t y,
                                        int32_t count) noexcept {
  const Stroke& edges = *both.stroke;
  // Words of pixels, as emit_row() takes them.
  alignas(4) uint8_t stroke_words[kMaxSpan + 4];
  alignas(4) uint8_t fill_words[kMaxSpan + 4];
  uint8_t* const stroke = stroke_words + (x & 3);
  uint8_t* const fill = fill_words + (x & 3);
  for (int32_t i = 0; i != count; ++i) {
    const int32_t d = distances.next_q10();
    fill[i] = edges.inner.coverage(d);
    // Where the fill is solid nothing of the stroke is left to see.
    stroke[i] = fill[i] == 255 ? uint8_t{0} : edges.outer.coverage(d);
  }
  emit_row(sink, x, y, stroke, count);
  emit_row(*both.fill, x, y, fill, count);
}

void mix_both(const Effect& effect, GlyphBand& band) noexcept {
  const auto& both = static_cast<const StrokeAndFill&>(effect);
  INKCELL_ASSERT(both.fill != nullptr);
  if (both.fill == nullptr) {
    return;
  }
  const Rect& all = band.pixels();
  const Rect shown = intersect(all, both.fill->window);
  for (int32_t y = shown.y0; y < shown.y1; ++y) {
    DistanceRow distances = band.distances(y);
    distances.skip(shown.x0 - all.x0);
    for (int32_t x = shown.x0; x < shown.x1; x += kMaxSpan) {
      mix_span(both, band.sink(), distances, x, y, min(kMaxSpan, shown.x1 - x));
    }
  }
}

}  // namespace

const Mixer kStrokeMixer = {kDistances, plan_stroke, mix_stroke};
const Mixer kStrokeAndFillMixer = {kDistances, plan_both, mix_both};

}  // namespace inkcell::detail
