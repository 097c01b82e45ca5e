// A glyph of several colours that is to be drawn.
#pragma once

#include <stdint.h>

#include "inkcell/layers/colour_glyphs.hpp"
#include "text/glyph_run.hpp"

namespace inkcell::detail {

struct LayerCall {
  const ColourGlyphs& glyphs;
  const GlyphRun& run;
  uint16_t glyph;
  const Placed& at;  // a multiple of the drawer's phase
};

}  // namespace inkcell::detail
