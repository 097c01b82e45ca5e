// Sinks for the usual pixel formats, as in inkcell/port/pixel.hpp.
//
// A target is a strip and a colour. It must outlive its sink; the colour may be
// changed between two calls that draw, the strip may not. Errors of all
// functions here; `out` then takes nothing:
//
//   BAD_ARGUMENT  a negative size, a size or the distance of a corner from the
//                 origin over 32767 px, a stride shorter than a row or over
//                 65535 bytes, or what the target says
//   BUFFER_SMALL  fewer pixels than the rows need
//   MISALIGNED    only xrgb8888: pixels or stride not a multiple of 4 bytes
//
// A sink touches no pixel outside its strip, and none of coverage 0.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/sink.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Pixel formats, for the macros that follow.
enum {
  INKCELL_A8 = 0,
  INKCELL_GREY8 = 1,
  INKCELL_GREY4 = 2,
  INKCELL_GREY2 = 3,
  INKCELL_MONO_ROWS = 4,
  INKCELL_MONO_PAGES = 5,
  INKCELL_RGB565 = 6,
  INKCELL_RGB888 = 7,
  INKCELL_XRGB8888 = 8
};

/// Constant if the arguments are, for sizes of arrays. Widths and heights are 0
/// to 32767 px.
#define INKCELL_BITS_PER_PIXEL(format)                                  \
  ((format) == INKCELL_MONO_ROWS || (format) == INKCELL_MONO_PAGES ? 1  \
   : (format) == INKCELL_GREY2                                     ? 2  \
   : (format) == INKCELL_GREY4                                     ? 4  \
   : (format) == INKCELL_RGB565                                    ? 16 \
   : (format) == INKCELL_RGB888                                    ? 24 \
   : (format) == INKCELL_XRGB8888                                  ? 32 \
                                                                   : 8)

/// The rows that one stride covers.
#define INKCELL_ROWS_PER_STRIDE(format) ((format) == INKCELL_MONO_PAGES ? 8 : 1)

/// The smallest stride [bytes] for `width` px: a row, or a page of 8 rows.
#define INKCELL_STRIDE_BYTES(format, width) \
  ((format) == INKCELL_MONO_PAGES           \
       ? (width)                            \
       : ((width)*INKCELL_BITS_PER_PIXEL(format) + 7) / 8)

/// The bytes of a strip with that stride.
#define INKCELL_STRIP_BYTES(format, width, height)     \
  (INKCELL_STRIDE_BYTES(format, width) *               \
   (((height) + INKCELL_ROWS_PER_STRIDE(format) - 1) / \
    INKCELL_ROWS_PER_STRIDE(format)))

/// The pixel of an 8-bit colour: the high bits of each channel.
#define INKCELL_RGB565_OF(red, green, blue) \
  ((uint16_t)(((red) >> 3) << 11 | ((green) >> 2) << 5 | (blue) >> 3))

/// Which end of a byte is the left pixel, in formats of several pixels a byte.
enum { INKCELL_HIGH_LEFT = 0, INKCELL_LOW_LEFT = 1 };

/// Which channel lies at the lowest address.
enum { INKCELL_RED_FIRST = 0, INKCELL_BLUE_FIRST = 1 };

/// Coverage itself, 8 bit, which only grows.
typedef struct INKCELL_SHARED inkcell_a8_target_t {
  inkcell_strip_t strip;
} inkcell_a8_target_t;

/// 256 levels.
typedef struct INKCELL_SHARED inkcell_grey8_target_t {
  inkcell_strip_t strip;
  uint8_t level;  // of the foreground
} inkcell_grey8_target_t;

/// 16 levels, two pixels a byte.
typedef struct INKCELL_SHARED inkcell_grey4_target_t {
  inkcell_strip_t strip;
  uint8_t level;  // of the foreground, 0..15: else BAD_ARGUMENT
  uint8_t order;  // INKCELL_HIGH_LEFT or INKCELL_LOW_LEFT
} inkcell_grey4_target_t;

/// 4 levels, four pixels a byte.
typedef struct INKCELL_SHARED inkcell_grey2_target_t {
  inkcell_strip_t strip;
  uint8_t level;  // of the foreground, 0..3: else BAD_ARGUMENT
  uint8_t order;  // INKCELL_HIGH_LEFT or INKCELL_LOW_LEFT
} inkcell_grey2_target_t;

/// 1 bit, eight pixels along the row a byte.
typedef struct INKCELL_SHARED inkcell_mono_rows_target_t {
  inkcell_strip_t strip;
  uint8_t threshold;  // coverage that is drawn, 1..255: else BAD_ARGUMENT
  uint8_t level;      // 1 sets the bits of drawn pixels, 0 clears them
  uint8_t order;      // INKCELL_HIGH_LEFT or INKCELL_LOW_LEFT
} inkcell_mono_rows_target_t;

/// 1 bit in pages, as SSD1306 takes them: a byte is a column of 8 pixels, bit 0
/// on top. The strip's stride is from one page to the next.
typedef struct INKCELL_SHARED inkcell_mono_pages_target_t {
  inkcell_strip_t strip;
  uint8_t threshold;  // coverage that is drawn, 1..255: else BAD_ARGUMENT
  uint8_t level;      // 1 sets the bits of drawn pixels, 0 clears them
} inkcell_mono_pages_target_t;

/// 5, 6 and 5 bits, at any address.
typedef struct INKCELL_SHARED inkcell_rgb565_target_t {
  inkcell_strip_t strip;
  uint16_t colour;  // of the foreground: INKCELL_RGB565_OF()
} inkcell_rgb565_target_t;

/// Three bytes a pixel.
typedef struct INKCELL_SHARED inkcell_rgb888_target_t {
  inkcell_strip_t strip;
  uint32_t colour;  // of the foreground: 0xRRGGBB
  uint8_t order;    // INKCELL_RED_FIRST or INKCELL_BLUE_FIRST
} inkcell_rgb888_target_t;

/// Four bytes a pixel: blue, green, red, x, which is blended like a colour.
typedef struct INKCELL_SHARED inkcell_xrgb8888_target_t {
  inkcell_strip_t strip;
  uint32_t colour;  // of the foreground: 0xXXRRGGBB
} inkcell_xrgb8888_target_t;

inkcell_status_t inkcell_a8_sink(inkcell_a8_target_t* target,
                                 inkcell_sink_t* out);
inkcell_status_t inkcell_grey8_sink(inkcell_grey8_target_t* target,
                                    inkcell_sink_t* out);
inkcell_status_t inkcell_grey4_sink(inkcell_grey4_target_t* target,
                                    inkcell_sink_t* out);
inkcell_status_t inkcell_grey2_sink(inkcell_grey2_target_t* target,
                                    inkcell_sink_t* out);
inkcell_status_t inkcell_mono_rows_sink(inkcell_mono_rows_target_t* target,
                                        inkcell_sink_t* out);
inkcell_status_t inkcell_mono_pages_sink(inkcell_mono_pages_target_t* target,
                                         inkcell_sink_t* out);
inkcell_status_t inkcell_rgb565_sink(inkcell_rgb565_target_t* target,
                                     inkcell_sink_t* out);
inkcell_status_t inkcell_rgb888_sink(inkcell_rgb888_target_t* target,
                                     inkcell_sink_t* out);
inkcell_status_t inkcell_xrgb8888_sink(inkcell_xrgb8888_target_t* target,
                                       inkcell_sink_t* out);

/// Draws all pixels of a sink's window: a background.
void inkcell_fill(const inkcell_sink_t* sink);

// With a coverage for each sub-pixel: for inkcell_style_set_lcd().
inkcell_status_t inkcell_rgb565_lcd_sink(inkcell_rgb565_target_t* target,
                                         inkcell_sink_t* out);
inkcell_status_t inkcell_rgb888_lcd_sink(inkcell_rgb888_target_t* target,
                                         inkcell_sink_t* out);
inkcell_status_t inkcell_xrgb8888_lcd_sink(inkcell_xrgb8888_target_t* target,
                                           inkcell_sink_t* out);

// Which spread intermediate coverage over neighbours, for shadows and glows:
// inkcell/port/dither.hpp.
inkcell_status_t inkcell_mono_rows_dithered_sink(
    inkcell_mono_rows_target_t* target, inkcell_sink_t* out);
inkcell_status_t inkcell_mono_pages_dithered_sink(
    inkcell_mono_pages_target_t* target, inkcell_sink_t* out);
inkcell_status_t inkcell_grey2_dithered_sink(inkcell_grey2_target_t* target,
                                             inkcell_sink_t* out);
inkcell_status_t inkcell_grey4_dithered_sink(inkcell_grey4_target_t* target,
                                             inkcell_sink_t* out);

/// A screen, the memory for its strips, and the functions that draw and send
/// them. Strips are as high as the buffer allows.
typedef struct inkcell_strip_loop_t {
  uint8_t* buffer;  // for a strip, of a row at least; the caller's
  size_t size;      // of the buffer [bytes]
  /// Null, or a second one of that size, without overlap: then a strip is drawn
  /// while the one before it is sent, flush() starts a transfer and returns.
  uint8_t* second;
  uint8_t format;  // INKCELL_RGB565 and others
  uint8_t order;   // of all strips: INKCELL_LOW_FIRST or INKCELL_HIGH_FIRST
  int32_t width;   // of the screen [px], 1..32767
  int32_t height;  // likewise
  /// The first argument of `draw`.
  void* context;
  /// Draws everything that meets the strip: background first, then text.
  inkcell_status_t (*draw)(void* context, const inkcell_strip_t* strip);
  /// The first argument of `flush` and `wait`.
  void* display;
  /// Sends the strip to its place on the screen.
  inkcell_status_t (*flush)(void* display, const inkcell_strip_t* strip);
  /// Needed with a second buffer: returns when no transfer is under way.
  inkcell_status_t (*wait)(void* display);
} inkcell_strip_loop_t;

/// Calls draw and flush for the strips of `part`, from top to bottom, and waits
/// for the last transfer. The part is cut to the screen, and widened to whole
/// bytes and pages; null is the whole screen. The picture is the same for every
/// size of the buffer.
///
/// BAD_ARGUMENT: a side of the screen is out of range, a function is null, or
/// the buffers overlap. BUFFER_SMALL: the buffer does not hold a row, or page,
/// of the part. Nothing is called then. Any other result is the first of draw,
/// flush or wait that is not INKCELL_OK; nothing is sent after it.
inkcell_status_t inkcell_run_strips(const inkcell_strip_loop_t* loop,
                                    const inkcell_rect_t* part);

#ifdef __cplusplus
}
#endif
