// Outlines, and outlines with what they enclose.
#include "inkcell/effects.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/distance_row.hpp"
#include "rows/mixer.hpp"
#include "sink/emit.hpp"

namespace inkcell {
namespace detail {
namespace {

const Filter& inner_of(const Style& style) noexcept {
  return *static_cast<const Filter*>(style.effect().options);
}
const OutlineAndFill& both_of(const Style& style) noexcept {
  return *static_cast<const OutlineAndFill*>(style.effect().options);
}

void plan_outline(const Style& style, BandPlan& plan) noexcept {
  plan.widen(inner_of(style));
}

void plan_both(const Style& style, BandPlan& plan) noexcept {
  const Filter& inner = *both_of(style).inner;
  plan.widen(inner);
  // Fills may lie outside of their outlines.
  plan.shown_q8 = max(plan.shown_q8, -inner.outside_q10 >> 2);
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
void mix_outline(GlyphJob& job) noexcept {
  const Band& band = job.band;
  const StepRamp outer(job.style->filter(), band.reach_q8);
  const StepRamp inner(inner_of(*job.style), band.reach_q8);
  for (int32_t row = 0; row != band.rows; ++row) {
    DistanceRow distances(band, row);
    uint8_t* at = band.row(row);
    for (uint8_t* const end = at + band.stride; at != end; at += 4) {
      if (load_pixels(at) == 0) {
        distances.skip_word();
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
  emit(*job.sink, job.pixels, band.bytes + job.column, band.stride);
}

// Up to kMaxSpan pixels of a row, to both sinks.
__attribute__((noinline)) void mix_span(const GlyphJob& job,
                                        DistanceRow& distances,
                                        int32_t x,
                                        int32_t y,
                                        int32_t count) noexcept {
  const OutlineAndFill& both = both_of(*job.style);
  // Words of pixels, as emit_row() takes them.
  alignas(4) uint8_t outline_words[kMaxSpan + 4];
  alignas(4) uint8_t fill_words[kMaxSpan + 4];
  uint8_t* const outline = outline_words + (x & 3);
  uint8_t* const fill = fill_words + (x & 3);
  for (int32_t i = 0; i != count; ++i) {
    const int32_t d = distances.next();
    fill[i] = both.inner->coverage(d);
    // Where the fill is solid nothing of the outline is left to see.
    outline[i] = fill[i] == 255 ? uint8_t{0} : job.style->filter().coverage(d);
  }
  emit_row(*job.sink, x, y, outline, count);
  emit_row(*both.fill, x, y, fill, count);
}

void mix_both(GlyphJob& job) noexcept {
  const Rect& all = job.pixels;
  const Rect shown = intersect(all, both_of(*job.style).fill->window);
  for (int32_t y = shown.y0; y < shown.y1; ++y) {
    DistanceRow distances(job.band, y - all.y0);
    distances.skip(job.column + shown.x0 - all.x0);
    for (int32_t x = shown.x0; x < shown.x1; x += kMaxSpan) {
      mix_span(job, distances, x, y, min(kMaxSpan, shown.x1 - x));
    }
  }
}

}  // namespace

const Mixer kOutlineMixer = {&kPaintWideDistances, plan_outline, mix_outline};
const Mixer kOutlineAndFillMixer = {&kPaintWideDistances, plan_both, mix_both};

}  // namespace detail

Status check_reach(const FontRange& range,
                   Q26_6 size,
                   const Filter& filter) noexcept {
  const int32_t reach_q10 = detail::max(-filter.outside_q10, filter.inside_q10);
  // The band is 1/1024 em, so that both sides are 1/1024 px, Q6.
  return int64_t{reach_q10} * 64 > (int64_t{range.band_u} + 1) * size.raw
             ? Status::beyond_band
             : Status::ok;
}

}  // namespace inkcell
