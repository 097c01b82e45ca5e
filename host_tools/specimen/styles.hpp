// Pictures of the styles of one font: filters, sub-pixels, effects, fitting,
// maps, motion, few levels.
#pragma once

#include "image.hpp"
#include "inkcell/font.hpp"

namespace inkcell::tools {

/// Filter presets and profiles, weights, and gamma.
Image draw_filters(const Font& font);

/// Sub-pixels of every order beside grey.
Image draw_lcd(const Font& font);

/// Outlines, two colours, shadows, glows. Throws std::runtime_error if the
/// font's band is too narrow for them.
Image draw_effects(const Font& font);

/// Text with grid fitting, in grey and in 1 bit, as figure 10 of the paper.
/// Throws std::runtime_error if the font has no outlines or its hints are
/// broken.
Image draw_fitting(const Font& font);

/// Darker edges and thin strokes, from gradients, as in the paper's figures 11
/// and 12. Throws std::runtime_error if the font has outlines.
Image draw_contrast(const Font& font);

/// Slanted, narrow, wide, mirrored and turned text.
Image draw_maps(const Font& font);

/// Motion blur.
Image draw_motion(const Font& font);

/// 1 and 2 bits, with and without protection of thin strokes, and dithered
/// shades.
Image draw_levels(const Font& font);

}  // namespace inkcell::tools
