#include "rows/outline_source.hpp"

#include "base/math.hpp"
#include "inkcell/coding.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "place/style_parts.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {
namespace {

// Points at a time of a glyph that has more than there is room for: few, as
// each row that a band has less costs more than they do.
constexpr int32_t kPortion = 7;

static_assert(sizeof(OutlineJob) <= kMostJob);
static_assert(kPortion * sizeof(ScreenPoint) <= kMostLoaded);
static_assert(sizeof(GlyphWarp) % sizeof(uint32_t) == 0, "aligned");

// Not inline: most bands have all points, and fewer registers then.
__attribute__((noinline)) ScreenPoint* read_points(OutlineJob& job,
                                                   int32_t room) noexcept {
  ScreenPoint* const end = job.outline.read(job.points, room);
  if (job.warp != nullptr) {
    StyleParts::outline_fitter(*job.style).move(job, job.points, end);
  }
  return end;
}

}  // namespace

bool load_points(GlyphJob& base) noexcept {
  constexpr int32_t kBytes = sizeof(ScreenPoint);
  auto& job = static_cast<OutlineJob&>(base);
  // Room behind the edge at hand, where areas halve nothing, and that of maps
  // once all points are fitted.
  auto* end = reinterpret_cast<uint8_t*>(&job + 1);
  auto* out =
      job.guards != 0 ? end : reinterpret_cast<uint8_t*>(job.cursor.halves());
  const int32_t maps = job.style->is_fitted() ? kMaps : 0;
  auto room = static_cast<int32_t>(end - out);
  // Three eighths of the RAM for points at most.
  const int32_t most = min(job.ram_bytes * 3 >> 3, job.ram_bytes - kLeastBand);
  auto* points = reinterpret_cast<ScreenPoint*>(job.ram);
  job.points = points;
  job.outline.rewind();
  int32_t bytes =
      kBytes * static_cast<int32_t>(
                   read_points(job, max(most, min(room + maps, job.ram_bytes)) /
                                        kBytes) -
                   points);
  if (bytes == 0) {
    return false;
  }
  job.has_all = job.outline.is_done();
  if (job.has_all) {
    room += maps;
  } else {
    bytes = min(kPortion * kBytes, most);
  }
  job.count = static_cast<uint16_t>(bytes / kBytes);
  if (bytes <= room) {
    job.points = reinterpret_cast<ScreenPoint*>(out);
    __builtin_memcpy(out, points, static_cast<size_t>(bytes));
  } else {
    job.ram += bytes;
    job.ram_bytes -= bytes;
  }
  return true;
}

bool prepare_outline(GlyphJob& base,
                     const GlyphRef& ref,
                     const Placed& given) noexcept {
  auto& job = static_cast<OutlineJob&>(base);
  const Font& font = *static_cast<const Font*>(ref.from);
  const Style& style = *job.style;
  OutlineGlyph& outline = job.outline;
  InkEnds ink[2];
  if (!outline.find(font, ref.glyph, style.size(),
                    style.is_upright() ? nullptr : &style, ink,
                    job.band.is_mirrored)) {
    return false;
  }
  job.warp = nullptr;
  Placed placed = given;
  if (style.is_fitted() && !StyleParts::outline_fitter(style).fit(
                               job, font, ref.glyph, placed, ink)) {
    return false;
  }
  outline.find_box(placed, job.plan, job.guards * 128, ink, job.box);
  return true;
}

void fill_outline(GlyphJob& base) noexcept {
  auto& job = static_cast<OutlineJob&>(base);
  const auto paint = job.plan.band_kind->paint;
  job.cursor.begin(job.guards == 0);
  if (job.has_all) {
    paint(job.band, job.cursor, job.points, job.points + job.count);
    return;
  }
  job.outline.rewind();
  do {
    const ScreenPoint* const end = read_points(job, job.count);
    paint(job.band, job.cursor, job.points, end);
  } while (!job.outline.is_done());
}

#ifndef INKCELL_ONLY_STRIKES
static constexpr Source kOutlineSource = outline_source(draw_banded);

// Name the objects of all painters, for band.cpp, and of what fits
// outlines on canvases of few levels. Nobody reads them, so that the linker
// drops them.
extern const LevelRule* const kOutlineRules[];
const LevelRule* const kOutlineRules[] = {&kTwoLevelRule, &kFourLevelRule};
extern const Fitter* const kOutlineFitters[];
const Fitter* const kOutlineFitters[] = {&kFitTwoLevels, &kFitFourLevels};
extern PaintPoints* const kOutlinePainters[];
PaintPoints* const kOutlinePainters[] = {paint_areas, paint_crossings,
                                         paint_distances, paint_wide_distances};
extern decltype(cover_areas)* const kOutlineCover;
decltype(cover_areas)* const kOutlineCover = cover_areas;
#endif

}  // namespace detail

#ifndef INKCELL_ONLY_STRIKES
const Coding kOutlineCoding = {static_cast<uint8_t>(format::Coding::outline),
                               &detail::kOutlineSource};
#endif

}  // namespace inkcell
