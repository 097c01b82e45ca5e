// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include "rows/outline_source.hpp"

namespace inkcell {
namespace detail {

// The part of the source of outlines that fitted styles link.
struct OutlineFitter {
  // Makes the maps, and moves the glyph and its ink. False: it is too far away.
  bool (*fit)(OutlineJob& job,
              uint16_t glyph,
              Placed& placed,
              InkEnds (&ink)[2]) noexcept;
  // Moves points of the glyph.
  void (*move)(const OutlineJob& job,
               ScreenPoint* points,
               const ScreenPoint* end) noexcept;
};

}  // namespace detail
}  // namespace inkcell
