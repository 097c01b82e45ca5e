// The source of fonts of outlines.
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

}  // namespace inkcell::detail
