// A text that changes in place, and numbers as text, as in
// inkcell/value_label.hpp and inkcell/number_text.hpp.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What of the line stands at its origin.
enum {
  INKCELL_ANCHOR_LEFT = 0,
  INKCELL_ANCHOR_CENTRE = 1,
  INKCELL_ANCHOR_RIGHT = 2
};

/// Keeps its text, of up to 31 bytes, and the pixels of it. Opaque.
typedef struct INKCELL_SHARED inkcell_value_label_t {
  const void* words[2];
  int32_t numbers[6];
  uint8_t bytes[33];
} inkcell_value_label_t;

/// An empty text. Font and style must outlive it.
void inkcell_value_label_init(inkcell_value_label_t* value,
                              const inkcell_font_t* font,
                              const inkcell_style_t* style,
                              int32_t x_q6,
                              int32_t y_q6,
                              uint8_t anchor);

/// Copies a text, cut after a whole character. `out` has the pixels of the old
/// and of the new one, to draw and to send; it is empty if the text is the
/// same. `painter` is like the one that draws: of a sink of 1 or 2 bits, of
/// which window and strip do not matter, or with a cache; else null.
void inkcell_value_label_set(inkcell_value_label_t* value,
                             const inkcell_painter_t* painter,
                             const char* text,
                             size_t size,
                             inkcell_rect_t* out);

/// Draws the text. The background is yours.
void inkcell_value_label_draw(const inkcell_value_label_t* value,
                              const inkcell_painter_t* painter);

/// The bytes that a number takes as text, with a unit of 11 bytes.
#define INKCELL_NUMBER_BYTES 33


/// `value`, in units of the last of `decimals`, 0 to 9, as text: 235 and 1 are
/// "23.5". `digits`, 1 to 10, is the fewest before the decimal sign `point`.
/// `out` has INKCELL_NUMBER_BYTES, and is what is returned.
const char* inkcell_number_text(int32_t value,
                                int32_t decimals,
                                int32_t digits,
                                char point,
                                char* out);

/// The same of a number in fixed point, rounded. [Q16]
const char* inkcell_number_text_of_q16(int32_t value_q16,
                                       int32_t decimals,
                                       int32_t digits,
                                       char point,
                                       char* out);

/// Puts a unit such as " \xC2\xB0" "C" behind a number of the functions above,
/// which is what is returned. What has no room is cut off after a whole
/// character.
const char* inkcell_number_add_unit(char* number, const char* unit);

#ifdef __cplusplus
}
#endif
