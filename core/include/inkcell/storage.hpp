// Storage that is not mapped: SPI flash, an SD card, a file.
//
//   bool read(void* file, uint32_t offset, uint8_t* bytes, uint32_t count);
//
// StoredFont of inkcell/stored/stored_font.hpp and StoredTrueType of
// inkcell/truetype/stored_truetype.hpp read fonts from there.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

class Font;

/// Storage of a font. `read` fills in `count` bytes from `offset` on, counted
/// from the font's first byte, and tells whether it could. Both are multiples
/// of 512.
struct Storage {
  bool (*read)(void* context,
               uint32_t offset,
               uint8_t* bytes,
               uint32_t count) = nullptr;
  void* context = nullptr;
};

/// The work of a stored font since it was opened.
struct StoredStats {
  uint32_t reads = 0;     // calls of Storage::read
  uint32_t bytes = 0;     // that it was asked for
  uint32_t failures = 0;  // blocks that could not be read, or do not fit
  uint32_t blocks = 0;    // that the lent RAM holds at once
};

/// Layers of a font in storage (StoredFont::layers()), for
/// ColourGlyphs::set_stored().
struct StoredLayers {
  const Font* font = nullptr;  // in the RAM that the stored font was lent
  uint32_t bytes = 0;          // of section COLR; 0: the font has none
  /// Four of its bytes, from the lowest; 0 where they cannot be read.
  uint32_t (*word)(const Font& font, uint32_t at) noexcept = nullptr;
};

}  // namespace inkcell
