// Distances of a text in the middle of a screen.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::scenes {

/// A text in the middle of a screen of width x height px. Its ink takes at most
/// the given parts of both. Made by find_place().
struct TextPlace {
  Q26_6 size;
  Point origin;
};

/// [parts of 256] False if the text has no ink.
bool find_place(const Font& font,
                Text text,
                int32_t width,
                int32_t height,
                int32_t width_part_q8,
                int32_t height_part_q8,
                TextPlace& out) noexcept;

/// Clears the grid, whose upper left corner is the screen's, and paints the
/// text. False if a glyph cannot be painted.
bool paint_text(const Font& font,
                Text text,
                const TextPlace& place,
                Workspace workspace,
                motion::DistanceGrid& grid) noexcept;

/// The part of the screen where the grid has distances.
Rect known_pixels(const motion::DistanceGrid& grid) noexcept;

}  // namespace inkcell::scenes
