// Letters that LVGL turns, scales and skews, strokes around them, and caches.
#include <math.h>
#include <stdint.h>

#include <string>
#include <vector>

#include "check.hpp"
#include "fonts/lv_sans.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/style.hpp"
#include "lvgl.h"
#include "screen.hpp"
#include "sfnt_font.hpp"

namespace {

using inkcell::Q16_16;
using inkcell::Q26_6;

constexpr int32_t kWidth = 200;
constexpr int32_t kHeight = 160;
constexpr int32_t kSize = 40;

using Picture = std::vector<uint8_t>;

bool make_font(inkcell_lv_font_t& font, int32_t size_px) {
  return inkcell_lv_font_init(&font, fonts::lv_sans, sizeof fonts::lv_sans,
                              size_px * 64) == LV_RESULT_OK;
}

inkcell::Font plain_font() {
  inkcell::Font font;
  CHECK_OK(inkcell::Font::open({fonts::lv_sans, sizeof fonts::lv_sans}, font));
  return font;
}

// Coverage of a glyph as the core draws it by itself.
Picture coverage_of(const inkcell::Style& style,
                    char letter,
                    double x,
                    double y) {
  Picture picture(static_cast<size_t>(kWidth * kHeight));
  inkcell::Strip strip;
  strip.pixels = {picture.data(), picture.size()};
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = kWidth;
  const inkcell::Font font = plain_font();
  inkcell::Painter(inkcell::port::A8Canvas(strip))
      .glyph(font, style,
             {Q26_6::from_raw(static_cast<int32_t>(lround(x * 64))),
              Q26_6::from_raw(static_cast<int32_t>(lround(y * 64)))},
             font.glyph_or_notdef(static_cast<uint8_t>(letter)));
  return picture;
}

// Levels of ink of `grey` on what `levels` holds.
void blend(Picture& levels, const Picture& coverage, int32_t grey) {
  for (size_t i = 0; i < levels.size(); ++i) {
    levels[i] = static_cast<uint8_t>(
        (levels[i] * (255 - coverage[i]) + grey * coverage[i] + 127) / 255);
  }
}

int32_t worst_of(const Picture& a, const Picture& b) {
  int32_t worst = a.size() == b.size() ? 0 : 256;
  for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const int32_t off = int32_t{a[i]} - b[i];
    worst = off > worst ? off : (-off > worst ? -off : worst);
  }
  return worst;
}

int64_t ink_of(const Picture& levels) {
  int64_t sum = 0;
  for (const uint8_t level : levels) {
    sum += 255 - level;
  }
  return sum;
}

void whiten() {
  lv_obj_t* const screen = lv_screen_active();
  lv_obj_set_style_bg_color(screen, lv_color_white(), 0);
  lv_obj_set_style_bg_opa(screen, LV_OPA_COVER, 0);
}

// The screen with one letter of LVGL's lv_draw_letter().
Picture draw_letter(lv_draw_letter_dsc_t& letter, lv_point_t at, int32_t rows) {
  struct Event {
    lv_draw_letter_dsc_t& letter;
    lv_point_t at;

    static void draw(lv_event_t* event) {
      auto& self = *static_cast<Event*>(lv_event_get_user_data(event));
      lv_draw_letter(lv_event_get_layer(event), &self.letter, &self.at);
    }
  } event = {letter, at};
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, rows);
  whiten();
  lv_obj_add_event_cb(lv_screen_active(), Event::draw, LV_EVENT_DRAW_MAIN_END,
                      &event);
  inkcell_lv_font_set_direct(reinterpret_cast<inkcell_lv_font_t*>(
      const_cast<lv_font_t*>(letter.font)));
  return screen.draw();
}

double radians(int32_t tenths) {
  return tenths * 3.14159265358979 / 1800;
}

// An arc of text in one font.
Picture draw_arc(const lv_font_t& font,
                 bool is_direct,
                 inkcell_lv_font_t& ours) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, 16);
  whiten();
  if (is_direct) {
    inkcell_lv_font_set_direct(&ours);
  }
  lv_obj_t* const arc = lv_arclabel_create(lv_screen_active());
  lv_obj_set_size(arc, kHeight, kHeight);
  lv_arclabel_set_radius(arc, 60);
  lv_arclabel_set_angle_start(arc, 180);
  lv_arclabel_set_angle_size(arc, 180);
  lv_arclabel_set_text(arc, "Turned text");
  lv_obj_set_style_text_font(arc, &font, 0);
  return screen.draw();
}

std::string logged;

void take_log(lv_log_level_t, const char* text) {
  logged += text;
}

// Until LVGL ends.
void begin_log() {
  logged.clear();
  lv_log_register_print_cb(take_log);
}

size_t count_logged(const char* text) {
  size_t count = 0;
  for (size_t at = logged.find(text); at != std::string::npos;
       at = logged.find(text, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

// Skewed, scaled, and turned clockwise, about the middle of its advance.
TEST(letters_have_the_matrix_of_lvgl) {
  struct Case {
    int32_t rotation;
    int32_t scale_x;
    int32_t scale_y;
    int32_t skew_x;
    int32_t skew_y;
  };
  constexpr lv_point_t kAt = {96, 83};
  for (const Case& turn : {Case{305, 256, 256, 0, 0},
                           {-1234, 256, 256, 0, 0},
                           {900, 256, 256, 0, 0},
                           {0, 400, 150, 0, 0},
                           {0, 256, 256, 200, 0},
                           {0, 256, 256, 0, -150},
                           {437, 300, 200, 150, 70}}) {
    inkcell_lv_font_t font;
    CHECK(make_font(font, kSize));
    lv_draw_letter_dsc_t letter;
    lv_draw_letter_dsc_init(&letter);
    letter.font = &font.lv;
    letter.unicode = 'g';
    letter.rotation = turn.rotation;
    letter.scale_x = turn.scale_x;
    letter.scale_y = turn.scale_y;
    letter.skew_x = turn.skew_x;
    letter.skew_y = turn.skew_y;
    const double sx = turn.scale_x / 256.0;
    const double sy = turn.scale_y / 256.0;
    const double kx = tan(radians(turn.skew_x));
    const double ky = tan(radians(turn.skew_y));
    const double c = cos(radians(turn.rotation));
    const double s = sin(radians(turn.rotation));
    // LVGL's y points down: {{c, -s}, {s, c}} {{sx, sx kx}, {sy ky, sy}}.
    const double xx = c * sx - s * sy * ky;
    const double xy = c * sx * kx - s * sy;
    const double yx = s * sx + c * sy * ky;
    const double yy = s * sx * kx + c * sy;
    const auto px = [](double value) {
      return Q16_16::from_raw(static_cast<int32_t>(lround(value * 65536)));
    };
    const inkcell::Style style(inkcell::Matrix{px(xx * kSize), px(-yx * kSize),
                                               px(-xy * kSize), px(yy * kSize)},
                               inkcell::kFilterText);
    const int32_t half = lv_font_get_glyph_width(&font.lv, 'g', 0) / 2;
    Picture expected(static_cast<size_t>(kWidth * kHeight), 255);
    blend(expected,
          coverage_of(style, 'g', kAt.x - half * xx, kAt.y - half * yx), 0);
    const Picture whole = draw_letter(letter, kAt, kHeight);
    CHECK(ink_of(whole) > 50000);
    CHECK(worst_of(whole, expected) <= 10);  // places are in 1/64 px
    CHECK_EQ(worst_of(whole, draw_letter(letter, kAt, 7)), 0);
  }
}

// LVGL turns pictures of letters, and leaves their bearing where it was.
TEST(arcs_of_text_are_turned) {
  inkcell_lv_font_t font;
  CHECK(make_font(font, 20));
  const Picture bitmaps = draw_arc(font.lv, false, font);
  const Picture direct = draw_arc(font.lv, true, font);
  CHECK(ink_of(bitmaps) > 100000);
  CHECK(llabs(ink_of(direct) - ink_of(bitmaps)) < ink_of(bitmaps) / 20);
}

TEST(fallbacks_of_bitmaps_are_turned_as_lvgl_does) {
  inkcell_lv_font_t font;
  CHECK(make_font(font, 20));
  lv_font_t montserrat = lv_font_montserrat_14;
  const Picture alone = draw_arc(montserrat, false, font);
  montserrat.fallback = &font.lv;
  CHECK_EQ(worst_of(alone, draw_arc(montserrat, true, font)), 0);
}

TEST(letters_of_turned_labels_are_not_cut_by_strips) {
  struct Event {
    lv_draw_label_dsc_t label;

    static void draw(lv_event_t* event) {
      auto& self = *static_cast<Event*>(lv_event_get_user_data(event));
      const lv_area_t area = {30, 60, 180, 100};
      lv_draw_label(lv_event_get_layer(event), &self.label, &area);
    }
  } event;
  lv_draw_label_dsc_init(&event.label);
  inkcell_lv_font_t font;
  CHECK(make_font(font, 30));
  event.label.font = &font.lv;
  event.label.text = "gTf";
  event.label.rotation = 700;
  Picture pictures[2];
  for (const int32_t rows : {kHeight, 5}) {
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, rows);
    whiten();
    inkcell_lv_font_set_direct(&font);
    lv_obj_add_event_cb(lv_screen_active(), Event::draw, LV_EVENT_DRAW_MAIN_END,
                        &event);
    pictures[rows == 5] = screen.draw();
  }
  CHECK(ink_of(pictures[0]) > 50000);
  CHECK_EQ(worst_of(pictures[0], pictures[1]), 0);
}

TEST(strokes_of_styles_are_drawn_below_letters) {
  constexpr int32_t kStroke = 2;
  Picture expected(static_cast<size_t>(kWidth * kHeight), 255);
  inkcell_lv_font_t font;
  CHECK(make_font(font, kSize));
  const double baseline = 20 + font.lv.line_height - font.lv.base_line;
  const inkcell::Filter outer = inkcell::with_weight(
      inkcell::kFilterText, inkcell::Q6_10::from_int(kStroke));
  const Q26_6 size = Q26_6::from_int(kSize);
  blend(expected, coverage_of(inkcell::Style(size, outer), 'R', 30, baseline),
        0x80);
  blend(expected,
        coverage_of(inkcell::Style(size, inkcell::kFilterText), 'R', 30,
                    baseline),
        0);
  for (const bool has_stroke : {false, true}) {
    CHECK(make_font(font, kSize));
    for (const int32_t rows : {kHeight, 3}) {
      Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, rows);
      begin_log();
      whiten();
      inkcell_lv_font_set_direct(&font);
      if (has_stroke) {
        inkcell_lv_font_set_outline_stroke(&font);
      }
      lv_obj_t* const label = lv_label_create(lv_screen_active());
      lv_obj_set_pos(label, 25, 15);
      lv_obj_set_style_pad_all(label, 5, 0);
      lv_label_set_text(label, "R");
      lv_obj_set_style_text_font(label, &font.lv, 0);
      lv_obj_set_style_text_color(label, lv_color_black(), 0);
      lv_obj_set_style_text_outline_stroke_width(label, kStroke, 0);
      lv_obj_set_style_text_outline_stroke_opa(label, LV_OPA_COVER, 0);
      lv_obj_set_style_text_outline_stroke_color(label, lv_color_hex(0x808080),
                                                 0);
      const int32_t worst = worst_of(screen.draw(), expected);
      CHECK_EQ(worst <= 2, has_stroke);
      screen.draw();
      CHECK_EQ(count_logged("set_outline_stroke"),
               !has_stroke && rows == kHeight ? 1u : 0u);
    }
  }
}

TEST(truetype_files_refuse_a_weight) {
  alignas(4) static uint8_t bytes[2048];
  inkcell_lv_truetype_t file = {};
  const size_t size = sfnt_font::build(bytes, {});
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, kHeight);
  begin_log();
  CHECK_EQ(inkcell_lv_truetype_open(&file, bytes, 3), LV_RESULT_INVALID);
  CHECK_EQ(count_logged("inkcell_lv_truetype_open: "), 1u);
  CHECK_EQ(inkcell_lv_truetype_open(&file, bytes, size), LV_RESULT_OK);
  inkcell_lv_font_t font;
  CHECK_EQ(inkcell_lv_font_init_truetype(&font, &file, 3), LV_RESULT_INVALID);
  CHECK_EQ(count_logged("inkcell_lv_font_init_truetype: bad_argument"), 1u);
  CHECK_EQ(inkcell_lv_font_init_truetype(&font, &file, 20 * 64), LV_RESULT_OK);
  inkcell_lv_weight_t weight;
  CHECK_EQ(inkcell_lv_font_set_weight(&font, &weight, 16), LV_RESULT_INVALID);
  CHECK_EQ(count_logged("inkcell_lv_font_set_weight: unsupported"), 1u);
}

// LVGL turns pictures of whole labels, whose layers have alpha.
TEST(cached_labels_are_transformed_as_others_are) {
  alignas(8) static uint8_t ram[16384];
  Picture pictures[2];
  for (const bool is_cached : {false, true}) {
    inkcell_lv_font_t font;
    inkcell_lv_cache_t cache;
    CHECK(make_font(font, 39));
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, 20);
    if (is_cached) {
      CHECK_EQ(inkcell_lv_cache_init(&cache, ram, sizeof ram, 1), LV_RESULT_OK);
      inkcell_lv_font_set_cache(&font, &cache);
    }
    Look look;
    look.font = &font.lv;
    look.text = "Rotat";
    look.colour = 0xffffff;
    look.background = 0;
    look.x = 40;
    look.y = 20;
    look.rotation = 300;
    screen.add(look);
    pictures[is_cached] = screen.draw();
  }
  CHECK(worst_of(pictures[0], pictures[1]) <= 9);
}

// A cache of the size that inkcell_lv_cache_init() tells, and a smaller one.
TEST(caches_tell_what_they_do) {
  alignas(8) static uint8_t ram[600 + 24 * (16 + 24 * 9 / 2)];
  for (const bool is_small : {false, true}) {
    inkcell_lv_font_t font;
    inkcell_lv_cache_t cache;
    CHECK(make_font(font, 24));
    const size_t size = is_small ? 1024 : sizeof ram;
    CHECK_EQ(inkcell_lv_cache_init(&cache, ram, size, 1), LV_RESULT_OK);
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_L8, kHeight);
    begin_log();
    inkcell_lv_font_set_cache(&font, &cache);
    Look look;
    look.font = &font.lv;
    look.text = "abcdefgh\nijklmnop\nqrstuvwx";
    screen.add(look);
    for (int i = 0; i != 30; ++i) {
      screen.draw();
    }
    inkcell_lv_cache_stats_t stats;
    inkcell_lv_cache_stats(&cache, &stats);
    CHECK_EQ(stats.hits + stats.misses, 24u * 30u);
    CHECK_EQ(stats.capacity, size);
    CHECK_EQ(stats.evictions > stats.hits, is_small);
    CHECK_EQ(stats.misses == 24, !is_small);
    CHECK_EQ(count_logged("the cache is too small"), is_small ? 1u : 0u);
  }
}
