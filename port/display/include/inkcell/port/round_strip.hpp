// Round screens: the part of a strip that their circle shows.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// The columns of `strip` that have pixels within the circle that touches the
/// sides of a square screen of `diameter` px (1 to 32767), as a strip in the
/// same memory without gaps between rows. Its edges are edges of bytes of
/// `format`. Width 0: the circle shows nothing of it.
///
/// Draw and send this strip instead of the whole one: of low strips a fifth of
/// all pixels is left out. Costs up to diameter / 2 steps. A strip with a
/// negative size, or a stride shorter than a row, is returned as it is.
Strip round_strip(const Strip& strip,
                  PixelFormat format,
                  int32_t diameter) noexcept;

}  // namespace port
}  // namespace inkcell
