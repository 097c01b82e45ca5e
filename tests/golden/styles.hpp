// The pages of the test sheet that show what is not plain drawing.
#pragma once

#include "inkcell/strip.hpp"
#include "sheet.hpp"

namespace golden {

/// Lines that are fitted, sampled adaptively, blurred, outlined, crisp, leaning
/// and so on. False if a font did not open, or a style was refused.
bool draw_styles(const inkcell::Sink& sink);

/// Lines of fonts of outlines: by distance and by area, turned, with a wide
/// filter, fitted, and in the styles that outlines have.
bool draw_outlines(const inkcell::Sink& sink);

/// Lines with each order of sub-pixels, for a sink that has coverage_rgb.
bool draw_sub_pixels(const inkcell::Sink& sink);

}  // namespace golden
