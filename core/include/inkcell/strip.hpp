// Where pixels go: a strip of framebuffer rows, and the sink that fills it.
//
// Coordinates are whole pixels of the screen, x to the right and y down. The
// core never touches a pixel itself: it hands coverage to a sink. The sinks for
// the usual pixel formats are in port/pixel; writing one takes two functions.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"

namespace inkcell {

namespace detail {
struct LevelRule;
}  // namespace detail

/// The byte of a 16-bit pixel at the lower address.
enum class ByteOrder : uint8_t { low_first, high_first };

/// Rows of the framebuffer held in RAM. The caller owns the memory, the loop
/// over strips (inkcell/port/strip_loop.hpp) and the transfer to the display.
/// How many bytes `pixels` needs is said by the pixel format (`strip_bytes` in
/// port/pixel).
struct Strip {
  Span<uint8_t> pixels;
  int32_t x0 = 0;  // screen position of the strip's first pixel
  int32_t y0 = 0;
  int32_t width = 0;   // [px]
  int32_t height = 0;  // [px]
  int32_t stride = 0;  // [bytes] from one row (or page of 8 rows) to the next
  /// For RGB565: low_first in memory that the machine shows itself, high_first
  /// for panels behind SPI.
  ByteOrder order = ByteOrder::low_first;

  constexpr Rect rect() const noexcept {
    return {x0, y0, x0 + width, y0 + height};
  }
};

/// The most coverages that one call of Sink::coverage brings.
inline constexpr int32_t kMaxSpan = 32;

/// Coverage of several rows, as outlines bring it.
struct CoverageBlock {
  Rect pixels;  // within the sink's window
  /// The first pixel's; valid during the call only. The bytes of a row are
  /// followed by up to `stride`, all of which may be read; their addresses are
  /// multiples of 4 where x is.
  const uint8_t* coverage = nullptr;
  int32_t stride = 0;  // [bytes] from one row to the next, a multiple of 4
};

/// What the bytes of painted rows are.
enum class Painted : uint8_t {
  other,  // never handed to a sink
  ramp,   // RampWords; from the word of the pixel before the first one on
  sums,   // SumWords; from the word of the first pixel on
};

/// Takes what the renderer draws. Calls come glyph by glyph, and within a glyph
/// in any order, never the same pixel twice; pixels outside `window` are never
/// named. Glyphs may overlap: a sink blends over what is there.
struct Sink {
  /// What the sink accepts: normally the rectangle of its strip. At most
  /// 32767 px in any direction from the origin.
  Rect window;
  /// Passed back as the first argument of each function.
  void* context = nullptr;
  /// `count` pixels (1..kMaxSpan) from (x, y) to the right, each with its
  /// coverage 0..255. `coverage` is valid during the call only.
  void (*coverage)(void* context,
                   int32_t x,
                   int32_t y,
                   const uint8_t* coverage,
                   int32_t count) = nullptr;
  /// `count` pixels (1 or more, any number) of full coverage.
  void (*solid)(void* context, int32_t x, int32_t y, int32_t count) = nullptr;
  /// Whole blocks of coverage, 0 to 255, instead of rows of it; null: a block
  /// comes as calls of the two functions above. Fewer calls, and words at once.
  void (*block)(void* context, const CoverageBlock& block) = nullptr;
  /// Like `coverage`, but with three coverages for each of the `count` pixels:
  /// of red, green and blue. Only what draws sub-pixels calls it (lcd.hpp); it
  /// draws grey where this is null.
  void (*coverage_rgb)(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) = nullptr;
  /// Makes coverage of painted rows while it writes, which saves a pass over
  /// each block. `block.coverage` has painted bytes (painted.hpp), from where
  /// Painted says, at a multiple of 4. False, and nothing is drawn: the block
  /// comes as coverage. Null: never called.
  bool (*painted)(void* context,
                  const CoverageBlock& block,
                  Painted bytes) = nullptr;
  /// Of canvases of 1 and 2 bits: Painter calls it. Null: text is drawn as its
  /// style says.
  const detail::LevelRule* levels = nullptr;
};

}  // namespace inkcell
