// A record of section MORP (docs/FORMAT.md): the points of a pair on its way.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"
#include "outlines/screen_point.hpp"

namespace inkcell::motion {

/// All points of a glyph, as OutlineGlyph::read() writes them.
struct MorphOutline {
  const detail::ScreenPoint* points;
  int32_t count;
};

/// Writes the points of the outline at a progress of 0..1024, at most `room`.
/// Returns their end; null: there is no room for all. Safe with any record and
/// any points: coordinates wrap.
detail::ScreenPoint* write_morph(const Span<const uint8_t>& record,
                                 const MorphOutline (&outlines)[2],
                                 int32_t progress_q10,
                                 detail::ScreenPoint* out,
                                 int32_t room) noexcept;

}  // namespace inkcell::motion
