// What all headers of the C interface share: status, fixed point, rectangles.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The library, which is C++, has other names for the types that it shares with
/// C: compilers must not assume that they are different memory.
#define INKCELL_SHARED __attribute__((may_alias))


/// Why a call failed. Values never change: they end up in field logs.
typedef uint8_t inkcell_status_t;
enum {
  INKCELL_OK = 0,
  INKCELL_BAD_MAGIC = 1,     // not an Inkcell font
  INKCELL_BAD_VERSION = 2,   // a format that this library does not read
  INKCELL_CORRUPT = 3,       // an offset, a length or a checksum does not fit
  INKCELL_NO_GLYPH = 4,      // code point or glyph id absent
  INKCELL_BUFFER_SMALL = 5,  // shorter than the minimum that the call states
  INKCELL_MISALIGNED = 6,    // memory that is not at the multiple it must be
  INKCELL_UNSUPPORTED = 7,   // a coding or effect that is not there
  INKCELL_BAD_ARGUMENT = 8,  // outside the range that the call states
  INKCELL_BEYOND_BAND = 9,   // farther than the font's distances reach
  INKCELL_READ_FAILED = 10,  // the storage of a font did not give its bytes
  INKCELL_CUT = 11,          // a text was longer than what takes it
  INKCELL_NEEDS_SHAPING = 12  // letters that are to be joined were not
};

/// Evaluates a call once and returns its status unless that is INKCELL_OK.
#define INKCELL_RETURN_ON_ERROR(call)            \
  do {                                           \
    const inkcell_status_t inkcell_try = (call); \
    if (inkcell_try != INKCELL_OK) {             \
      return inkcell_try;                        \
    }                                            \
  } while (0)

/// The name of a status, such as "bad_magic", or "unknown". In ROM.
const char* inkcell_status_name(inkcell_status_t status);

/// Constants in px, with or without a fraction, as fixed-point numbers.
#define INKCELL_Q6(px) ((int32_t)((px)*64))
#define INKCELL_Q10(px) ((int16_t)((px)*1024))
#define INKCELL_Q16(px) ((int32_t)((px)*65536))


/// As the size of a text: it ends at its first zero byte.
#define INKCELL_TERMINATED SIZE_MAX


/// Pixels of the screen, x to the right and y down: x0 <= x < x1, y0 <= y < y1.
/// Empty if x1 <= x0 or y1 <= y0.
typedef struct INKCELL_SHARED inkcell_rect_t {
  int32_t x0;
  int32_t y0;
  int32_t x1;
  int32_t y1;
} inkcell_rect_t;

/// RAM lent for drawing one glyph at a time. `data` is a multiple of 4. Its
/// content has no meaning between calls. Tasks that draw at the same time need
/// one each. 2,560 bytes take 0.6 KB off the stack; the picture is the same.
typedef struct INKCELL_SHARED inkcell_workspace_t {
  uint8_t* data;
  size_t size;  // [bytes]
} inkcell_workspace_t;

#ifdef __cplusplus
}
#endif
