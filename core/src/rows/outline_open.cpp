#include "rows/outline_open.hpp"

#include "base/math.hpp"
#include "rows/outline_draw.hpp"
#include "rows/point_warp.hpp"

namespace inkcell {
namespace detail {

namespace {

// False: the style was not made.
bool plan_for(const TextStyle& style, OutlinePlan& plan) noexcept {
  // Room for roundings.
  constexpr int32_t kMore = 4;
  const OutlineMixer* const mixer = style.effect().outlines;
  plan = {};
  plan.painter = mixer == nullptr ? style.outline_painter() : mixer->painter;
  if (plan.painter == nullptr) {
    return false;
  }
  const int32_t reach_q8 = plan.painter->reach_q8;
  if (reach_q8 != 0) {
    plan.outside_q8 = reach_q8;
    plan.shown_q8 = 128 + kMore;
  } else {
    const Filter& filter = style.filter();
    plan.widen(filter);
    plan.shown_q8 = (max(-filter.outside_q10, 0) >> 2) + kMore;
  }
  if (mixer != nullptr) {
    mixer->plan(style, plan);
  }
  return true;
}

bool open_at(const Opening& opening,
             const OutlineJob& job,
             const GlyphMetrics& metrics,
             const Placed& placed) noexcept {
  const OutlinePlan& plan = opening.plan;
  return opening.glyph.open(
      job.font, metrics, job.record, job.style, placed,
      {plan.painter->origin_q8, plan.shown_q8, plan.columns, plan.rows},
      opening.warp);
}

bool open_fitted(const Opening& opening,
                 const OutlineJob& job,
                 const GlyphMetrics& metrics) noexcept {
  GlyphWarp& warp = *opening.fitted;
  FinePoint origin = job.placed.origin();
  job.style.fitter()->fit(job.glyph, metrics, job.style.fitter_options(),
                          origin, warp);
  if ((warp.x.count | warp.y.count) != 0) {
    opening.warp = &warp;
  }
  Placed placed;
  return placed.set(origin) && open_at(opening, job, metrics, placed);
}

}  // namespace

const OutlineFitter kOutlineFitter = {open_fitted, warp_points};

bool open_outline(const Opening& opening, const OutlineJob& job) noexcept {
  opening.warp = nullptr;
  if (!plan_for(job.style, opening.plan)) {
    return false;
  }
  GlyphMetrics metrics;
  if (job.font.glyph_metrics(job.glyph, metrics) != Status::ok) {
    return false;
  }
  if (job.style.is_fitted()) {
    return job.style.outline_fitter().open(opening, job, metrics);
  }
  return open_at(opening, job, metrics, job.placed);
}

// Not inline: most glyphs do not need its part of the stack.
__attribute__((noinline)) static bool open_with_maps(
    Opening& opening, const OutlineJob& job) noexcept {
  GlyphWarp fitted;
  opening.fitted = &fitted;
  const bool is_shown = open_outline(opening, job);
  opening.fitted = nullptr;
  return is_shown;
}

Rect outline_box(const Font& font,
                 uint16_t glyph,
                 Span<const uint8_t> record,
                 const TextStyle& style,
                 const Placed& placed) noexcept {
  OutlineGlyph opened;
  OutlinePlan plan;
  const GlyphWarp* warp;
  Opening opening = {opened, plan, warp, nullptr};
  const OutlineJob job = {font, record, style, placed, glyph};
  const bool is_shown = style.is_fitted() ? open_with_maps(opening, job)
                                          : open_outline(opening, job);
  return is_shown ? opened.box() : Rect{};
}

}  // namespace detail
}  // namespace inkcell
