// Where pixels go, as in inkcell/strip.hpp: strips and sinks. pixel.h has sinks
// for the usual pixel formats, and the loop over a screen.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Which byte of a 16-bit pixel lies at the lower address.
enum { INKCELL_LOW_FIRST = 0, INKCELL_HIGH_FIRST = 1 };

/// Rows of the screen in RAM. The caller owns the memory.
typedef struct INKCELL_SHARED inkcell_strip_t {
  uint8_t* pixels;
  size_t size;     // [bytes]
  int32_t x0;      // screen position of the strip's first pixel
  int32_t y0;      //
  int32_t width;   // [px]
  int32_t height;  // [px]
  int32_t stride;  // [bytes] from one row, or page of 8 rows, to the next
  uint8_t order;   // of RGB565: INKCELL_LOW_FIRST or INKCELL_HIGH_FIRST
} inkcell_strip_t;

/// The most coverages that one call of `coverage` brings.
#define INKCELL_MAX_SPAN 32


/// Takes what is drawn. One of your own needs a window, a context and the first
/// two functions; the others are then null. Pixels outside `window` are never
/// named; within a glyph no pixel comes twice. Glyphs may overlap: blend over
/// what is there.
typedef struct INKCELL_SHARED inkcell_sink_t {
  /// Within +-32767 px.
  inkcell_rect_t window;
  /// Passed back as the first argument of each function.
  void* context;
  /// `count` pixels, 1 to INKCELL_MAX_SPAN, from (x, y) to the right, each with
  /// its coverage, 0 to 255, which is valid during the call only.
  void (*coverage)(void* context,
                   int32_t x,
                   int32_t y,
                   const uint8_t* coverage,
                   int32_t count);
  /// `count` pixels, any number from 1 on, of full coverage.
  void (*solid)(void* context, int32_t x, int32_t y, int32_t count);
  /// For the library's own sinks; null in one of yours.
  void (*block)(void);
  /// Like `coverage` with three coverages a pixel: red, green and blue. Null:
  /// sub-pixels are drawn grey.
  void (*coverage_rgb)(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count);
  /// As `block`, these two.
  void (*ramp)(void);
  void (*levels)(void);
} inkcell_sink_t;

#ifdef __cplusplus
}
#endif
