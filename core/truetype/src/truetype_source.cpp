#include "truetype_source.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/assert.hpp"
#include "inkcell/coding.hpp"
#include "inkcell/painter.hpp"
#include "rows/area_painter.hpp"

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

// Sums of 16 bits hold 136 contours on each other.
struct WordRows {
  using Pixel = uint16_t;
};

// Sums are kept above by so much: then those that a row of bytes can show, of
// which the lowest are roundings below 0 and the highest are clamped, have 8
// bits. See cover_areas().
constexpr int32_t kBelow = 8;

// The nearest sum that it can show.
int32_t saturated(int32_t sum) noexcept {
  constexpr int32_t kFull = 240;
  return is_below(sum, 256) ? sum : min(abs(sum - kBelow), kFull) + kBelow;
}

// Two pixels of 16 bits in a word, the first and the second.
int32_t first_of(uint32_t word) noexcept {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return static_cast<int32_t>(word) >> 16;
#else
  return static_cast<int16_t>(word);
#endif
}
int32_t second_of(uint32_t word) noexcept {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  return static_cast<int16_t>(word);
#else
  return static_cast<int32_t>(word) >> 16;
#endif
}

// Their low bytes, the first one lowest.
uint32_t low_bytes(uint32_t word) noexcept {
  return (static_cast<uint32_t>(first_of(word)) & 255) |
         (static_cast<uint32_t>(second_of(word)) & 255) << 8;
}

// The same of four pixels as saturated sums differ.
__attribute__((noinline)) uint32_t saturated_bytes(const uint32_t (&words)[2],
                                                   int32_t sum) noexcept {
  uint32_t bytes = 0;
  int32_t before = saturated(sum);
  for (uint32_t i = 0; i != 4; ++i) {
    const uint32_t word = words[i >> 1];
    sum += (i & 1) == 0 ? first_of(word) : second_of(word);
    const int32_t shown = saturated(sum);
    bytes |= (static_cast<uint32_t>(shown - before) & 255) << 8 * i;
    before = shown;
  }
  return bytes;
}

struct FourPixels {
  uint32_t words[2];

  explicit FourPixels(const uint8_t* at) noexcept {
    __builtin_memcpy(words, __builtin_assume_aligned(at, 4), sizeof words);
  }
  bool is_zero() const noexcept { return (words[0] | words[1]) == 0; }

  // The bytes to show; `sum` goes on behind them.
  uint32_t bytes(int32_t& sum) const noexcept {
    const int32_t a = sum + first_of(words[0]);
    const int32_t b = a + second_of(words[0]);
    const int32_t c = b + first_of(words[1]);
    const int32_t d = c + second_of(words[1]);
    const int32_t any = sum | a | b | c | d;
    const uint32_t result = __builtin_expect((any & ~255) == 0, 1)
                                ? low_bytes(words[0]) | low_bytes(words[1])
                                                            << 16
                                : saturated_bytes(words, sum);
    sum = d;
    return result;
  }
};

// From rows of 16 bits, which may begin where the band does, to rows of bytes:
// differences of saturated sums.
void saturate(const Band& band, const uint8_t* wide) noexcept {
  uint8_t* to = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    int32_t sum = kBelow;
    uint8_t* const end = to + row_bytes;
    do {
      const FourPixels pixels(wide);
      wide += 8;
      uint8_t* const at = to;
      to += 4;
      if (!pixels.is_zero()) {
        store_pixels(at, pixels.bytes(sum));
        continue;
      }
      store_pixels(at, 0);
      // Most follow each other.
      while (!kIsSmall && end - to >= 8 && FourPixels(wide).is_zero() &&
             FourPixels(wide + 8).is_zero()) {
        store_pixels(to, 0);
        store_pixels(to + 4, 0);
        to += 8;
        wide += 16;
      }
    } while (to != end);
    to += skipped;
    wide += 2 * skipped;
  }
}

bool load_wide(GlyphJob& job) noexcept {
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
  fill_glyph(job, AreaPainter<WordRows>::paint);
  const uint8_t* const wide = band.bytes;
  band.bytes = bytes;
  saturate(band, wide);
}

constexpr Source kTrueTypeSource = {prepare_glyph,     load_wide,
                                    fill_wide,         sizeof(TrueTypeJob),
                                    SourceKind::areas, draw_truetype};

}  // namespace

// Names the object of coverage from areas, for band.cpp.
extern decltype(cover_areas)* const kTrueTypeCover;
decltype(cover_areas)* const kTrueTypeCover = cover_areas;

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
  job.outline.find_box(placed, job.plan, job.guards * 128, ink, job.box);
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
  job.outline.rewind();
  do {
    const ScreenPoint* const end = job.outline.read(job.points, job.count);
    paint(job.band, job.cursor, job.points, end);
  } while (!job.outline.is_done());
}

}  // namespace detail

const Coding kTrueTypeCoding = {255, &detail::kTrueTypeSource};

}  // namespace inkcell
