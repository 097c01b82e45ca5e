#include "truetype_source.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/coding.hpp"
#include "rows/area_painter.hpp"

namespace inkcell {
namespace detail {
namespace {

// Points at a time of a glyph that has more than there is room for.
constexpr int32_t kFewPoints = 12;
constexpr int32_t kPointBytes = sizeof(ScreenPoint);

// The least RAM: the job, some points, and twice a band.
constexpr int32_t kLeastTrueTypeRam =
    sizeof(TrueTypeJob) + kFewPoints * kPointBytes + 2 * kLeastBand;
static_assert(kLeastTrueTypeRam <= kLeastFittedRam + kLargeRam);
static_assert(TrueTypeJob::prepared_bytes() <= kMostJob);

// Not inline: its part of the stack is not needed where RAM is lent.
__attribute__((noinline)) void draw_on_own_stack(
    const GlyphCall& call) noexcept {
  alignas(GlyphJob) uint8_t bytes[kLeastTrueTypeRam];
  draw_bands_in({bytes, sizeof bytes}, call);
}

// Sums of 16 bits hold 136 contours on each other.
struct WordRows {
  using Pixel = uint16_t;
};

// What rows of bytes show of a sum, as cover_areas() does: 248 and more are
// roundings below 0.
int32_t saturated(int32_t sum) noexcept {
  constexpr int32_t kFull = 240;
  return is_below(sum + 8, 256) ? sum : min(abs(sum), kFull);
}

// The first and the second pixel of a word.
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

// From rows of 16 bits, which may begin where the band does, to rows of bytes:
// differences of saturated sums.
void saturate(const Band& band, const uint8_t* wide) noexcept {
  uint8_t* to = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    int32_t sum = 0;
    uint8_t* const end = to + row_bytes;
    do {
      uint32_t words[2];
      __builtin_memcpy(words, __builtin_assume_aligned(wide, 4), sizeof words);
      wide += sizeof words;
      uint32_t bytes = 0;
      if ((words[0] | words[1]) != 0) {
        const int32_t a = sum + first_of(words[0]);
        const int32_t b = a + second_of(words[0]);
        const int32_t c = b + first_of(words[1]);
        const int32_t d = c + second_of(words[1]);
        const auto byte = [](int32_t of, int32_t before) noexcept {
          return static_cast<uint32_t>(of - before) & 255;
        };
        if (__builtin_expect(
                (((a + 8) | (b + 8) | (c + 8) | (d + 8)) & ~255) == 0 &&
                    is_below(sum + 8, 256),
                1)) {
          bytes = byte(a, sum) | byte(b, a) << 8 | byte(c, b) << 16 |
                  byte(d, c) << 24;
        } else {
          const int32_t shown[] = {saturated(sum), saturated(a), saturated(b),
                                   saturated(c), saturated(d)};
          for (uint32_t i = 0; i != 4; ++i) {
            bytes |= byte(shown[i + 1], shown[i]) << 8 * i;
          }
        }
        sum = d;
      }
      store_pixels(to, bytes);
      to += 4;
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

constexpr Source kTrueTypeSource = {
    prepare_glyph,     load_wide,   fill_wide,    sizeof(TrueTypeJob),
    SourceKind::areas, draw_banded, draw_truetype};

}  // namespace

// Names the object of coverage from areas, for band.cpp.
extern decltype(cover_areas)* const kTrueTypeCover;
decltype(cover_areas)* const kTrueTypeCover = cover_areas;

void draw_truetype(const GlyphCall& call, const Workspace& ram) noexcept {
  if (ram.size < kLeastTrueTypeRam) {
    draw_on_own_stack(call);
  } else {
    draw_bands_in(ram, call);
  }
}

bool prepare_glyph(GlyphJob& base,
                   const GlyphRef& ref,
                   const Placed& placed) noexcept {
  auto& job = static_cast<TrueTypeJob&>(base);
  InkEnds ink[2];
  if (!job.outline.find(*static_cast<const Font*>(ref.from), ref.glyph,
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
  job.ram += count * kPointBytes;
  job.ram_bytes -= count * kPointBytes;
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
