#include "field_source.hpp"

#include "base/math.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/format/rom.hpp"
#include "rows/source.hpp"

#ifndef INKCELL_ONLY_STRIKES
namespace inkcell {
namespace detail {
namespace {

static_assert(sizeof(FieldJob) <= kMostJob, "");

bool prepare_field(FieldJob& job, const Placed& placed) noexcept {
  const BandPlan& plan = job.plan;
  job.placed = placed;
  if (!job.rows.open(job.field, *job.style, placed,
                     plan.ink_margin_q8 + max(plan.moved_x_q8, plan.moved_y_q8),
                     plan.columns, plan.rows)) {
    return false;
  }
  job.box = job.rows.box(placed);
  return !is_empty(job.box);
}

bool prepare_glyph(GlyphJob& base,
                   const GlyphRef& ref,
                   const Placed& placed) noexcept {
  auto& job = static_cast<FieldJob&>(base);
  return read_field(*static_cast<const Font*>(ref.from), ref.glyph,
                    job.field) == Status::ok &&
         prepare_field(job, placed);
}

bool prepare_single(GlyphJob& base,
                    const GlyphRef& ref,
                    const Placed& placed) noexcept {
  auto& job = static_cast<FieldJob&>(base);
  job.field = *static_cast<const GlyphField*>(ref.from);
  return prepare_field(job, placed);
}

bool load_none(GlyphJob&) noexcept {
  return true;
}

void fill_field(GlyphJob& base) noexcept {
  const auto& job = static_cast<FieldJob&>(base);
  job.rows.fill(job.band, job.plan.band_kind->bytes, job.band_x_q8(),
                job.band_y_q8());
}

constexpr Source kFieldSource = {prepare_glyph,      load_none,
                                 fill_field,         sizeof(FieldJob),
                                 SourceKind::fields, draw_banded};
constexpr Source kSingleFieldSource = {prepare_single,     load_none,
                                       fill_field,         sizeof(FieldJob),
                                       SourceKind::fields, nullptr};

}  // namespace

// Bring the objects of what draws fields on canvases of few levels, and of
// coverage from areas. Nobody reads them, so that the linker drops them.
extern const LevelRule* const kFieldRules[];
const LevelRule* const kFieldRules[] = {&kTwoLevelRule, &kFourLevelRule};
extern decltype(cover_areas)* const kFieldCover;
decltype(cover_areas)* const kFieldCover = cover_areas;

}  // namespace detail

const Coding kFieldCoding = {static_cast<uint8_t>(format::Coding::field),
                             &detail::kFieldSource};

void draw_field(const GlyphField& field,
                const Style& style,
                FinePoint origin,
                const Sink& sink,
                Workspace workspace) noexcept {
  detail::Placed placed;
  if (placed.set(origin)) {
    detail::draw_bands(
        {{&detail::kSingleFieldSource, &field, 0}, style, placed, &sink},
        workspace);
  }
}

Rect field_box(const GlyphField& field,
               const Style& style,
               FinePoint origin) noexcept {
  detail::Placed placed;
  return placed.set(origin)
             ? detail::band_box({{&detail::kSingleFieldSource, &field, 0},
                                 style,
                                 placed,
                                 nullptr})
             : Rect();
}

void distance_row(const GlyphField& field,
                  const Style& style,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept {
  detail::Placed placed;
  const bool is_near = placed.set(origin);
  detail::FieldRows rows;
  static_cast<void>(rows.open(field, style, placed, 0, 1, 1));
  detail::FieldSampler sampler(field);
  for (Q6_10& distance : out) {
    distance.raw = INT16_MIN;
    if (is_near) {
      distance.raw = static_cast<int16_t>(
          detail::min(detail::screen_distance_q10(
                          style, sampler,
                          rows.place_of(int64_t{x} * 256, int64_t{y} * 256)),
                      INT16_MAX));
    }
    ++x;
  }
}

}  // namespace inkcell
#endif
