// Glyphs of several colours in LVGL, beside those of a painter.
#include <stdint.h>

#include <cstdlib>
#include <vector>

#include "check.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/port/colour.hpp"
#include "layer_font.hpp"
#include "lvgl.h"
#include "screen.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kWidth = 60;
constexpr int32_t kHeight = 40;
constexpr int32_t kSize_q6 = 24 * 64;

using Picture = std::vector<uint8_t>;

Picture draw(inkcell_lv_font_t& font,
             lv_color_format_t format,
             int32_t rows,
             lv_opa_t opacity = LV_OPA_COVER,
             int32_t rotation = 0) {
  Screen screen(kWidth, kHeight, format, rows);
  inkcell_lv_font_set_direct(&font);  // anew after lv_deinit()
  Look look;
  look.font = &font.lv;
  look.text = "AB";
  look.x = 7;
  look.y = 3;
  look.opacity = opacity;
  look.rotation = rotation;
  screen.add(look);
  return screen.draw();
}

// The same by a painter, on the background of a Look.
Picture draw_by_painter(const Font& font,
                        const inkcell_lv_font_t& like,
                        bool in_colours) {
  const Look look;
  Picture picture(3 * kWidth * kHeight);
  Strip strip;
  strip.pixels = {picture.data(), picture.size()};
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = 3 * kWidth;
  port::Rgb888Canvas canvas(strip, look.colour, look.background,
                            port::ChannelOrder::blue_first);
  const ColourGlyphs colours(port::colour_of(canvas));
  Painter(canvas, {}, in_colours ? &colours : nullptr)
      .text(
          font, Style(Q26_6::from_raw(kSize_q6), kFilterText),
          {7_px, Q26_6::from_int(3 + like.lv.line_height - like.lv.base_line)},
          "AB");
  return picture;
}

int32_t distance(const Picture& a, const Picture& b) {
  int32_t most = a.size() == b.size() ? 0 : 255;
  for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const int32_t by = std::abs(a[i] - b[i]);
    most = by > most ? by : most;
  }
  return most;
}

}  // namespace

// LVGL rounds in another way than canvases: 3 levels apart, 4 where layers lie
// over each other.
TEST(colours_are_those_of_a_painter) {
  const Font rom = layer_font::font_with(layer_font::kRows);
  inkcell_lv_font_t font;
  CHECK_EQ(
      inkcell_lv_font_init(&font, rom.rom().data, rom.rom().size, kSize_q6),
      LV_RESULT_OK);
  const Picture mono = draw(font, LV_COLOR_FORMAT_RGB888, kHeight);
  CHECK(distance(mono, draw_by_painter(rom, font, false)) <= 3);
  {
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, kHeight);
    inkcell_lv_font_set_colours(&font);
  }
  const Picture coloured = draw(font, LV_COLOR_FORMAT_RGB888, kHeight);
  CHECK(distance(coloured, draw_by_painter(rom, font, true)) <= 4);
  CHECK(distance(coloured, mono) > 100);
}

TEST(colours_are_drawn_into_any_layer) {
  const Font rom = layer_font::font_with(layer_font::kRows);
  alignas(8) static uint8_t ram[4096];
  for (const lv_color_format_t format :
       {LV_COLOR_FORMAT_RGB565, LV_COLOR_FORMAT_RGB888,
        LV_COLOR_FORMAT_XRGB8888, LV_COLOR_FORMAT_ARGB8888,
        LV_COLOR_FORMAT_L8}) {
    for (const lv_opa_t opacity : {LV_OPA_COVER, LV_OPA_40}) {
      for (const int32_t rotation : {0, 300}) {
        inkcell_lv_font_t font;
        CHECK_EQ(inkcell_lv_font_init(&font, rom.rom().data, rom.rom().size,
                                      kSize_q6),
                 LV_RESULT_OK);
        const Picture mono = draw(font, format, kHeight, opacity, rotation);
        {
          Screen screen(kWidth, kHeight, format, kHeight);
          inkcell_lv_font_set_colours(&font);
        }
        const Picture whole = draw(font, format, kHeight, opacity, rotation);
        CHECK(whole != mono);
        if (rotation == 0) {
          CHECK(whole == draw(font, format, 7, opacity));
        }
      }
    }
  }
  // From a cache, whose 4 bits are off by little.
  inkcell_lv_font_t font;
  inkcell_lv_cache_t cache;
  CHECK_EQ(
      inkcell_lv_font_init(&font, rom.rom().data, rom.rom().size, kSize_q6),
      LV_RESULT_OK);
  CHECK_EQ(inkcell_lv_cache_init(&cache, ram, sizeof ram, 1), LV_RESULT_OK);
  {
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, kHeight);
    inkcell_lv_font_set_colours(&font);
  }
  const Picture exact = draw(font, LV_COLOR_FORMAT_RGB888, kHeight);
  {
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB888, kHeight);
    inkcell_lv_font_set_cache(&font, &cache);
  }
  for (int32_t round = 0; round < 2; ++round) {
    CHECK(distance(exact, draw(font, LV_COLOR_FORMAT_RGB888, kHeight)) <= 12);
  }
  inkcell_lv_cache_stats_t stats;
  inkcell_lv_cache_stats(&cache, &stats);
  CHECK(stats.hits > 0 && stats.misses > 0);
}
