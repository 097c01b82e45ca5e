// Sinks for LCD sub-pixels, in the colour formats.
//
// The sinks of make_sink() with Sink::coverage_rgb in addition. To use them,
// set the effect Lcd (inkcell/lcd.hpp) on a style.
#pragma once

#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// `target` must outlive `out`. Each channel is blended with its own coverage.
/// Errors: see pixel.hpp.
Status make_lcd_sink(Rgb565Target& target, Sink& out) noexcept;
Status make_lcd_sink(Rgb888Target& target, Sink& out) noexcept;
Status make_lcd_sink(Xrgb8888Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
