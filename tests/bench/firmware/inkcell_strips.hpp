// What the engines of Inkcell share: coverage into strips of 16 rows, which are
// cleared before.
#pragma once

#include "engine.h"
#include "inkcell/port/a8.hpp"
#include "inkcell/text.hpp"

namespace bench {

inline constexpr int32_t kRows = 16;
static_assert(kEngineSide % kRows == 0, "whole strips");

alignas(4) inline uint8_t pixels[kEngineSide * kEngineSide];
inline inkcell::Font font;
inline inkcell::Brush brush;
inline inkcell::port::A8Target target;
inline inkcell::Sink sink;

// Of the glyph that is drawn next: where it stands, rows, pixels of its ink.
inline inkcell::Point origin;
inline int32_t height = 0;
inline uint32_t box = 0;

// Calls draw() for each strip that the glyph needs, with `sink` set to it. That
// one is a program's own, and not on the stack that is measured.
template <typename Draw>
void draw_strips(const Draw& draw) {
  target.strip.width = kEngineSide;
  target.strip.height = kRows;
  target.strip.stride = kEngineSide;
  for (int32_t y = 0; y < height; y += kRows) {
    target.strip.y0 = y;
    target.strip.pixels = {pixels + y * kEngineSide,
                           static_cast<size_t>(kRows * kEngineSide)};
    if (make_sink(target, sink) != inkcell::Status::ok) {
      return;
    }
    draw();
  }
}

// Puts the glyph into the strips' upper left corner, and clears those.
engine_answer place(uint16_t glyph, const inkcell::GlyphField& field);

// Whether two names are the same.
bool equal(const char* a, const char* b);

}  // namespace bench
