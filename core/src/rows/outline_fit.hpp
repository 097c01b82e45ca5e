// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include "rows/outline_source.hpp"

namespace inkcell {
namespace detail {

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
  // Advances in whole pixels: font units, rounded towards 0, and back, to the
  // nearest.
  int32_t (*to_px)(const Font& font, Q26_6 size, int32_t units) noexcept;
  int32_t (*to_units)(const Font& font, Q26_6 size, int32_t px) noexcept;
};

}  // namespace detail
}  // namespace inkcell
