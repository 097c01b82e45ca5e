// Round screens: the visible part of a strip.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {

/// The columns of `strip` that have pixels in the inscribed circle of a square
/// screen of `diameter` px (1 to 32767), as a strip in the same memory without
/// gaps between rows. Its edges are edges of bytes of `format`. Width 0:
/// nothing is visible.
///
/// Draw and send this strip instead of the whole one: with low strips this
/// saves a fifth of all pixels. Costs up to diameter / 2 steps. A strip with a
/// negative size, or a stride shorter than a row, is returned unchanged.
Strip round_strip(const Strip& strip,
                  PixelFormat format,
                  int32_t diameter) noexcept;

}  // namespace inkcell::port
