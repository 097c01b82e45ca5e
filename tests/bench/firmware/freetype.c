// FreeType as an engine: the outline, scaled without hinting, through the
// smooth rasterizer into the bitmap of the face's own slot. Way: "upright".
#include <ft2build.h>
#include FT_FREETYPE_H

#include <string.h>

#include "engine.h"
#include "heap.h"

static FT_Library library;
static FT_Face face;

bool engine_open(const uint8_t* font, size_t size) {
  return FT_Init_FreeType(&library) == 0 &&
         FT_New_Memory_Face(library, font, (FT_Long)size, 0, &face) == 0;
}

bool engine_set_size(uint32_t px, const char* way) {
  heap_forget();
  return strcmp(way, "upright") == 0 && FT_Set_Pixel_Sizes(face, 0, px) == 0;
}

enum engine_answer engine_prepare(uint32_t code_point) {
  return FT_Get_Char_Index(face, code_point) == 0 ? engine_lacks : engine_ready;
}

void engine_draw(uint32_t code_point) {
  const FT_UInt glyph = FT_Get_Char_Index(face, code_point);
  if (FT_Load_Glyph(face, glyph,
                    FT_LOAD_RENDER | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP)) {
    face->glyph->bitmap.rows = 0;
  }
}

uint32_t engine_ink(void) {
  const FT_Bitmap* const bitmap = &face->glyph->bitmap;
  uint32_t sum = 0;
  for (unsigned y = 0; y < bitmap->rows; ++y) {
    for (unsigned x = 0; x < bitmap->width; ++x) {
      sum += bitmap->buffer[(int)y * bitmap->pitch + (int)x];
    }
  }
  return sum;
}

uint32_t engine_box(void) {
  return face->glyph->bitmap.width * face->glyph->bitmap.rows;
}

size_t engine_heap(void) {
  return heap_most();
}

size_t engine_workspace(void) {
  return 0;
}
