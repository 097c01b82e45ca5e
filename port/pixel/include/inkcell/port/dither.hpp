// Sinks with ordered dither, for formats of 1, 2 and 4 bits.
//
// A 4 x 4 matrix, fixed on the screen, decides which pixels round up: 17 shades
// from 1 bit, 49 from 2. Good for shadows and glows, bad for text: use
// make_sink() for that. Solid pixels are the same in both.
#pragma once

#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// `target` must outlive `out`. With 1 bit the threshold shifts the shades: 128
/// is neutral, less is darker. Errors: see pixel.hpp.
Status make_dithered_sink(MonoRowsTarget& target, Sink& out) noexcept;
Status make_dithered_sink(MonoPagesTarget& target, Sink& out) noexcept;
Status make_dithered_sink(Grey2Target& target, Sink& out) noexcept;
Status make_dithered_sink(Grey4Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
