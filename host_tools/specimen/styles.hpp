// Pictures of what one font can look like: filters, sub-pixels, effects, few
// levels.
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

/// 1 and 2 bits, with and without care for thin strokes, and dithered shades.
Image draw_levels(const Font& font);

}  // namespace inkcell::tools
