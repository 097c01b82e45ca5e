// stb_truetype as an engine: the outline through its rasterizer into a bitmap.
// Way: "upright".
#include <stb_truetype.h>
#include <string.h>

#include "engine.h"
#include "heap.h"

static uint8_t pixels[kEngineSide * kEngineSide];
static stbtt_fontinfo face;
static float scale;
static int width;
static int height;

bool engine_open(const uint8_t* font, size_t size) {
  return size != 0 && stbtt_InitFont(&face, font, 0) != 0;
}

bool engine_set_size(uint32_t px, const char* way) {
  scale = stbtt_ScaleForMappingEmToPixels(&face, (float)px);
  heap_forget();
  return strcmp(way, "upright") == 0;
}

static int measure(uint32_t code_point) {
  int x0, y0, x1, y1;
  const int glyph = stbtt_FindGlyphIndex(&face, (int)code_point);
  stbtt_GetGlyphBitmapBox(&face, glyph, scale, scale, &x0, &y0, &x1, &y1);
  width = x1 - x0;
  height = y1 - y0;
  return glyph;
}

enum engine_answer engine_prepare(uint32_t code_point) {
  if (measure(code_point) == 0) {
    return engine_lacks;
  }
  return width > kEngineSide || height > kEngineSide ? engine_too_large
                                                     : engine_ready;
}

void engine_draw(uint32_t code_point) {
  const int glyph = measure(code_point);
  if (width > 0 && height > 0) {
    stbtt_MakeGlyphBitmap(&face, pixels, width, height, kEngineSide, scale,
                          scale, glyph);
  }
}

uint32_t engine_ink(void) {
  uint32_t sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      sum += pixels[y * kEngineSide + x];
    }
  }
  return sum;
}

uint32_t engine_box(void) {
  return (uint32_t)(width * height);
}

size_t engine_heap(void) {
  return heap_most();
}

size_t engine_workspace(void) {
  return 0;
}
