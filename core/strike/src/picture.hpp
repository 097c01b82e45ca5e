// Pictures of glyphs: where they lie in a strike, and their pixels.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::detail {

// Sections of strikes come as they lie in a font. Bytes may be any, and change
// between two reads: each is checked where it is read.

// A picture, from the origin of its glyph.
struct Picture {
  int32_t left;  // [px]
  int32_t top;   // y down
  int32_t width;
  int32_t height;  // 1..kMaxSide, both
  const uint8_t* begin;
  const uint8_t* end;
  uint32_t guesses;
  uint32_t bits;  // 1, 2 or 4
};

// What strikes shall be: the bits of their first word that count, and those.
struct StrikeKey {
  uint32_t mask;
  uint32_t word;
};

// The entry of a strike; null beyond the last one.
const uint8_t* strike_at(const Span<const uint8_t>& strikes,
                         uint32_t index) noexcept;

// The picture of a glyph in the first strike of the key that has the glyph.
// False: there is none.
bool find_picture(const Span<const uint8_t>& strikes,
                  const StrikeKey& key,
                  uint32_t glyph,
                  Picture& out) noexcept;

// The pixels of a picture that is magnified, with the origin at a pixel.
Rect box_of(const Picture& picture,
            int32_t x,
            int32_t y,
            int32_t scale) noexcept;

// Draws a picture of 1 bit, and one of any.
void draw_bits(const Picture& picture,
               const Rect& box,
               int32_t scale,
               const Sink& sink) noexcept;
void draw_picture(const Picture& picture,
                  const Rect& box,
                  int32_t scale,
                  const Sink& sink) noexcept;

}  // namespace inkcell::detail
