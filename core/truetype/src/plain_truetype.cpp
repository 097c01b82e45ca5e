#include "inkcell/truetype/plain_truetype.hpp"

#include "truetype_source.hpp"

namespace inkcell {
namespace detail {
namespace {

bool load_plain(GlyphJob& job) noexcept {
  return load_glyph(job, 10);
}

void fill_plain(GlyphJob& base) noexcept {
  auto& job = static_cast<TrueTypeJob&>(base);
  fill_glyph(job, job.plan.band_kind->paint);
}

constexpr Source kPlainTrueTypeSource = {
    prepare_glyph,       load_plain,           fill_plain,
    sizeof(TrueTypeJob), SourceKind::outlines, draw_truetype};

}  // namespace

// Name the objects of all painters, and of coverage from areas, as
// kOutlinePainters does.
extern PaintPoints* const kTrueTypePainters[];
PaintPoints* const kTrueTypePainters[] = {
    paint_areas, paint_crossings, paint_distances, paint_wide_distances};
extern decltype(cover_areas)* const kTrueTypeCover;
decltype(cover_areas)* const kTrueTypeCover = cover_areas;

}  // namespace detail

const Coding kPlainTrueTypeCoding = {255, &detail::kPlainTrueTypeSource};

}  // namespace inkcell
