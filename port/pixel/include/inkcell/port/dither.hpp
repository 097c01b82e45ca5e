// Sinks that spread intermediate coverage over neighbouring pixels.
//
// A 4 x 4 matrix, tied to the screen, decides where a shade rounds up and where
// down: 17 shades from 1 bit, 49 from 2. Shadows and glows gain by it, text
// does not: draw that through make_sink(). Solid pixels are the same in both.
#pragma once

#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// `target` must outlive `out`. The 1-bit targets' threshold moves the shades:
/// 128 keeps them, less makes all darker. Errors: see pixel.hpp.
Status make_dithered_sink(MonoRowsTarget& target, Sink& out) noexcept;
Status make_dithered_sink(MonoPagesTarget& target, Sink& out) noexcept;
Status make_dithered_sink(Grey2Target& target, Sink& out) noexcept;
Status make_dithered_sink(Grey4Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
