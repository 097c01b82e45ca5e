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

/// Text fitted to the grid of pixels, in grey and in 1 bit, as the paper's
/// figure 10. Throws std::runtime_error if the font has no outlines or its
/// hints are broken.
Image draw_fitting(const Font& font);

/// Darker edges and thin strokes, from gradients, as in the paper's figures 11
/// and 12. Throws std::runtime_error if the font has outlines.
Image draw_contrast(const Font& font);

/// Leaning, narrow, wide, mirrored and turned text.
Image draw_maps(const Font& font);

/// Text that is blurred along its way.
Image draw_motion(const Font& font);

/// 1 and 2 bits, with and without care for thin strokes, and dithered shades.
Image draw_levels(const Font& font);

}  // namespace inkcell::tools
