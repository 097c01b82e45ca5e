// Pictures of what one font can look like: filters, sub-pixels, effects,
// fitting, maps, motion, few levels.
#pragma once

#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

/// The filter presets and profiles, weights, and what gamma does.
Image draw_filters(const Font& font);

/// Sub-pixels of every order beside grey.
Image draw_lcd(const Font& font);

/// Outlines, two colours, shadows, glows. Throws std::runtime_error if the
/// font's band is too narrow for them.
Image draw_effects(const Font& font);

/// Text fitted to the grid of pixels, and contrast from gradients, as in the
/// paper's figures 10 to 12. Throws std::runtime_error if the font's hints are
/// broken.
Image draw_fitting(const Font& font);

/// Leaning, narrow, wide, mirrored and turned text.
Image draw_maps(const Font& font);

/// Text that is blurred along its way.
Image draw_motion(const Font& font);

/// 1 and 2 bits, with and without care for thin strokes, and dithered shades.
Image draw_levels(const Font& font);

}  // namespace inkcell::tools
