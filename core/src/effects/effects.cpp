#include "inkcell/effects.hpp"

#include "base/math.hpp"
#include "effects/mixed_cells.hpp"

namespace inkcell {
namespace detail {
namespace {

// The plan of a mixer that both codings share.
BandPlan plan_of(const TextStyle& style) noexcept {
  BandPlan plan;
  const Filter& filter = style.filter();
  plan.widen(filter);
  plan.shown_q8 = max(-filter.outside_q10 >> 2, 0) + 1;
  style.effect().mixer->plan(style, plan);
  return plan;
}

void mix_toggled(GlyphJob& job) {
  toggle_rows(job.band);
  job.style->effect().mixer->mix(job);
}

}  // namespace

void paint_mixed_cells(const GlyphField& field,
                       const TextStyle& style,
                       const void*,
                       const FinePoint& origin,
                       const Sink& sink) {
  mix_cells(field, style, origin, sink, plan_of(style), nullptr, mix_toggled);
}

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
