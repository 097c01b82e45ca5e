#include "rows/outline_source.hpp"

#include "base/math.hpp"
#include "inkcell/coding.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "place/style_parts.hpp"
#include "rows/area_painter.hpp"
#include "rows/crossings.hpp"
#include "rows/distance_painter.hpp"
#include "rows/outline_fit.hpp"
#include "rows/wide_painter.hpp"

namespace inkcell {
namespace detail {
namespace {

// Points at a time of a glyph that has more than there is room for: few, as
// each row that a band has less costs more than they do.
constexpr int32_t kPortion = 12;

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

// False: there are none.
bool load_points(OutlineJob& job) noexcept {
  uint8_t* begin = job.ram;
  if (job.warp != nullptr) {
    begin += sizeof(GlyphWarp);
  }
  uint8_t* const all_end = job.ram + job.ram_bytes;
  const auto size = static_cast<int32_t>(all_end - begin);
  // Half of it for points at most.
  const int32_t room =
      min(size / 2, size - kLeastBand) / int32_t{sizeof(ScreenPoint)};
  auto* const points = reinterpret_cast<ScreenPoint*>(begin);
  job.points = points;
  job.outline.rewind();
  ScreenPoint* end = read_points(job, room);
  const bool has_any = end != points;
  job.has_all = job.outline.is_done();
  if (!job.has_all) {
    end = points + min(kPortion, room);
  }
  job.ram = reinterpret_cast<uint8_t*>(end);
  job.ram_bytes = static_cast<int32_t>(all_end - job.ram);
  return has_any;
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
  const BandPlan& plan = job.plan;
  outline.find_box(placed, plan,
                   plan.band_kind->bytes == BandBytes::area ? 0 : 128, ink,
                   job.box);
  return job.sink == nullptr || (job.clip() && load_points(job));
}

// All points, or portions of those for which there is no room.
void fill_band(GlyphJob& base) noexcept {
  auto& job = static_cast<OutlineJob&>(base);
  const auto paint = job.plan.band_kind->paint;
  job.cursor.begin();
  const auto* end = reinterpret_cast<const ScreenPoint*>(job.ram);
  if (job.has_all) {
    paint(job.band, job.cursor, job.points, end);
    return;
  }
  const auto room = static_cast<int32_t>(end - job.points);
  job.outline.rewind();
  do {
    end = read_points(job, room);
    paint(job.band, job.cursor, job.points, end);
  } while (!job.outline.is_done());
}

constexpr Source kOutlineSource = {prepare_outline, fill_band,
                                   sizeof(OutlineJob), false};

}  // namespace

// Name the objects of all painters, for band_kind.cpp, and of what fits
// outlines on canvases of few levels. Nobody reads them, so that the linker
// drops them.
extern const LevelRule* const kOutlineRules[];
const LevelRule* const kOutlineRules[] = {&kTwoLevelRule, &kFourLevelRule};
extern const Fitter* const kOutlineFitters[];
const Fitter* const kOutlineFitters[] = {&kFitTwoLevels, &kFitFourLevels};
extern PaintPoints* const kOutlinePainters[];
PaintPoints* const kOutlinePainters[] = {paint_areas, paint_crossings,
                                         paint_distances, paint_wide_distances};

}  // namespace detail

const Coding kOutlineCoding = {static_cast<uint8_t>(format::Coding::outline),
                               &detail::kOutlineSource};

}  // namespace inkcell
