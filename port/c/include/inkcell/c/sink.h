// Where pixels go, as in inkcell/strip.hpp: strips, sinks, and the loop over a
// screen. pixel.h has sinks for the usual pixel formats.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Rows of the screen in RAM. The caller owns the memory.
typedef struct INKCELL_SHARED inkcell_strip_t {
  uint8_t* pixels;
  size_t size;     // [bytes]
  int32_t x0;      // screen position of the strip's first pixel
  int32_t y0;      //
  int32_t width;   // [px]
  int32_t height;  // [px]
  int32_t stride;  // [bytes] from one row, or page of 8 rows, to the next
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
  /// As `block`.
  void (*ramp)(void);
} inkcell_sink_t;

/// How a screen is drawn strip by strip with a small buffer.
typedef struct inkcell_strip_loop_t {
  uint8_t* buffer;          // for one strip; the caller's
  size_t size;              // of the buffer [bytes]
  int32_t width;            // of the screen [px], 1..32767
  int32_t height;           // of the screen [px], 1..32767
  int32_t rows;             // of a strip; the last one may have fewer
  int32_t stride;           // [bytes]
  int32_t rows_per_stride;  // 8 in page layouts, else 1
  void* context;            // the first argument of both functions
  /// Draws everything that meets the strip: background first, then text.
  void (*draw)(void* context, const inkcell_strip_t* strip);
  /// Sends the strip to the display.
  void (*flush)(void* context, const inkcell_strip_t* strip);
} inkcell_strip_loop_t;

/// Calls draw and flush for the strips of a screen, from top to bottom. The
/// picture is the same for every number of rows.
///
/// BAD_ARGUMENT: a size is outside its range, `rows` is not a multiple of
/// `rows_per_stride`, or a function is null. BUFFER_SMALL: the buffer does not
/// hold `rows` rows. Nothing is called then.
inkcell_status_t inkcell_run_strips(const inkcell_strip_loop_t* loop);

#ifdef __cplusplus
}
#endif
