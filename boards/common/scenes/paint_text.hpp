// Grids of distances as large as a screen, and texts in the middle of it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// Samples of the distances of a screen, 2^scale pixels apart along each side.
constexpr size_t samples_for(int32_t width,
                             int32_t height,
                             int32_t scale) noexcept {
  using motion::DistanceGrid;
  return static_cast<size_t>(DistanceGrid::samples_of(width, scale) *
                             DistanceGrid::samples_of(height, scale));
}

/// A grid of as many samples, which takes their memory off the front of `left`.
/// Without samples if that is too short; then none is left.
motion::DistanceGrid take_grid(Span<int8_t>& left,
                               int32_t width,
                               int32_t height,
                               int32_t scale) noexcept;

/// A text in the middle of a screen of width x height px. Its ink takes at most
/// the given parts of both. Made by find_place().
struct TextPlace {
  Q26_6 size;
  Point origin;
};

/// Word 0 is the first one, word 1 the rest of the text.
Text word_of(Text text, size_t index) noexcept;

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

void tell_grid(const motion::DistanceGrid& grid,
               const StateSink& sink) noexcept;

/// The part of the screen where the grid has distances.
Rect known_pixels(const motion::DistanceGrid& grid) noexcept;

}  // namespace inkcell::scenes
