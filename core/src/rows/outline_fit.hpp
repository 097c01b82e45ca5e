// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include "rows/outline_source.hpp"

namespace inkcell {
namespace detail {

// The part of the source of outlines that fitted styles link.
struct OutlineFitter {
  // Makes the maps and moves the glyph. False: it is too far away.
  bool (*fit)(OutlineJob& job,
              uint16_t glyph,
              const GlyphMetrics& metrics,
              Placed& placed) noexcept;
  // OutlineSampling::warp_range.
  void (*move_range)(const AxisMap& map,
                     int32_t sign,
                     int32_t& low_q18,
                     int32_t& high_q18) noexcept;
  // Moves points of the glyph.
  void (*move)(const OutlineJob& job,
               ScreenPoint* points,
               const ScreenPoint* end) noexcept;
};

}  // namespace detail
}  // namespace inkcell
