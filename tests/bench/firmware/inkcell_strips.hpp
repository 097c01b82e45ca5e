// What the engines of Inkcell share: coverage into strips of 16 rows, which are
// cleared before.
#pragma once

#include "engine.h"
#include "inkcell/geometry.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text.hpp"

namespace bench {

inline constexpr int32_t kRows = 16;
static_assert(kEngineSide % kRows == 0, "whole strips");

inline constexpr int32_t kMaxPixelBytes = 3;

alignas(4) inline uint8_t pixels[kEngineSide * kEngineSide * kMaxPixelBytes];
inline inkcell::Font font;
inline inkcell::Style style(inkcell::kMinSize, inkcell::kFilterText);
inline inkcell::port::A8Canvas canvas;
inline inkcell::Sink sink;

// The glyph that is drawn next: where it stands, rows, pixels of its ink.
inline inkcell::Point origin;
inline int32_t height = 0;
inline uint32_t box = 0;

// Calls draw() for each strip that the glyph needs, with `sink` set to it. That
// one is a program's own, and not on the stack that is measured.
template <typename Canvas, typename Draw>
void draw_strips(Canvas& canvas, int32_t pixel_bytes, const Draw& draw) {
  const int32_t stride = kEngineSide * pixel_bytes;
  for (int32_t y = 0; y < height; y += kRows) {
    canvas.set_strip(
        {{pixels + y * stride, static_cast<size_t>(kRows * stride)},
         0,
         y,
         kEngineSide,
         kRows,
         stride});
    sink = canvas;
    draw();
  }
}

// The same into 8-bit coverage.
template <typename Draw>
void draw_strips(const Draw& draw) {
  draw_strips(canvas, 1, draw);
}

// Puts the glyph into the strips' upper left corner, and clears those.
// `box`: its pixels, its origin at (0, 0).
engine_answer place(uint16_t glyph, const inkcell::Rect& box);

// The same with the glyph of a character.
engine_answer place_glyph(uint32_t code_point);

// Whether two names are the same.
bool equal(const char* a, const char* b);

}  // namespace bench
