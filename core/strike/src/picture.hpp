// Pictures of glyphs: where they lie in a strike, and their pixels.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"
#include "place/position.hpp"

namespace inkcell::detail {

// Sections of strikes come as they lie in a font. Bytes may be any, and change
// between two reads: each is checked where it is read.

// What strikes shall be: the bits of their first word that count, and those.
struct StrikeKey {
  uint32_t mask;
  uint32_t word;
};

// Any strike, and those of 1 bit.
inline constexpr uint32_t kBitsMask = 0x00ff0000;
inline constexpr StrikeKey kAnyKey = {0, 0};
inline constexpr StrikeKey kBitKey = {kBitsMask, 1 << 16};

// The entry of a strike; null beyond the last one.
const uint8_t* strike_at(const Span<const uint8_t>& strikes,
                         uint32_t index) noexcept;

// A glyph whose picture is asked for.
struct PictureCall {
  StrikeKey key;
  uint32_t glyph;
  int32_t scale;         // pixels to a pixel of the picture
  const Placed& placed;  // it stands on the nearest pixel
};

// Its picture.
struct Picture {
  Rect box;
  int32_t scale;
  int32_t width;  // of its own pixels, 1..kMaxSide, as its height
  uint32_t bits;  // of a pixel: 1, 2 or 4
  uint32_t guesses;
  const uint8_t* begin;
  const uint8_t* end;
};

// In the first strike of the key that has the glyph. False: there is none.
bool find_picture(const Span<const uint8_t>& strikes,
                  const PictureCall& call,
                  Picture& out) noexcept;

// Draws a picture of 1 bit, and one of any, whose box is not outside of the
// sink's window.
using DrawPicture = void(const Picture& picture, const Sink& sink) noexcept;
DrawPicture draw_bits;
DrawPicture draw_picture;
// The same where none is magnified.
DrawPicture draw_bits_as_is;
DrawPicture draw_picture_as_is;

// Finds and draws. False: there is no picture.
bool draw_found(const Span<const uint8_t>& strikes,
                const PictureCall& call,
                DrawPicture* draw,
                const Sink& sink) noexcept;

}  // namespace inkcell::detail
