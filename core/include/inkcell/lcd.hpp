// Sub-pixels: a coverage for each coloured stripe of a pixel.
//
//   brush.set_painter(paint_lcd, &lcd_style, kLcdReach);
//   port::make_lcd_sink(target, sink);
//
// Each stripe takes a distance of its own, at its middle, and its coverage is
// that of a third of a pixel; each channel is the mean of its stripe and the
// two beside it. So an edge has three times as many places to be, and every
// stroke, however thin, gives the same to red, green and blue: grey stays grey
// from a little way off.
#pragma once

#include <stdint.h>

#include "inkcell/brush.hpp"
#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {

/// How stripes lie in a pixel: from left to right, or from top to bottom.
enum class SubPixels : uint8_t { rgb, bgr, rgb_vertical, bgr_vertical };

/// Options of paint_lcd.
struct LcdStyle {
  SubPixels order = SubPixels::rgb;
  /// How much of the coverages' differences is kept, 255 for all: less takes
  /// colour off thin strokes, and some sharpness. 0 is grey.
  uint8_t colour = 255;
};

/// What Brush::set_painter wants as `reach_px`.
inline constexpr uint8_t kLcdReach = 1;

/// A Painter; `options` is a LcdStyle. A sink without coverage_rgb is given the
/// mean of the three.
void paint_lcd(const GlyphField& field,
               const Brush& brush,
               const void* options,
               const FinePoint& origin,
               const RowMap* rows,
               const Sink& sink);

}  // namespace inkcell
