#include "truetype_source.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/assert.hpp"
#include "inkcell/coding.hpp"
#include "inkcell/painter.hpp"
#include "rows/wide_areas.hpp"

namespace inkcell {
namespace detail {
namespace {

// Points at a time of a glyph that has more than there is room for.
constexpr int32_t kFewPoints = 12;
constexpr int32_t kPointBytes = sizeof(ScreenPoint);

static_assert(sizeof(TrueTypeJob) + kFewPoints * kPointBytes + 2 * kLeastBand <=
              kLeastLargeRam);
static_assert(sizeof(TrueTypeJob) - TrueTypeGlyph::kWorkBytes <= kMostJob);

// Not inline: its part of the stack is not needed where RAM is lent.
__attribute__((noinline)) void draw_on_own_stack(
    const GlyphCall& call) noexcept {
  alignas(GlyphJob) uint8_t bytes[kLeastLargeRam];
  draw_bands(call, {bytes, sizeof bytes});
}

// Bytes are coverage once a band is painted.
void cover_none(const Band&, const Filter&) noexcept {}
constexpr BandKind kCoveredBand = {nullptr, cover_none, BandBytes::area,
                                   Painted::other, 128};

bool load_wide(GlyphJob& job) noexcept {
  job.plan.band_kind = &kCoveredBand;
  // Rows of 16 bits begin where bands do, and take as much again. Where a mixer
  // has memory behind the band, which takes half of it at most and margins as
  // much as rows, they lie behind all.
  return load_glyph(job, job.plan.sample_bytes == 1 ? 5 : 4);
}

void fill_wide(GlyphJob& base) noexcept {
  auto& job = static_cast<TrueTypeJob&>(base);
  Band& band = job.band;
  uint8_t* const bytes = band.bytes;
  const int32_t size = band.rows * band.stride;
  if (job.plan.sample_bytes == 1) {
    clear_pixels(bytes + size, size);
  } else {
    band.bytes = job.ram + job.ram_bytes;
    clear_pixels(band.bytes, 2 * size);
  }
  fill_glyph(job, paint_wide_areas);
  const uint8_t* const wide = band.bytes;
  band.bytes = bytes;
  cover_wide_rows(band, wide);
}

constexpr Source kTrueTypeSource = {prepare_glyph,     load_wide,
                                    fill_wide,         sizeof(TrueTypeJob),
                                    SourceKind::areas, draw_truetype};

}  // namespace

void draw_truetype(GlyphRun& run,
                   uint16_t glyph,
                   const Placed& placed) noexcept {
  const Font& font = *run.font;
  const Style& style = *run.style;
  const Workspace& ram = run.painter.ram();
  INKCELL_ASSERT(font.check(style) == Status::ok);
  const GlyphCall call = {
      {font.source(), &font, glyph}, style, placed, &run.painter.sink()};
  if (ram.size < kLeastLargeRam + alignof(GlyphJob)) {
    draw_on_own_stack(call);
  } else {
    draw_bands(call, ram);
  }
}

bool prepare_glyph(GlyphJob& base,
                   const GlyphRef& ref,
                   const Placed& placed) noexcept {
  auto& job = static_cast<TrueTypeJob&>(base);
  InkEnds ink[2];
  // Distances are refused by check() where contours may overlap.
  if ((job.source->kind == SourceKind::areas && job.guards != 0) ||
      !job.outline.find(*static_cast<const Font*>(ref.from), ref.glyph,
                        *job.style, ink, job.band.is_mirrored)) {
    return false;
  }
  Placed at = placed;
  // The baseline lies between two rows.
  const int32_t part = ((at.y_q10 + 512) & 1023) - 512;
  at.y_q10 -= part * fit_strength_q8(*job.style) >> 8;
  job.outline.find_box(at, job.plan, job.guards * 128, ink, job.box);
  return true;
}

bool load_glyph(GlyphJob& base, int32_t tenths) noexcept {
  auto& job = static_cast<TrueTypeJob&>(base);
  // Half of the RAM for points at most.
  const int32_t most =
      min(job.ram_bytes / 2, job.ram_bytes - 2 * kLeastBand) / kPointBytes;
  job.points = reinterpret_cast<ScreenPoint*>(job.ram);
  job.outline.rewind();
  auto count =
      static_cast<int32_t>(job.outline.read(job.points, most) - job.points);
  if (count == 0) {
    return false;
  }
  job.has_all = job.outline.is_done();
  if (!job.has_all) {
    count = min(kFewPoints, most);
  }
  job.count = static_cast<uint16_t>(count);
  uint8_t* const end = job.ram + job.ram_bytes;
  const Rect& shown = job.pixels;
  if (job.has_all &&
      product(2 * (shown.x1 - shown.x0), shown.y1 - shown.y0) > job.ram_bytes) {
    // Down, for more rows.
    auto* const to = reinterpret_cast<ScreenPoint*>(job.free_bytes());
    for (int32_t i = 0; i != count; ++i) {
      to[i] = job.points[i];
    }
    job.points = to;
  }
  job.ram = reinterpret_cast<uint8_t*>(job.points + count);
  job.ram_bytes = static_cast<int32_t>(end - job.ram);
  job.ram_bytes = quotient(job.ram_bytes * tenths, 10) & ~3;
  return true;
}

void fill_glyph(TrueTypeJob& job, PaintPoints* paint) noexcept {
  job.cursor.begin(job.guards == 0);
  if (job.has_all) {
    paint(job.band, job.cursor, job.points, job.points + job.count);
    return;
  }
  job.outline.find_again();
  job.outline.rewind();
  do {
    const ScreenPoint* const end = job.outline.read(job.points, job.count);
    paint(job.band, job.cursor, job.points, end);
  } while (!job.outline.is_done());
}

}  // namespace detail

const Coding kTrueTypeCoding = {255, &detail::kTrueTypeSource};

}  // namespace inkcell
