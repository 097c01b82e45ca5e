// The source of fonts of outlines.
#pragma once

#include <stdint.h>

#include "inkcell/glyph_warp.hpp"
#include "outlines/outline_glyph.hpp"
#include "rows/source.hpp"

namespace inkcell {
namespace detail {

// A glyph of outlines.
struct __attribute__((may_alias)) OutlineJob : GlyphJob {
  bool has_all;         // points
  GlyphWarp* warp;      // at the beginning of the RAM; null: it is not fitted
  ScreenPoint* points;  // all of them, or room for some, up to `ram`
  OutlineGlyph outline;
  OutlineCursor cursor;
};

}  // namespace detail
}  // namespace inkcell
