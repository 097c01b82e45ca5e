// What a line of text into each canvas is measured with, in C++ and in C.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kCanvasWidth = 512, kCanvasHeight = 128, kCanvasMostBytes = 4 };

// Opens a font that stays where it is.
bool canvas_open_font(const uint8_t* font, size_t size);

// Sets the canvas that is drawn to from now on, over `pixels` of
// kCanvasMostBytes each. Its name; null: there are no more.
const char* canvas_set(uint32_t number, uint8_t* pixels);

// The size of the text from now on.
bool canvas_set_size(int32_t px);

// Draws a line, with `bytes` of RAM lent. Counted.
void canvas_draw(const char* text, uint8_t* ram, size_t bytes);

#ifdef __cplusplus
}
#endif
