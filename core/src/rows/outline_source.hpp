// The source of fonts of outlines, and what fits them to the grid of pixels.
#pragma once

#include <stdint.h>

#include "inkcell/glyph_warp.hpp"
#include "outlines/outline_glyph.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {

// A glyph of outlines.
struct __attribute__((may_alias)) OutlineJob : GlyphJob {
  bool has_all;     // points
  uint16_t count;   // of points that there are, or that there is room for
  GlyphWarp* warp;  // behind the job; null: it is not fitted
  ScreenPoint* points;
  OutlineGlyph outline;
  OutlineCursor cursor;
};

// Neighbours, from the left.
struct GlyphPair {
  uint16_t left;
  uint16_t right;
  int32_t kerning;  // [font units]
};

// What only fitted styles link.
struct OutlineFitter {
  // Makes the maps, and moves the glyph and its ink. False: it is too far away.
  bool (*fit)(OutlineJob& job,
              const Font& font,
              uint16_t glyph,
              Placed& placed,
              InkEnds (&ink)[2]) noexcept;
  // Moves points of the glyph.
  void (*move)(const OutlineJob& job,
               ScreenPoint* points,
               const ScreenPoint* end) noexcept;
  // Whole pixels between the advance of a glyph and the next one: the kerning,
  // and what brings the pen nearer to where it is as designed. `drift_q6` is
  // how far it is ahead at the left glyph, and then at the right one.
  int32_t (*join)(const Font& font,
                  const Style& style,
                  const Fitter& fitter,
                  const GlyphPair& pair,
                  int32_t& drift_q6) noexcept;
  // To font units, to the nearest.
  int32_t (*to_units)(const Font& font, Q26_6 size, int32_t px) noexcept;
};

// The functions of a source of outlines. load_points() is false where there are
// none; fill_outline() paints all points, or portions of those for which there
// is no room.
bool prepare_outline(GlyphJob& job,
                     const GlyphRef& ref,
                     const Placed& placed) noexcept;
bool load_points(GlyphJob& job) noexcept;
void fill_outline(GlyphJob& job) noexcept;

// Such a source.
constexpr Source outline_source(decltype(Source::draw) draw) noexcept {
  return {prepare_outline,    load_points,          fill_outline,
          sizeof(OutlineJob), SourceKind::outlines, draw};
}

}  // namespace inkcell::detail
