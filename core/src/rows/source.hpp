// Where the bands of a glyph come from, outlines or a field, and who draws it.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/glyph_warp.hpp"
#include "inkcell/mixer.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/position.hpp"
#include "rows/band.hpp"

namespace inkcell::detail {

struct GlyphRun;
struct Source;

// A glyph to draw.
struct GlyphRef {
  const Source* source;
  const void* from;  // the font, or what else the source draws
  uint16_t glyph;
};

// The same where it stands.
struct GlyphCall {
  GlyphRef ref;
  const Style& style;
  const Placed& placed;
  const Sink* sink;  // null: only the box is asked for
};

// A glyph that is drawn. Lies at the beginning of RAM that is lent as
// bytes, or on the stack; a source's own part follows in the same RAM.
struct __attribute__((may_alias)) GlyphJob : GlyphBand {
  // Where the band's first pixel has its first sample. First, as in Band.
  uint8_t column;
  uint8_t row;
  // Rows above and below a band that painters may write to, see Band, and
  // columns before it: areas have none. Samples lie in the middle of pixels
  // where there is one.
  uint8_t guards;

  // RAM behind the job. A source takes its part from the beginning; the rest is
  // for bands.
  int32_t ram_bytes;

  BandPlan plan;
  uint8_t* ram;
  const Source* source;
  const Style* style;
  Rect box;  // the pixels that may show something: set by Source::prepare()

  // The band at hand, and its pixels. Band::x_q8 and y_q8 count samples from
  // the pixel at first_column(box) and box.y0.
  Band band;
  Rect pixels;
  const Sink* sink;  // null: only the box is asked for

  // Sets `pixels` to those of the box in the sink's window. False: none are.
  bool clip() noexcept {
    pixels = intersect(box, sink->window);
    return !is_empty(pixels);
  }
};

// What a source draws.
enum class SourceKind : uint8_t {
  outlines,
  fields,   // jobs are FieldJobs (field_source.hpp)
  strikes,  // pictures, which come without bands: prepare() alone is there
  areas,    // outlines whose contours overlap: bands of exact areas alone
};

// Draws the glyphs of one coding of fonts (Coding::source): draw() those of a
// run, by draw_banded() all that come in bands. draw_bands.cpp calls, with a
// plan in place:
//   prepare  finds the box, and sets band.is_mirrored. For a fitted style it
//            takes the maps from `ram`. False: nothing shows.
//   load     once the box is clipped: takes what it keeps for fill() from `ram`
//            (multiples of 4 bytes; kLeastBand must be left). False: nothing
//            shows.
//   fill     paints job.band, whose bytes are all 0, as plan.band_kind says.
//            Once or several times for each band, which a mixer may have moved
//            by parts of a pixel, in any order.
// A band's bytes must not depend on how a glyph is cut into bands. Members of a
// source's own lie in a struct that derives from GlyphJob; it has no
// constructor, and nobody sets it before prepare().
struct Source {
  bool (*prepare)(GlyphJob& job,
                  const GlyphRef& ref,
                  const Placed& placed) noexcept;
  bool (*load)(GlyphJob& job) noexcept;
  void (*fill)(GlyphJob& job) noexcept;
  // Size of the struct. Larger than kMostJob: draw() lends kLeastLargeRam to
  // draw_bands() at least, and prepare() sets kMostJob bytes at most.
  uint16_t job_bytes;
  SourceKind kind;
  void (*draw)(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;
};

// What a band of one column takes of RAM: a word before it, and of the widest
// margin 4 + 6 rows of 16 columns. [bytes]
inline constexpr int32_t kLeastBand = 4 + 10 * 16;

// The largest job of a source, what load() takes at most where there is little
// RAM, and the maps. [bytes]
inline constexpr int32_t kMostJob =
    256 + 19 * static_cast<int32_t>(sizeof(void*));
inline constexpr int32_t kMostLoaded = 64;
inline constexpr int32_t kMaps = sizeof(GlyphWarp);

// The least RAM that a glyph is drawn in, that of one that is fitted, and what
// there is on the stack behind a job; more of it if pixels two rows away decide
// about one.
inline constexpr int32_t kLeastRam = kMostJob + kMostLoaded + kLeastBand;
inline constexpr int32_t kLeastFittedRam = kLeastRam + kMaps;
// The same of sources with larger jobs, which load more.
inline constexpr int32_t kLeastLargeRam =
    768 + 25 * static_cast<int32_t>(sizeof(void*));
static_assert(kLeastLargeRam >= kLeastFittedRam, "");
inline constexpr int32_t kBandRam = 256;
inline constexpr int32_t kWideBandRam = 488;
static_assert(kBandRam >= kMostLoaded + kLeastBand, "");

// Draws a placed glyph. The picture is the same for any workspace. One of
// kLeastFittedRam bytes holds all; one of more than kWideBandRam points and
// bands; what a smaller one does not hold lies on the stack.
void draw_bands(const GlyphCall& call, const Workspace& workspace) noexcept;

// The same of a run, for Source::draw.
void draw_banded(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;

// The pixels that draw_bands() may touch.
Rect band_box(const GlyphCall& call) noexcept;

// Whether a style's effect, if it has one, draws glyphs of a source.
inline bool can_draw(const Source& source, const Style& style) noexcept {
  const Effect* const effect = style.effect();
  const auto answer = effect == nullptr ? nullptr : effect->mixer().can_draw;
  return answer == nullptr ||
         answer(*effect, style, source.kind == SourceKind::fields);
}

// Paints the band that the job describes.
void clear_and_fill(GlyphJob& job) noexcept;

}  // namespace inkcell::detail
