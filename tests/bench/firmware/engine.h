// What the bench asks of an engine that draws glyphs, in C.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Width and height of the largest glyph that engines find room for. [px]
enum { kEngineSide = 208 };

// Opens a font that stays where it is.
bool engine_open(const uint8_t* font, size_t size);

// Draws at `px` to the em from now on, in one of the engine's ways.
bool engine_set_size(uint32_t px, const char* way);

enum engine_answer { engine_lacks, engine_too_large, engine_ready };

// Gets ready for one call of engine_draw(). Not counted.
enum engine_answer engine_prepare(uint32_t code_point);

// From the code point to 8-bit coverage. Counted.
void engine_draw(uint32_t code_point);

// The sum of the coverage that engine_draw() left, and the pixels of the ink's
// box.
uint32_t engine_ink(void);
uint32_t engine_box(void);

// The most RAM that this size took so far, from the heap or lent by the caller.
// Inkcell's pixels are not included, nor are stb_truetype's. [bytes]
size_t engine_heap(void);
size_t engine_workspace(void);

#ifdef __cplusplus
}
#endif
