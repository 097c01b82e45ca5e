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

__attribute__((always_inline)) inline bool open_at(
    OpenGlyph& opened,
    const OutlineJob& job,
    const GlyphMetrics& metrics,
    const Placed& placed) noexcept {
  const OutlinePlan& plan = opened.plan;
  return opened.glyph.open(
      job.font, metrics, job.record, job.style, placed,
      {plan.painter->origin_q8, plan.shown_q8, plan.columns, plan.rows},
      opened.warp);
}

// Not inline: its arguments are off the stack while the maps are made.
__attribute__((noinline)) bool open_with_maps(OpenGlyph& opened,
                                              const OutlineJob& job,
                                              const GlyphMetrics& metrics,
                                              const Placed& placed) noexcept {
  return open_at(opened, job, metrics, placed);
}

bool open_fitted(OpenGlyph& opened, const OutlineJob& job) noexcept {
  GlyphMetrics metrics;
  if (job.font.glyph_metrics(job.glyph, metrics) != Status::ok) {
    return false;
  }
  GlyphWarp& warp = *opened.warp;
  FinePoint origin = job.placed.origin();
  job.style.fitter()->fit(job.glyph, metrics, job.style.fitter_options(),
                          origin, warp);
  if ((warp.x.count | warp.y.count) == 0) {
    opened.warp = nullptr;
  }
  Placed placed;
  return placed.set(origin) && open_with_maps(opened, job, metrics, placed);
}

}  // namespace

const OutlineFitter kOutlineFitter = {open_fitted, warp_points};

bool open_outline(OpenGlyph& opened, const OutlineJob& job) noexcept {
  if (!plan_for(job.style, opened.plan)) {
    return false;
  }
  if (job.style.is_fitted()) {
    return job.style.outline_fitter().open(opened, job);
  }
  opened.warp = nullptr;
  GlyphMetrics metrics;
  return job.font.glyph_metrics(job.glyph, metrics) == Status::ok &&
         open_at(opened, job, metrics, job.placed);
}

// Not inline: most glyphs do not need its part of the stack.
__attribute__((noinline)) static bool open_for_box(
    OpenGlyph& opened, const OutlineJob& job) noexcept {
  GlyphWarp room;
  opened.warp = &room;
  const bool is_shown = open_outline(opened, job);
  opened.warp = nullptr;
  return is_shown;
}

Rect outline_box(const Font& font,
                 uint16_t glyph,
                 Span<const uint8_t> record,
                 const TextStyle& style,
                 const Placed& placed) noexcept {
  OpenGlyph opened;
  const OutlineJob job = {font, record, style, placed, glyph};
  const bool is_shown =
      style.is_fitted() ? open_for_box(opened, job) : open_outline(opened, job);
  return is_shown ? opened.glyph.box() : Rect{};
}

}  // namespace detail
}  // namespace inkcell
