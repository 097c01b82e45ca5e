// Draws glyphs of TrueType files.
#pragma once

#include <stdint.h>

#include "glyph_reader.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {

struct __attribute__((may_alias)) TrueTypeJob : GlyphJob {
  bool has_all;    // points
  uint16_t count;  // of points that there are, or that there is room for
  ScreenPoint* points;
  OutlineCursor cursor;
  TrueTypeGlyph outline;  // last: see Source::job_bytes

  // Room that is free once all points are read.
  uint8_t* free_bytes() noexcept {
    return guards != 0 ? reinterpret_cast<uint8_t*>(&outline)
                       : reinterpret_cast<uint8_t*>(cursor.halves());
  }
};

// The functions of such sources. load_glyph() leaves `tenths` of what points do
// not take of the RAM to bands; the rest lies behind it.
bool prepare_glyph(GlyphJob& job,
                   const GlyphRef& ref,
                   const Placed& placed) noexcept;
bool load_glyph(GlyphJob& job, int32_t tenths) noexcept;
void fill_glyph(TrueTypeJob& job, PaintPoints* paint) noexcept;
void draw_truetype(GlyphRun& run,
                   uint16_t glyph,
                   const Placed& placed) noexcept;

}  // namespace inkcell::detail
