// Glyphs of outlines that a cache holds, and what a bitmap font does for the
// same picture: 4 bits a pixel, row after row without a gap. Both from the code
// point to 8-bit coverage.
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/painter.hpp"

#include "inkcell_strips.hpp"

using namespace inkcell;

namespace {

constexpr size_t kCacheBytes = 48 * 1024;
alignas(8) uint8_t cache_bytes[kCacheBytes];
GlyphCache cache;

bool is_bitmap = false;

// What a bitmap font has of the glyph.
constexpr size_t kBitmapBytes = kEngineSide * kEngineSide / 2;
uint8_t bitmap[kBitmapBytes];
Rect bitmap_box;

void make_bitmap() {
  for (uint8_t& byte : bitmap) {
    byte = 0;
  }
  uint32_t i = 0;
  for (int32_t y = bitmap_box.y0; y < bitmap_box.y1; ++y) {
    for (int32_t x = bitmap_box.x0; x < bitmap_box.x1; ++x, ++i) {
      const uint32_t level =
          (bench::pixels[y * kEngineSide + x] + uint32_t{8}) / 17;
      bitmap[i / 2] = static_cast<uint8_t>(bitmap[i / 2] |
                                           (i % 2 == 0 ? level << 4 : level));
    }
  }
}

__attribute__((noinline)) void draw_bitmap() {
  const uint8_t* from = bitmap;
  uint32_t byte = 0;
  bool is_second = false;
  for (int32_t y = bitmap_box.y0; y < bitmap_box.y1; ++y) {
    uint8_t* to = bench::pixels + y * kEngineSide + bitmap_box.x0;
    for (int32_t x = bitmap_box.x0; x < bitmap_box.x1; ++x) {
      uint32_t level;
      if (is_second) {
        level = byte & 15;
      } else {
        byte = *from++;
        level = byte >> 4;
      }
      is_second = !is_second;
      *to++ = static_cast<uint8_t>(level * 17);
    }
  }
}

// The box of what is drawn, as a bitmap font has it.
Rect ink_box() {
  Rect box = {kEngineSide, kEngineSide, 0, 0};
  for (int32_t y = 0; y < bench::height; ++y) {
    for (int32_t x = 0; x < kEngineSide; ++x) {
      if (bench::pixels[y * kEngineSide + x] >= 9) {
        box = {x < box.x0 ? x : box.x0, y < box.y0 ? y : box.y0,
               x + 1 > box.x1 ? x + 1 : box.x1, y + 1};
      }
    }
  }
  return box;
}

void draw(uint16_t glyph) {
  bench::draw_strips([glyph] {
    Painter(bench::sink, {}, &cache)
        .glyph(bench::font, bench::style, bench::origin, glyph);
  });
}

void clear_pixels() {
  for (uint8_t& pixel : bench::pixels) {
    pixel = 0;
  }
}

}  // namespace

bool engine_set_size(uint32_t px, const char* way) {
  is_bitmap = bench::equal(way, "bitmap");
  bench::style = Style(Q26_6::from_int(static_cast<int32_t>(px)), kFilterText);
  return GlyphCache::make(cache_bytes, {}, cache) == Status::ok;
}

engine_answer engine_prepare(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return engine_lacks;
  }
  const engine_answer answer = bench::place(
      glyph, Painter().glyph_box(bench::font, bench::style, {}, glyph));
  if (answer == engine_ready) {
    draw(glyph);
    bitmap_box = ink_box();
    make_bitmap();
    clear_pixels();
  }
  return answer;
}

void engine_draw(uint32_t code_point) {
  uint16_t glyph = 0;
  if (bench::font.glyph_of(code_point, glyph) != Status::ok) {
    return;
  }
  if (is_bitmap) {
    draw_bitmap();
  } else {
    draw(glyph);
  }
}

size_t engine_workspace() {
  return is_bitmap ? 0 : cache.stats().bytes;
}
