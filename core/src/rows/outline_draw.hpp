// Drawing glyphs of outlines: band by band, into a sink.
#pragma once

#include "inkcell/font.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "inkcell/workspace.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/position.hpp"
#include "rows/band.hpp"

namespace inkcell {
namespace detail {

// How one kind of filter makes coverage of outlines.
struct OutlinePainter {
  void (*paint)(const Band& band,
                OutlineCursor& cursor,
                const ScreenPoint* points,
                const ScreenPoint* end) noexcept;
  // Painted rows to coverage, in place.
  void (*cover)(const Band& band, const Filter& filter) noexcept;
  // What lies at whole numbers, from a pixel's upper left corner. [px, Q8]
  int16_t origin_q8;
  // How far from the edge bytes tell something; 0: as far as the filter's ramp.
  // [px, Q8]
  int16_t reach_q8;
};

// Draws a placed glyph. What it does is the same for any workspace; without
// one, or with a small one, it takes 860 bytes of the stack.
void draw_outline(const Font& font,
                  uint16_t glyph,
                  Span<const uint8_t> record,
                  const TextStyle& style,
                  const Placed& placed,
                  const Sink& sink,
                  Workspace workspace) noexcept;

}  // namespace detail
}  // namespace inkcell
