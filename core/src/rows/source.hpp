// Where the bands of a glyph come from: outlines, or a field.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/font.hpp"
#include "inkcell/glyph_warp.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/position.hpp"
#include "rows/band_painter.hpp"

namespace inkcell {
namespace detail {

// How the bands of a glyph are painted: what the style's filter asks for, as
// its mixer changes it. Only areas have several samples a pixel; moved_x_q8 and
// moved_y_q8 are what repaint() moves the glyph by at most.
struct BandPlan : Sampling {
  const BandPainter* painter = nullptr;
  // How far distances are good, outside and inside. [px]
  int32_t outside_q8 = 0;
  int32_t inside_q8 = 0;
  // Samples around the pixels that are drawn.
  uint8_t margin_x = 0;
  uint8_t margin_y = 0;
  // RAM for a sample of a band and what the mixer keeps of it. [bytes]
  uint8_t sample_bytes = 1;

  // For the ramp of a filter.
  void widen(const Filter& filter) noexcept {
    outside_q8 = max(outside_q8, (-filter.outside_q10 >> 2) + 1);
    inside_q8 = max(inside_q8, (filter.inside_q10 >> 2) + 1);
  }

  // Samples before the first pixel of a band, from a multiple of 4 on: one of
  // them at least.
  int32_t columns_before(int32_t x0) const noexcept {
    return ((x0 * columns - margin_x - 1) & 3) + 1 + margin_x;
  }
  // Samples of a band of pixels, from there on.
  int32_t width_of(int32_t column, const Rect& pixels) const noexcept {
    return column + (pixels.x1 - pixels.x0) * columns + margin_x;
  }
};

struct Source;

// A glyph to draw.
struct GlyphRef {
  const Source* source;
  const void* from;  // the font, or what else the source draws
  uint16_t glyph;
};

// A glyph that is drawn. Lies at the beginning of RAM that is lent as
// bytes, or on the stack; a source's own part follows in the same RAM.
struct __attribute__((may_alias)) GlyphJob {
  const Source* source;
  const Style* style;
  BandPlan plan;
  Rect box;  // the pixels that may show something: set by Source::open()

  // RAM behind the job. Source::load() takes its part from the beginning; the
  // rest is for bands.
  uint8_t* ram;
  int32_t ram_bytes;

  // The band at hand: its pixels, and where the first one has its first sample.
  // Band::x_q8 and y_q8 count samples from the pixel at first_column(box) and
  // box.y0.
  uint8_t column;
  uint8_t row;
  Band band;
  Rect pixels;
  const Sink* sink;
};

// Draws the glyphs of one coding of fonts (Coding::source). draw_bands.cpp
// calls, with a plan in place:
//   open   finds the box, and sets band.is_mirrored. False: nothing shows. If
//          the style is fitted it takes the maps from `ram`.
//   load   comes once, if the box meets the window: takes what it keeps from
//          `ram` (multiples of 4 bytes; kLeastBand must be left). False:
//          nothing shows.
//   fill   paints job.band, whose bytes are all 0, as plan.painter->kind says.
//          Once or several times for each band, which a mixer may have moved by
//          parts of a pixel, in any order.
// A band's bytes must not depend on how a glyph is cut into bands. Members of a
// source's own lie in a struct that derives from GlyphJob; it has no
// constructor, and nobody sets it before open().
struct Source {
  bool (*open)(GlyphJob& job,
               const GlyphRef& ref,
               const Placed& placed) noexcept;
  bool (*load)(GlyphJob& job) noexcept;
  void (*fill)(GlyphJob& job) noexcept;
  uint16_t job_bytes;  // size of the struct, kMostJob at most
  bool has_field;      // jobs are FieldJobs (field_source.hpp)
};

// What a band of one column takes of RAM: a word before it, and of the widest
// margin 4 + 6 rows of 16 columns. [bytes]
inline constexpr int32_t kLeastBand = 4 + 10 * 16;

// The largest job of a source, what load() takes at most where there is little
// RAM, and the maps. [bytes]
inline constexpr int32_t kMostJob =
    256 + 19 * static_cast<int32_t>(sizeof(void*));
inline constexpr int32_t kMostLoaded = 96;
inline constexpr int32_t kMaps = sizeof(GlyphWarp);

// The least RAM that a glyph is drawn in, and that of one that is fitted.
inline constexpr int32_t kLeastRam = kMostJob + kMostLoaded + kLeastBand;
inline constexpr int32_t kLeastFittedRam = kLeastRam + kMaps;

}  // namespace detail
}  // namespace inkcell
