// Draws shapes as prints: contour rings, engraving, hatching, halftone, relief
// (Perry and Frisken, section 6).
//
//   PrintLook look;
//   look.style = PrintStyle::engraving;
//   look.light = from_degrees(135);
//   draw_print(grid, look, x, y, kFilterMotion, sink);  // for each strip
//
// The edge is lit as a slope: its height is the distance, its direction the
// gradient. Dark places get more ink. Lines and dots move with the shape.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// How a tone becomes ink.
enum class PrintStyle : uint8_t {
  rings,      // lines along the edge, each `pitch` farther in, as far as the
              // grid has distances
  engraving,  // lines in one direction that bend over the slope
  hatching,   // straight lines; where it is dark others cross them
  halftone,   // dots on a turned screen
  relief      // the tone itself
};

/// The look of a print.
struct PrintLook {
  PrintStyle style = PrintStyle::relief;
  /// The direction from which light comes.
  motion::Angle light = motion::from_degrees(135);
  /// Of lines, or of rows of dots.
  motion::Angle screen = motion::from_degrees(45);
  Q26_6 pitch = Q26_6::from_int(4);  // distance of lines [px], 2 to 64
  Q26_6 slope = Q26_6::from_int(4);  // width of the slope [px], 1 to 32
  /// Offset of the lines: along the gradient, or across the lines. [px]
  Q26_6 shift;
  /// Lines and dots turn about this place when `screen` turns. [px from the
  /// grid's upper left corner]
  int16_t screen_x = 0;
  int16_t screen_y = 0;
  /// Distances below it are outside: above 0 shapes get thinner. [samples]
  Fixed<int32_t, 13> cutoff;
  /// The tone of flat areas, and the contrast of the lighting. [of 255]
  uint8_t tone = 110;
  uint8_t contrast = 110;
};

/// Draws a grid with its upper left corner at pixel (x, y), within +-8191. No
/// ink outside of the edge. About 120 instructions a pixel inside, hardly any
/// far outside.
void draw_print(const motion::DistanceGrid& grid,
                const PrintLook& look,
                int32_t x,
                int32_t y,
                const Filter& filter,
                const Sink& sink) noexcept;

}  // namespace inkcell::simulation
