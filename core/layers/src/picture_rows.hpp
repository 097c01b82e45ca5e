// Rows of a picture of several colours: drawn, and packed into the pieces of
// ColourPicture.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/canvas_colour.hpp"
#include "inkcell/geometry.hpp"

namespace inkcell::detail {

// A pixel as it is made: red, green and blue times opacity, and opacity, from
// the lowest byte of a word.
inline constexpr int32_t kPaintBytes = 4;

// What is less opaque does not show in 5 bits, nor what is less transparent.
inline constexpr uint32_t kLeastMixed = 4;

// As many equal pixels are a piece of their own.
inline constexpr int32_t kLeastSolid = 8;

// (a share + b (255 - share)) / 255, to the nearest, of bytes 0 and 2.
inline uint32_t mixed_pair(uint32_t a, uint32_t b, uint32_t share) noexcept {
  a &= kEvenBytes;
  b &= kEvenBytes;
  const uint32_t sum = a * share + b * (255 - share) + 0x00800080;
  return (sum + (sum >> 8 & kEvenBytes)) >> 8 & kEvenBytes;
}

// A sink of rows of such pixels: draws in a colour over what is there.
struct PaintRows {
  uint8_t* rows;
  int32_t width;
  Rect window;
  uint32_t paint = 0;  // opaque
  uint32_t opacity = 0;

  void set_colour(const LayerColour& colour) noexcept {
    paint = colour.red | uint32_t{colour.green} << 8 |
            uint32_t{colour.blue} << 16 | 0xff000000;
    opacity = colour.opacity;
  }

  void put(uint8_t* to, uint32_t coverage) const noexcept {
    const uint32_t share =
        opacity == 255 ? coverage : mixed_pair(coverage, 0, opacity);
    if (share == 255) {
      store_pixels(to, paint);
    } else if (share != 0) {
      const uint32_t old = load_pixels(to);
      store_pixels(to, mixed_pair(paint, old, share) |
                           mixed_pair(paint >> 8, old >> 8, share) << 8);
    }
  }
  uint8_t* at(int32_t x, int32_t y) const noexcept {
    return rows + kPaintBytes * ((y - window.y0) * width + x - window.x0);
  }

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    const auto& self = *static_cast<const PaintRows*>(context);
    for (uint8_t* to = self.at(x, y); count != 0; --count) {
      self.put(to, *coverage++);
      to += kPaintBytes;
    }
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    const auto& self = *static_cast<const PaintRows*>(context);
    for (uint8_t* to = self.at(x, y); count != 0; --count) {
      self.put(to, 255);
      to += kPaintBytes;
    }
  }
};

// Packs a row into pieces.
class PieceWriter {
 public:
  PieceWriter(const CanvasColour& canvas,
              const uint8_t* row,
              int32_t width,
              uint16_t* out) noexcept
      : canvas_(canvas), row_(row), width_(width), out_(out) {}

  // Returns the end of the pieces.
  uint16_t* write() noexcept {
    for (int32_t x = 0; x != width_;) {
      const ColourPicture::Kind kind = kind_of(x);
      const int32_t end = end_of(x, kind);
      switch (kind) {
        case ColourPicture::clear:
          begin(kind, end - x);
          break;
        case ColourPicture::mixed:
          write_mixed(x, end);
          break;
        default:
          write_opaque(x, end);
      }
      x = end;
    }
    return out_;
  }

 private:
  uint32_t opacity_of(int32_t x) const noexcept {
    return load_pixels(row_ + kPaintBytes * x) >> 24;
  }
  ColourPicture::Kind kind_of(int32_t x) const noexcept {
    const uint32_t opacity = opacity_of(x);
    return opacity < kLeastMixed         ? ColourPicture::clear
           : opacity > 255 - kLeastMixed ? ColourPicture::opaque
                                         : ColourPicture::mixed;
  }
  int32_t end_of(int32_t x, ColourPicture::Kind kind) const noexcept {
    while (x != width_ && kind_of(x) == kind) {
      ++x;
    }
    return x;
  }
  uint16_t pixel(int32_t x) const noexcept {
    const uint32_t paint = load_pixels(row_ + kPaintBytes * x);
    const uint32_t opacity = paint >> 24;
    const auto whole = [opacity](uint32_t part) noexcept {
      return static_cast<uint8_t>(
          min(255, static_cast<int32_t>((part * 255 + opacity / 2) / opacity)));
    };
    return static_cast<uint16_t>(
        canvas_.pixel_of({whole(paint & 255), whole(paint >> 8 & 255),
                          whole(paint >> 16 & 255), 255}));
  }
  // The end of the pixels that equal this one.
  int32_t equal_end(int32_t x, int32_t end) const noexcept {
    const uint16_t first = pixel(x);
    while (++x != end && pixel(x) == first) {
    }
    return x;
  }
  void begin(ColourPicture::Kind kind, int32_t count) noexcept {
    *out_++ = static_cast<uint16_t>(count << 2 | kind);
  }
  void write_pixels(int32_t x, int32_t end) noexcept {
    for (; x != end; ++x) {
      *out_++ = pixel(x);
    }
  }
  void write_mixed(int32_t x, int32_t end) noexcept {
    begin(ColourPicture::mixed, end - x);
    write_pixels(x, end);
    for (; x < end; x += 2) {
      const uint32_t second = x + 1 < end ? opacity_of(x + 1) : 0;
      *out_++ = static_cast<uint16_t>(opacity_of(x) | second << 8);
    }
  }
  void write_opaque(int32_t x, int32_t end) noexcept {
    int32_t first = x;  // of those that are not in a piece yet
    while (x != end) {
      const int32_t equal = equal_end(x, end);
      if (equal - x >= kLeastSolid) {
        write_varied(first, x);
        begin(ColourPicture::solid, equal - x);
        *out_++ = pixel(x);
        first = equal;
      }
      x = equal;
    }
    write_varied(first, end);
  }
  void write_varied(int32_t x, int32_t end) noexcept {
    if (x != end) {
      begin(ColourPicture::opaque, end - x);
      write_pixels(x, end);
    }
  }

  const CanvasColour& canvas_;
  const uint8_t* row_;
  int32_t width_;
  uint16_t* out_;
};

}  // namespace inkcell::detail
