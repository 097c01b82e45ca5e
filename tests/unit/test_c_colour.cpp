// Glyphs of several colours from C are those of C++.
#include <inkcell/inkcell.h>

#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/layers/colour_cache.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/port/colour.hpp"
#include "layer_font.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kSide = 24;
constexpr size_t kBytes = kSide * kSide * 4;

alignas(4) uint8_t by_c[kBytes];
alignas(4) uint8_t by_cpp[kBytes];

void clear() {
  __builtin_memset(by_c, 0x33, kBytes);
  __builtin_memset(by_cpp, 0x33, kBytes);
}

Strip strip_of(uint8_t* pixels, PixelFormat format) {
  const int32_t stride = stride_bytes(format, kSide);
  return {{pixels, static_cast<size_t>(stride * kSide)},
          0,
          0,
          kSide,
          kSide,
          stride};
}

// Draws with what both make of a target and a canvas; they have a colour each.
template <typename Target, typename OneCanvas>
void check_same(PixelFormat format,
                inkcell_status_t (*open)(Target*, inkcell_sink_t*),
                void (*make)(Target*,
                             const inkcell_glyph_cache_t*,
                             inkcell_colour_glyphs_t*),
                const Target& like,
                OneCanvas canvas,
                bool has_cache) {
  alignas(8) static uint8_t ram[2][2048];
  inkcell_glyph_cache_t cache_of_c;
  const inkcell_glyph_cache_options_t options = {8, 1, 1};
  CHECK_EQ(
      inkcell_glyph_cache_make(ram[0], sizeof ram[0], &options, &cache_of_c),
      INKCELL_OK);
  GlyphCache cache;
  CHECK_OK(GlyphCache::make(ram[1], {8, 1, 1}, cache));

  const Font font = layer_font::font_with(layer_font::kRows);
  inkcell_font_t font_of_c;
  CHECK_EQ(inkcell_font_open(font.rom().data, font.rom().size, &font_of_c),
           INKCELL_OK);
  CHECK_EQ(inkcell_font_verify_layers(&font_of_c), INKCELL_OK);
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(20 * 64, &inkcell_filter_area, &style),
           INKCELL_OK);

  Target target = like;
  const Strip strip = strip_of(by_c, format);
  __builtin_memcpy(&target.strip, &strip, sizeof strip);
  inkcell_sink_t sink;
  CHECK_EQ(open(&target, &sink), INKCELL_OK);
  inkcell_colour_glyphs_t colours_of_c;
  make(&target, has_cache ? &cache_of_c : nullptr, &colours_of_c);
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  painter.colours = &colours_of_c;

  canvas.set_strip(strip_of(by_cpp, format));
  ColourGlyphs colours(colour_of(canvas), has_cache ? &cache : nullptr);
  const LayerColour kOwn[] = {{1, 200, 3, 255}};
  const inkcell_layer_colour_t own_of_c[] = {{1, 200, 3, 255}};
  for (uint8_t palette = 0; palette < 3; ++palette) {
    if (palette == 2) {
      colours.set_colours(kOwn);
      inkcell_colour_glyphs_set_colours(&colours_of_c, own_of_c, 1);
    } else {
      colours.set_palette(palette);
      inkcell_colour_glyphs_set_palette(&colours_of_c, palette);
    }
    clear();
    inkcell_draw_text(&painter, &font_of_c, "AB", 2, &style, 2 * 64, 20 * 64);
    Painter(canvas, {}, &colours).text(font, Style(20_px), {2_px, 20_px}, "AB");
    CHECK(__builtin_memcmp(by_c, by_cpp, kBytes) == 0);
    // Not in one colour.
    __builtin_memset(by_cpp, 0x33, kBytes);
    Painter(canvas).text(font, Style(20_px), {2_px, 20_px}, "AB");
    CHECK(__builtin_memcmp(by_c, by_cpp, kBytes) != 0);
  }
  if (has_cache) {
    inkcell_glyph_cache_stats_t stats;
    inkcell_glyph_cache_stats(&cache_of_c, &stats);
    CHECK(stats.hits != 0 && stats.hits == cache.stats().hits);
  }
}

void check_formats(bool has_cache) {
  check_same<inkcell_rgb565_target_t>(
      PixelFormat::rgb565, inkcell_rgb565_sink, inkcell_rgb565_colour_glyphs,
      {{}, 0x1234}, Rgb565Canvas({}, 0x1234), has_cache);
  check_same<inkcell_rgb888_target_t>(
      PixelFormat::rgb888, inkcell_rgb888_sink, inkcell_rgb888_colour_glyphs,
      {{}, 0x123456, INKCELL_RED_FIRST}, Rgb888Canvas({}, 0x123456), has_cache);
  check_same<inkcell_xrgb8888_target_t>(
      PixelFormat::xrgb8888, inkcell_xrgb8888_sink,
      inkcell_xrgb8888_colour_glyphs, {{}, 0xff123456},
      Xrgb8888Canvas({}, 0xff123456), has_cache);
  check_same<inkcell_grey8_target_t>(PixelFormat::grey8, inkcell_grey8_sink,
                                     inkcell_grey8_colour_glyphs, {{}, 0xf0},
                                     Grey8Canvas({}, 0xf0), has_cache);
  check_same<inkcell_grey4_target_t>(
      PixelFormat::grey4, inkcell_grey4_sink, inkcell_grey4_colour_glyphs,
      {{}, 14, INKCELL_HIGH_LEFT}, Grey4Canvas({}, 14), has_cache);
}

TEST(layers_are_the_same_in_c) {
  check_formats(false);
}

TEST(layers_are_the_same_in_c_from_a_cache) {
  check_formats(true);
}

TEST(pictures_are_the_same_in_c) {
  alignas(4) static uint8_t ram[2][8192];
  constexpr layer_font::Row kOwn[] = {{layer_font::kDisc, 0},
                                      {layer_font::kLeaf, 1}};
  const Font font = layer_font::font_with(kOwn);
  inkcell_font_t opened;
  CHECK_EQ(inkcell_font_open(font.rom().data, font.rom().size, &opened),
           INKCELL_OK);
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(20 * 64, &inkcell_filter_area, &style),
           INKCELL_OK);
  inkcell_rgb565_target_t target = {{}, 0x1234};
  const Strip strip = strip_of(by_c, PixelFormat::rgb565);
  __builtin_memcpy(&target.strip, &strip, sizeof strip);
  inkcell_sink_t sink;
  CHECK_EQ(inkcell_rgb565_sink(&target, &sink), INKCELL_OK);
  inkcell_colour_cache_t cache_of_c;
  CHECK_EQ(inkcell_colour_cache_make(ram[0], 511, &cache_of_c),
           INKCELL_BUFFER_SMALL);
  CHECK_EQ(inkcell_colour_cache_make(ram[0], sizeof ram[0], &cache_of_c),
           INKCELL_OK);
  inkcell_colour_glyphs_t colours_of_c;
  inkcell_rgb565_colour_pictures(&target, nullptr, &cache_of_c, &colours_of_c);
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  painter.colours = &colours_of_c;

  Rgb565Canvas canvas(strip_of(by_cpp, PixelFormat::rgb565), 0x1234);
  ColourCache cache;
  CHECK_OK(ColourCache::make(ram[1], cache));
  ColourGlyphs colours(pictures_of(canvas));
  colours.set_cache(cache);
  for (int32_t i = 0; i < 2; ++i) {
    clear();
    inkcell_draw_text(&painter, &opened, "AB", 2, &style, 2 * 64, 20 * 64);
    Painter(canvas, {}, &colours).text(font, Style(20_px), {2_px, 20_px}, "AB");
    CHECK(__builtin_memcmp(by_c, by_cpp, kBytes) == 0);
  }
  inkcell_colour_cache_stats_t stats;
  inkcell_colour_cache_stats(&cache_of_c, &stats);
  CHECK_EQ(stats.hits, 1u);
  CHECK_EQ(stats.misses, 1u);
  inkcell_colour_cache_clear(&cache_of_c);
  inkcell_colour_cache_stats(&cache_of_c, &stats);
  CHECK_EQ(stats.glyphs, 0u);
}

TEST(layers_that_do_not_fit_are_told_in_c) {
  const layer_font::Row nowhere[] = {{31, 0}};
  const Font font = layer_font::font_with(nowhere);
  inkcell_font_t opened;
  CHECK_EQ(inkcell_font_open(font.rom().data, font.rom().size, &opened),
           INKCELL_OK);
  CHECK_EQ(inkcell_font_verify_layers(&opened), INKCELL_CORRUPT);
}

}  // namespace
