// Colours of palettes, and how a canvas takes them: for glyphs of several
// colours (inkcell/layers/colour_glyphs.hpp). inkcell/port/colour.hpp has them
// for canvases of colours.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"
#include "inkcell/geometry.hpp"

namespace inkcell {

/// A colour of a palette, as in the font.
struct LayerColour {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
  uint8_t opacity = 255;
};

/// A picture of several colours, as ColourCache keeps it: rows from the top
/// down, each of pieces that fill the box's width. A piece is a word, whose low
/// 2 bits are its kind and whose others are its number of pixels, and what the
/// kind says. Pixels are those of CanvasColour::pixel_of, in 16 bits.
struct ColourPicture {
  enum Kind : uint8_t {
    clear,   // nothing
    solid,   // a pixel, which all of them are
    opaque,  // the pixels
    mixed    // the pixels, then a byte of coverage for each, two in a word
  };

  const uint16_t* pieces = nullptr;
  Rect box;
};

/// The colour of a canvas, which layers change; `canvas` must outlive it.
struct CanvasColour {
  void* canvas = nullptr;
  /// Draws what follows in `pixel`, a colour in the form of the canvas; returns
  /// the colour before.
  uint32_t (*exchange)(void* canvas, uint32_t pixel) noexcept = nullptr;
  /// A colour in that form, without its opacity.
  uint32_t (*pixel_of)(const LayerColour& colour) noexcept = nullptr;
  /// Draws a picture within a window. Null: a ColourCache is not used. `canvas`
  /// is then the context of the canvas's sink.
  void (*put)(void* canvas,
              const ColourPicture& picture,
              const Rect& window) noexcept = nullptr;
};

}  // namespace inkcell
