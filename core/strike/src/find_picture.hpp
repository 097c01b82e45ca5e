// Where the picture of a glyph lies in a strike.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "picture.hpp"
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

// Its picture: in the first strike of the key that has the glyph. False: there
// is none.
bool find_picture(const Span<const uint8_t>& strikes,
                  const PictureCall& call,
                  Picture& out) noexcept;
// The same in a font of strikes alone, or a page of one: the box is that of the
// glyph's metrics.
class StrikeAlone {
 public:
  static bool find_picture(const Font& font,
                           const PictureCall& call,
                           Picture& out) noexcept;
};

}  // namespace inkcell::detail
