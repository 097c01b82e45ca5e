// The adapter in the real LVGL: metrics, pictures, fallbacks, RAM.
#include <stdint.h>
#include <string.h>

#include <string>
#include <vector>

#include "check.hpp"
#include "example.h"
#include "fonts/lv_sans.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "lvgl.h"
#include "screen.hpp"
#include "sfnt_font.hpp"
#include "small_strike.hpp"

namespace {

using inkcell::Q26_6;

constexpr int32_t kWidth = 240;
constexpr int32_t kHeight = 96;

const lv_color_format_t kFormats[] = {
    LV_COLOR_FORMAT_RGB565, LV_COLOR_FORMAT_RGB888, LV_COLOR_FORMAT_XRGB8888,
    LV_COLOR_FORMAT_ARGB8888, LV_COLOR_FORMAT_L8};

bool make_font(inkcell_lv_font_t& font, int32_t size_q6) {
  return inkcell_lv_font_init(&font, fonts::lv_sans, sizeof fonts::lv_sans,
                              size_q6) == LV_RESULT_OK;
}

using Picture = std::vector<uint8_t>;

// One label on a screen of its own.
Picture draw(inkcell_lv_font_t& font,
             bool is_direct,
             lv_color_format_t format,
             int32_t rows,
             Look look,
             inkcell_lv_cache_t* cache = nullptr) {
  Screen screen(kWidth, kHeight, format, rows);
  if (is_direct) {
    inkcell_lv_font_set_direct(&font);
  }
  if (cache != nullptr) {
    inkcell_lv_font_set_cache(&font, cache);
  }
  look.font = &font.lv;
  screen.add(look);
  return screen.draw();
}

size_t count_other(const Picture& a, const Picture& b) {
  size_t count = a.size() == b.size() ? 0 : 1;
  for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
    count += a[i] != b[i];
  }
  return count;
}

Look text(const char* text) {
  Look look;
  look.text = text;
  look.x = 7;
  look.y = 9;
  return look;
}

const char* const kText = "AVATAR 0.9 gj\nTo, fi \xc3\xa4";

}  // namespace

TEST(font_is_of_its_size) {
  inkcell_lv_font_t font;
  CHECK(make_font(font, 20 * 64));
  CHECK_EQ(font.lv.base_line, 5);     // 483 of 2048 units below: 4.7 px
  CHECK_EQ(font.lv.line_height, 24);  // 1901 above: 18.6 px
  CHECK_EQ(font.lv.underline_thickness, 1);
  CHECK_EQ(font.lv.underline_position, -2);
  CHECK(make_font(font, 100 * 64));
  CHECK_EQ(font.lv.underline_thickness, 5);
  CHECK_EQ(font.lv.underline_position, -10);
}

TEST(wrong_fonts_are_refused) {
  inkcell_lv_font_t font;
  memset(&font, 0x55, sizeof font);
  const inkcell_lv_font_t before = font;
  static const uint32_t kNothing[64] = {};
  CHECK_EQ(inkcell_lv_font_init(&font, kNothing, sizeof kNothing, 16 * 64),
           LV_RESULT_INVALID);
  CHECK(!make_font(font, 3 * 64));
  CHECK(!make_font(font, 1025 * 64));
  CHECK_EQ(memcmp(&font, &before, sizeof font), 0);
}

TEST(strikes_alone_are_pictures) {
  alignas(4) static uint8_t rom[2048];
  const size_t size = small_strike::build(small_strike::kGlyphs, rom);
  inkcell_lv_font_t font;
  CHECK_EQ(inkcell_lv_font_init(&font, rom, size, 8 * 64), LV_RESULT_INVALID);
  CHECK_EQ(inkcell_lv_font_init_outline_strike(&font, rom, size, 8 * 64, true),
           LV_RESULT_INVALID);
  CHECK_EQ(inkcell_lv_font_init_strike(&font, rom, size, 9 * 64),
           LV_RESULT_INVALID);
  const Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, kHeight);
  strike_font::Values wanted;
  small_strike::draw_glyph(2, wanted);
  for (int32_t scale = 1; scale != 3; ++scale) {
    CHECK_EQ(inkcell_lv_font_init_strike(&font, rom, size, scale * 8 * 64),
             LV_RESULT_OK);
    lv_font_glyph_dsc_t glyph = {};
    CHECK(lv_font_get_glyph_dsc(&font.lv, &glyph, 'B', 0));
    CHECK_EQ(glyph.adv_w, 7 * scale);
    CHECK_EQ(glyph.box_w, wanted.width * scale);
    CHECK_EQ(glyph.box_h, wanted.height * scale);
    CHECK_EQ(glyph.ofs_y, 0);
    lv_draw_buf_t* const buffer =
        lv_draw_buf_create(glyph.box_w, glyph.box_h, LV_COLOR_FORMAT_A8, 0);
    CHECK(font.lv.get_glyph_bitmap(&glyph, buffer) == buffer);
    for (int32_t y = 0; y != glyph.box_h; ++y) {
      for (int32_t x = 0; x != glyph.box_w; ++x) {
        const size_t at = static_cast<size_t>(y) * buffer->header.stride +
                          static_cast<size_t>(x);
        CHECK_EQ(buffer->data[at],
                 wanted.at[y / scale][x / scale] != 0 ? 255 : 0);
      }
    }
    lv_draw_buf_destroy(buffer);
  }
}

// The style that strikes serve draws a font that has none of its outlines.
TEST(strikes_beside_outlines_take_a_fitted_style) {
  inkcell_lv_font_t plain;
  CHECK(make_font(plain, 12 * 64));
  const Picture unfitted =
      draw(plain, false, LV_COLOR_FORMAT_L8, kHeight, text(kText));
  Picture drawn[2];
  for (int i = 0; i != 2; ++i) {
    inkcell_lv_font_t font;
    CHECK_EQ(inkcell_lv_font_init_outline_strike(
                 &font, fonts::lv_sans, sizeof fonts::lv_sans, 12 * 64, i != 0),
             LV_RESULT_OK);
    drawn[i] = draw(font, false, LV_COLOR_FORMAT_L8, kHeight, text(kText));
    CHECK(count_other(drawn[i], unfitted) > 100);
  }
  CHECK(count_other(drawn[0], drawn[1]) > 100);
}

TEST(truetype_files_are_fonts_of_any_size) {
  alignas(4) static uint8_t bytes[2048];
  const size_t size = sfnt_font::build(bytes, {});
  inkcell_lv_truetype_t file = {};
  inkcell_lv_font_t font;
  CHECK_EQ(inkcell_lv_font_init_truetype(&font, &file, 20 * 64),
           LV_RESULT_INVALID);
  CHECK_EQ(inkcell_lv_truetype_open(&file, fonts::lv_sans, size),
           LV_RESULT_INVALID);
  CHECK_EQ(inkcell_lv_truetype_open(&file, bytes, size), LV_RESULT_OK);
  CHECK_EQ(inkcell_lv_font_init_truetype(&font, &file, 2000 * 64),
           LV_RESULT_INVALID);
  for (const int32_t px : {10, 20}) {
    CHECK_EQ(inkcell_lv_font_init_truetype(&font, &file, px * 64),
             LV_RESULT_OK);
    // Of 1,000 units: A is 600 wide, and a square of 400 by 700.
    CHECK_EQ(lv_font_get_glyph_width(&font.lv, 'A', 0), px * 6 / 10);
    lv_font_glyph_dsc_t glyph = {};
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, kHeight);
    CHECK(lv_font_get_glyph_dsc(&font.lv, &glyph, 'A', 0));
    CHECK_EQ(glyph.box_w, px * 4 / 10 + 2);  // a pixel on each side
    CHECK_EQ(glyph.box_h, px * 7 / 10 + 2);
  }
  for (const bool is_direct : {false, true}) {
    inkcell_lv_font_t drawn;
    CHECK_EQ(inkcell_lv_font_init_truetype(&drawn, &file, 20 * 64),
             LV_RESULT_OK);
    Look look = text("A");
    look.colour = 0x000000;
    look.background = 0xffffff;
    const Picture picture =
        draw(drawn, is_direct, LV_COLOR_FORMAT_L8, kHeight, look);
    size_t black = 0;
    for (const uint8_t level : picture) {
      black += level == 0;
    }
    CHECK_EQ(black, 8u * 14u);
  }
}

TEST(advances_are_kerned_and_rounded) {
  inkcell::Font plain;
  CHECK_OK(inkcell::Font::open({fonts::lv_sans, sizeof fonts::lv_sans}, plain));
  for (const int32_t size_q6 : {14 * 64, 14 * 64 + 32, 61 * 64}) {
    inkcell_lv_font_t font;
    CHECK(make_font(font, size_q6));
    inkcell::Style style(Q26_6::from_raw(size_q6), inkcell::kFilterText);
    const uint16_t a = plain.glyph_or_notdef('A');
    const uint16_t v = plain.glyph_or_notdef('V');
    const int32_t units = plain.advance(a) + plain.kerning(a, v);
    CHECK(plain.kerning(a, v) < 0);
    CHECK_EQ(lv_font_get_glyph_width(&font.lv, 'A', 'V'),
             (to_px(plain, style, units).raw + 32) / 64);
    lv_font_set_kerning(&font.lv, LV_FONT_KERNING_NONE);
    CHECK_EQ(lv_font_get_glyph_width(&font.lv, 'A', 'V'),
             (to_px(plain, style, plain.advance(a)).raw + 32) / 64);
  }
}

TEST(fitted_advances_are_the_fits) {
  inkcell_lv_font_t font;
  inkcell_lv_fit_t fit;
  CHECK(make_font(font, 10 * 64));
  CHECK_EQ(inkcell_lv_font_fit_grid(&font, &fit), LV_RESULT_OK);
  inkcell::Font plain;
  CHECK_OK(inkcell::Font::open({fonts::lv_sans, sizeof fonts::lv_sans}, plain));
  inkcell::Style style(Q26_6::from_int(10), inkcell::kFilterText);
  inkcell::FitOptions options;
  options.across = true;
  inkcell::Fit expected;
  CHECK_OK(inkcell::Fit::make(plain, style, options, expected));
  style.set_fit(expected);
  for (const char letter : {'m', 'i', 'W', ' '}) {
    CHECK_EQ(
        lv_font_get_glyph_width(&font.lv, static_cast<uint8_t>(letter), 0),
        style.fitter()->advance_px(
            plain, style, plain.glyph_or_notdef(static_cast<uint8_t>(letter))));
  }
}

// LVGL blends a glyph's whole A8 bitmap, the draw unit what lies in the strip.
TEST(direct_pictures_are_those_of_bitmaps) {
  for (const lv_color_format_t format : kFormats) {
    for (const int32_t size_q6 : {13 * 64 + 32, 28 * 64, 90 * 64}) {
      Look look = text(kText);
      for (const lv_opa_t opacity : {LV_OPA_COVER, LV_OPA_40}) {
        look.opacity = opacity;
        inkcell_lv_font_t font;
        CHECK(make_font(font, size_q6));
        const Picture bitmaps = draw(font, false, format, kHeight, look);
        CHECK(count_other(bitmaps,
                          draw(font, false, format, kHeight, text(""))) > 500);
        CHECK_EQ(count_other(bitmaps, draw(font, true, format, kHeight, look)),
                 0);
        CHECK_EQ(count_other(bitmaps, draw(font, true, format, 7, look)), 0);
      }
    }
  }
}

TEST(options_draw_alike_in_both_ways) {
  const Look look = text(kText);
  const auto plain = [&look] {
    inkcell_lv_font_t font;
    CHECK(make_font(font, 20 * 64));
    return draw(font, false, LV_COLOR_FORMAT_L8, kHeight, look);
  }();
  const auto compare = [&look, &plain](inkcell_lv_font_t& font) {
    const Picture bitmaps =
        draw(font, false, LV_COLOR_FORMAT_L8, kHeight, look);
    CHECK(count_other(plain, bitmaps) > 100);
    CHECK_EQ(
        count_other(bitmaps, draw(font, true, LV_COLOR_FORMAT_L8, 11, look)),
        0);
    return bitmaps;
  };
  const auto ink = [](const Picture& picture) {
    int64_t sum = 0;
    for (const uint8_t level : picture) {
      sum += 255 - level;
    }
    return sum;
  };
  inkcell_lv_font_t font;
  inkcell_lv_fit_t fit;
  CHECK(make_font(font, 20 * 64));
  CHECK_EQ(inkcell_lv_font_fit_heights(&font, &fit), LV_RESULT_OK);
  compare(font);
  CHECK(make_font(font, 20 * 64));
  CHECK_EQ(inkcell_lv_font_fit_grid(&font, &fit), LV_RESULT_OK);
  compare(font);
  inkcell_lv_weight_t weight;
  CHECK(make_font(font, 20 * 64));
  inkcell_lv_font_set_weight(&font, &weight, 24);
  CHECK(ink(compare(font)) > ink(plain));
  CHECK(make_font(font, 20 * 64));
  inkcell_lv_font_set_weight(&font, &weight, -16);
  CHECK(ink(compare(font)) < ink(plain));
}

// What LVGL logged since it was emptied.
std::string logged;

void take_log(lv_log_level_t, const char* text) {
  logged += text;
}

bool has_logged(const char* call, const char* why) {
  const size_t at = logged.find(call);
  const bool is_there = at != std::string::npos &&
                        logged.find(why) != std::string::npos &&
                        logged.find(call, at + 1) == std::string::npos;
  logged.clear();
  return is_there;
}

TEST(refusals_are_logged_once_with_their_reason) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, 20);
  lv_log_register_print_cb(take_log);
  logged.clear();
  inkcell_lv_font_t font;
  alignas(8) uint8_t none[64] = {};
  CHECK_EQ(inkcell_lv_font_init(&font, none, sizeof none, 20 * 64),
           LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_font_init:", "bad_magic"));
  CHECK_EQ(inkcell_lv_font_init(&font, nullptr, 0, 20 * 64), LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_font_init:", ""));
  CHECK(!make_font(font, 20));
  CHECK(has_logged("inkcell_lv_font_init:", "they are in 1/64 px"));
  CHECK_EQ(inkcell_lv_font_init(&font, fonts::lv_sans + 1, 4096, 20 * 64),
           LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_font_init:", "misaligned"));
  CHECK_EQ(inkcell_lv_font_init(&font, fonts::lv_sans, 200, 20 * 64),
           LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_font_init:", "corrupt"));
  CHECK_EQ(inkcell_lv_font_init_strike(&font, fonts::lv_sans,
                                       sizeof fonts::lv_sans, 20 * 64),
           LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_font_init_strike:", "unsupported"));
  inkcell_lv_cache_t cache;
  CHECK_EQ(inkcell_lv_cache_init(&cache, none, sizeof none, 1),
           LV_RESULT_INVALID);
  CHECK(has_logged("inkcell_lv_cache_init:", "buffer_small"));
  CHECK(make_font(font, 20 * 64));
  CHECK(logged.empty());
  inkcell_lv_weight_t weight;
  inkcell_lv_font_set_sub_pixels(&font, INKCELL_LV_SUB_PIXELS_RGB);
  CHECK(logged.empty());
  inkcell_lv_font_set_weight(&font, &weight, 24);
  CHECK(has_logged("no weight", "sub-pixels"));
  CHECK(make_font(font, 20 * 64));
  inkcell_lv_font_set_weight(&font, &weight, 24);
  CHECK(logged.empty());
  inkcell_lv_font_set_sub_pixels(&font, INKCELL_LV_SUB_PIXELS_RGB);
  CHECK(has_logged("no weight", "sub-pixels"));
  lv_log_register_print_cb(nullptr);
}

TEST(weight_keeps_what_was_set) {
  inkcell_lv_fit_t fit;
  inkcell_lv_weight_t weight;
  inkcell_lv_font_t first;
  inkcell_lv_font_t last;
  CHECK(make_font(first, 12 * 64));
  CHECK(make_font(last, 12 * 64));
  inkcell_lv_font_set_weight(&first, &weight, 20);
  CHECK_EQ(inkcell_lv_font_fit_grid(&first, &fit), LV_RESULT_OK);
  CHECK_EQ(inkcell_lv_font_fit_grid(&last, &fit), LV_RESULT_OK);
  inkcell_lv_font_set_weight(&last, &weight, 20);
  const Look look = text(kText);
  CHECK_EQ(count_other(draw(first, false, LV_COLOR_FORMAT_L8, 20, look),
                       draw(last, false, LV_COLOR_FORMAT_L8, 20, look)),
           0);
}

TEST(lent_ram_changes_no_picture) {
  alignas(8) static uint8_t ram[8192];
  alignas(8) static uint8_t rows[2560];
  const Look look = text(kText);
  for (const bool is_direct : {false, true}) {
    inkcell_lv_font_t font;
    CHECK(make_font(font, 30 * 64));
    const Picture expected =
        draw(font, is_direct, LV_COLOR_FORMAT_L8, 16, look);
    inkcell_lv_font_set_workspace(&font, rows, sizeof rows);
    CHECK_EQ(count_other(expected,
                         draw(font, is_direct, LV_COLOR_FORMAT_L8, 16, look)),
             0);
    inkcell_lv_cache_t cache;
    CHECK_EQ(inkcell_lv_cache_init(&cache, ram, sizeof ram, 1), LV_RESULT_OK);
    const Picture cached =
        draw(font, is_direct, LV_COLOR_FORMAT_L8, 16, look, &cache);
    int32_t worst = 0;
    for (size_t i = 0; i < cached.size(); ++i) {
      const int32_t off = int32_t{cached[i]} - expected[i];
      worst = off > worst ? off : (-off > worst ? -off : worst);
    }
    CHECK(worst <= 8);
  }
  inkcell_lv_cache_t cache;
  CHECK_EQ(inkcell_lv_cache_init(&cache, ram, sizeof ram, 17),
           LV_RESULT_INVALID);
  CHECK_EQ(inkcell_lv_cache_init(&cache, ram, 511, 1), LV_RESULT_INVALID);
}

TEST(fallbacks_are_drawn) {
  inkcell_lv_font_t font;
  const Look missing = text("1 " LV_SYMBOL_OK " 2");
  for (const bool is_direct : {false, true}) {
    CHECK(make_font(font, 14 * 64));
    const Picture placeholder =
        draw(font, is_direct, LV_COLOR_FORMAT_L8, 16, missing);
    font.lv.fallback = &lv_font_montserrat_14;
    const Picture found =
        draw(font, is_direct, LV_COLOR_FORMAT_L8, 16, missing);
    CHECK(count_other(placeholder, found) > 20);
    font.lv.fallback = nullptr;
    CHECK(make_font(font, 14 * 64));
    font.lv.fallback = &lv_font_montserrat_14;
    CHECK_EQ(count_other(found, draw(font, !is_direct, LV_COLOR_FORMAT_L8, 16,
                                     missing)),
             0);
  }
}

// A soft hyphen, a joiner, a diacritic; and spaces of other widths.
TEST(what_needs_no_glyph_is_no_box) {
  inkcell_lv_font_t font;
  CHECK(make_font(font, 14 * 64));
  for (const uint32_t letter : {0xadu, 0x200du, 0x301u, 0xfe0fu}) {
    CHECK_EQ(lv_font_get_glyph_width(&font.lv, letter, 0), 0);
  }
  for (const uint32_t letter : {0xa0u, 0x2009u, 0x3000u}) {
    CHECK_EQ(lv_font_get_glyph_width(&font.lv, letter, 0),
             lv_font_get_glyph_width(&font.lv, ' ', 0));
  }
  CHECK_EQ(
      count_other(draw(font, false, LV_COLOR_FORMAT_L8, 16, text("e i")),
                  draw(font, false, LV_COLOR_FORMAT_L8, 16,
                       text("e\xcc\x81\xe2\x80\x89\xc2\xadi\xe2\x80\x8d"))),
      0);
}

TEST(sub_pixels_are_drawn_on_opaque_colour) {
  Look look = text("mill");
  look.colour = 0x000000;
  look.background = 0xffffff;
  for (const lv_color_format_t format :
       {LV_COLOR_FORMAT_RGB888, LV_COLOR_FORMAT_XRGB8888}) {
    const size_t step = lv_color_format_get_size(format);
    const auto count_coloured = [step](const Picture& picture) {
      size_t count = 0;
      for (size_t i = 0; i < picture.size(); i += step) {
        count += picture[i] != picture[i + 2];
      }
      return count;
    };
    inkcell_lv_font_t font;
    CHECK(make_font(font, 16 * 64));
    inkcell_lv_font_set_sub_pixels(&font, INKCELL_LV_SUB_PIXELS_RGB);
    const Picture rgb = draw(font, true, format, 10, look);
    CHECK(count_coloured(rgb) > 50);
    inkcell_lv_font_set_sub_pixels(&font, INKCELL_LV_SUB_PIXELS_BGR);
    const Picture bgr = draw(font, true, format, kHeight, look);
    size_t mirrored = 0;
    for (size_t i = 0; i < rgb.size(); i += step) {
      mirrored += rgb[i] != bgr[i + 2] || rgb[i + 2] != bgr[i];
    }
    CHECK_EQ(mirrored, 0);
    look.opacity = LV_OPA_50;
    CHECK_EQ(count_coloured(draw(font, true, format, 10, look)), 0);
    look.opacity = LV_OPA_COVER;
  }
}

// A rotated label is a layer of its own, with alpha.
TEST(layers_are_drawn_into) {
  Look look = text("Rot");
  look.rotation = 200;
  look.y = 2;
  inkcell_lv_font_t font;
  CHECK(make_font(font, 40 * 64));
  const Picture bitmaps = draw(font, false, LV_COLOR_FORMAT_RGB565, 20, look);
  CHECK(count_other(bitmaps, draw(font, false, LV_COLOR_FORMAT_RGB565, 20,
                                  text(""))) > 500);
  CHECK_EQ(
      count_other(bitmaps, draw(font, true, LV_COLOR_FORMAT_RGB565, 20, look)),
      0);
}

TEST(documented_program_draws) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, 12);
  const Picture blank = screen.draw();
  CHECK(show_kitchen());
  CHECK(count_other(blank, screen.draw()) > 300);
}

TEST(example_of_c_draws) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, 12);
  const Picture blank = screen.draw();
  CHECK(show_example(fonts::lv_sans, sizeof fonts::lv_sans));
  CHECK(count_other(blank, screen.draw()) > 1500);
}
