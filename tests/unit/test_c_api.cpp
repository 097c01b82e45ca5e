// The interface for C: its examples against the same pictures through C++, and
// what it answers where it fails.
#include "check.hpp"
#include "examples.h"
#include "fonts.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/number_text.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/value_label.hpp"
#include "pixels.hpp"

using namespace inkcell;

namespace {

constexpr char kText[] = "Inkcel 42";
constexpr char kLongText[] =
    "Inkcel 42 Inkcel 42 Inkcell neck nickel 42 Inkcell 24 Inkcell 4 Ink";

Span<const uint8_t> rom() {
  return golden::font_bytes(golden::FontId::dejavu_sans_outline);
}

Font open() {
  Font font;
  CHECK_OK(Font::open(rom(), font));
  return font;
}

inkcell_font_t open_by_c() {
  inkcell_font_t font;
  CHECK_EQ(inkcell_font_open(rom().data, rom().size, &font), INKCELL_OK);
  return font;
}

inkcell_style_t style_by_c(int32_t px, const inkcell_filter_t& filter) {
  inkcell_style_t style;
  CHECK_EQ(inkcell_style_make(px << 6, &filter, &style), INKCELL_OK);
  return style;
}

// How many bytes differ, and that the pictures are not empty.
template <size_t kSize>
size_t differences(const uint8_t (&a)[kSize], const uint8_t (&b)[kSize]) {
  size_t count = 0;
  size_t drawn = 0;
  for (size_t i = 0; i < kSize; ++i) {
    count += a[i] != b[i] ? 1 : 0;
    drawn += a[i] != 0 ? 1 : 0;
  }
  CHECK(drawn > 20);
  return count;
}

bool is_same(const inkcell_rect_t& by_c, const Rect& by_cpp) {
  return ::is_same(Rect{by_c.x0, by_c.y0, by_c.x1, by_c.y1}, by_cpp);
}

}  // namespace

TEST(label_is_that_of_cpp) {
  static uint8_t by_c[LABEL_WIDTH * LABEL_HEIGHT / 8];
  static uint8_t by_cpp[sizeof by_c];
  CHECK_EQ(draw_label(rom().data, rom().size, kText, by_c), INKCELL_OK);

  const Font font = open();
  Style style(12_px, kFilterText);
  const port::MonoPagesCanvas canvas(
      {by_cpp, 0, 0, LABEL_WIDTH, LABEL_HEIGHT, LABEL_WIDTH});
  CHECK_OK(canvas.status());
  const int32_t width = Painter(canvas).measure(font, style, kText).advance.raw;
  Painter(canvas).text(font, style,
                       {Q26_6::from_raw((LABEL_WIDTH * 64 - width) / 2), 12_px},
                       kText);
  CHECK_EQ(differences(by_c, by_cpp), 0);
}

TEST(a_style_that_is_refused_draws_nothing) {
  const inkcell_font_t font = open_by_c();
  bool has_drawn = false;
  inkcell_sink_t sink = {};
  sink.window = {0, 0, 30, 30};
  sink.context = &has_drawn;
  sink.coverage = [](void* drawn, int32_t, int32_t, const uint8_t*, int32_t) {
    *static_cast<bool*>(drawn) = true;
  };
  sink.solid = [](void* drawn, int32_t, int32_t, int32_t) {
    *static_cast<bool*>(drawn) = true;
  };
  const auto draw_24 = [&](const inkcell_style_t& style) {
    has_drawn = false;
    inkcell_painter_t painter = {};
    painter.sink = &sink;
    inkcell_draw_text(&painter, &font, "A", 1, &style, 0, 24 << 6);
    return has_drawn;
  };
  inkcell_style_t style = style_by_c(24, inkcell_filter_area);
  CHECK(draw_24(style));
  inkcell_style_for_cap_height(&font, 24 << 6, &inkcell_filter_area, &style);
  CHECK_EQ(inkcell_style_size(&style),
           Style::for_cap_height(open(), 24_px).size().raw);
  CHECK(draw_24(style));
  inkcell_style_for_digit_height(&font, 24 << 6, &inkcell_filter_text, &style);
  CHECK_EQ(inkcell_style_size(&style),
           Style::for_digit_height(open(), 24_px).size().raw);
  CHECK_EQ(inkcell_style_make(3 << 6, &inkcell_filter_area, &style),
           INKCELL_BAD_ARGUMENT);
  CHECK(!draw_24(style));
  CHECK(!draw_24({}));
}

TEST(clock_is_that_of_cpp) {
  static uint8_t by_c[CLOCK_WIDTH * CLOCK_HEIGHT * 2];
  static uint8_t by_cpp[sizeof by_c];
  const auto send = [](void* display, const inkcell_strip_t* strip) {
    __builtin_memcpy(static_cast<uint8_t*>(display) + strip->y0 * strip->stride,
                     strip->pixels,
                     static_cast<size_t>(strip->height * strip->stride));
  };
  inkcell_glyph_cache_stats_t stats;
  CHECK_EQ(draw_clock(rom().data, rom().size, "42 24", send, by_c, &stats),
           INKCELL_OK);
  CHECK(stats.hits > stats.misses);
  CHECK_EQ(stats.capacity, 2048);

  // All at once, but at the places within a pixel that a cache has.
  const Font font = open();
  Style style(30_px, kFilterArea);
  const port::Rgb565Canvas canvas(
      {by_cpp, 0, 0, CLOCK_WIDTH, CLOCK_HEIGHT, CLOCK_WIDTH * 2},
      port::rgb565(255, 200, 0));
  CHECK_OK(canvas.status());
  alignas(8) static uint8_t ram[2048];
  GlyphCache cache;
  CHECK_OK(GlyphCache::make(ram, {}, cache));
  Painter(canvas, {}, &cache).text(font, style, {4, 32}, "42 24");
  CHECK_EQ(differences(by_c, by_cpp), 0);
  CHECK_EQ(stats.misses, cache.stats().misses);
  CHECK_EQ(stats.glyphs, cache.stats().glyphs);
}

TEST(paragraph_is_that_of_cpp) {
  static uint8_t by_c[PARAGRAPH_WIDTH * PARAGRAPH_HEIGHT];
  static uint8_t by_cpp[sizeof by_c];
  CHECK_EQ(draw_paragraph(rom().data, rom().size, kLongText, by_c), INKCELL_OK);

  const Font font = open();
  Style style(14_px, kFilterText);
  const port::Grey8Canvas canvas(
      {by_cpp, 0, 0, PARAGRAPH_WIDTH, PARAGRAPH_HEIGHT, PARAGRAPH_WIDTH});
  CHECK_OK(canvas.status());
  TextBox box(font, style, {4, 4, PARAGRAPH_WIDTH - 4, PARAGRAPH_HEIGHT - 4},
              Align::centre);
  box.options.ellipsis = Ellipsis::end;
  box.vertical = VerticalAlign::middle;
  box.draw(kLongText, canvas);
  CHECK_EQ(differences(by_c, by_cpp), 0);
}

TEST(own_sink_gets_what_cpp_gives) {
  static uint8_t by_c[PLOT_WIDTH * PLOT_HEIGHT];
  static uint8_t by_cpp[sizeof by_c];
  CHECK_EQ(draw_plot(rom().data, rom().size, kText, by_c), INKCELL_OK);

  const Font font = open();
  Style style(16_px, kFilterText,
              {Fixed<int32_t, 30>::from_raw(1053110176),
               Fixed<int32_t, 30>::from_raw(209476638)});
  Sink sink;
  sink.window = {0, 0, PLOT_WIDTH, PLOT_HEIGHT};
  sink.context = by_cpp;
  sink.coverage = [](void* context, int32_t x, int32_t y,
                     const uint8_t* coverage, int32_t count) {
    uint8_t* pixel = static_cast<uint8_t*>(context) + y * PLOT_WIDTH + x;
    for (int32_t i = 0; i < count; ++i) {
      pixel[i] = coverage[i] > pixel[i] ? coverage[i] : pixel[i];
    }
  };
  sink.solid = [](void* context, int32_t x, int32_t y, int32_t count) {
    __builtin_memset(static_cast<uint8_t*>(context) + y * PLOT_WIDTH + x, 255,
                     static_cast<size_t>(count));
  };
  Painter(sink).text(font, style, {2_px, Q26_6::from_raw(20 * 64 + 32)}, kText);
  CHECK_EQ(differences(by_c, by_cpp), 0);
}

TEST(values_are_those_of_cpp) {
  const Font font = open();
  const Style style(12_px, kFilterText);
  ValueLabel by_cpp(font, style, {30, 12}, Anchor::right);
  const inkcell_font_t same_font = open_by_c();
  inkcell_style_t same_style = style_by_c(12, inkcell_filter_text);
  inkcell_value_label_t by_c;
  inkcell_value_label_init(&by_c, &same_font, &same_style, 30 << 6, 12 << 6,
                           INKCELL_ANCHOR_RIGHT);
  static uint8_t pages[2][LABEL_WIDTH * LABEL_HEIGHT / 8];
  for (const int32_t tenths : each_of({-42, 424, 424})) {
    for (auto& page : pages) {
      __builtin_memset(page, 0, sizeof page);
    }
    const port::MonoPagesCanvas canvas(
        {pages[0], 0, 0, LABEL_WIDTH, LABEL_HEIGHT, LABEL_WIDTH});
    const Rect changed = by_cpp.set(NumberText(tenths, 1), canvas);
    by_cpp.draw(canvas);

    inkcell_mono_pages_target_t target = {};
    target.strip = {pages[1],    sizeof pages[1],  0,
                    0,           LABEL_WIDTH,      LABEL_HEIGHT,
                    LABEL_WIDTH, INKCELL_LOW_FIRST};
    target.threshold = 128;
    target.level = 1;
    inkcell_sink_t sink;
    CHECK_EQ(inkcell_mono_pages_sink(&target, &sink), INKCELL_OK);
    char number[INKCELL_NUMBER_BYTES];
    inkcell_rect_t rect;
    inkcell_painter_t painter = {};
    painter.sink = &sink;
    inkcell_value_label_set(&by_c, &painter,
                            inkcell_number_text(tenths, 1, 1, '.', number),
                            INKCELL_TERMINATED, &rect);
    inkcell_value_label_draw(&by_c, &painter);
    CHECK_EQ(differences(pages[0], pages[1]), 0);
    CHECK(is_same(rect, changed));
  }
  // The longest number fits its buffer.
  char longest[INKCELL_NUMBER_BYTES];
  inkcell_number_text(INT32_MIN, 9, 10, ',', longest);
  CHECK_EQ(Text(longest).size, 21);
  CHECK_EQ(longest[11], ',');
  CHECK(inkcell_number_add_unit(longest, " 1234567890") == longest);
  CHECK_EQ(Text(longest).size, INKCELL_NUMBER_BYTES - 1);
  inkcell_number_add_unit(longest, "more");
  CHECK_EQ(Text(longest).size, INKCELL_NUMBER_BYTES - 1);
  inkcell_number_text(215, 1, 1, '.', longest);
  const Text text = inkcell_number_add_unit(longest,
                                            " \xC2\xB0"
                                            "C");
  const NumberText same = NumberText(215, 1).with_unit(
      " \xC2\xB0"
      "C");
  CHECK_EQ(text.size, same.text().size);
  CHECK_EQ(__builtin_memcmp(text.data, same.text().data, text.size), 0);
  CHECK_EQ(
      Text(inkcell_number_text_of_q16(-(5 << 15), 0, 1, '.', longest)).data[1],
      '3');
}

TEST(text_on_a_circle_is_that_of_cpp) {
  constexpr int32_t kSide = 64;
  static uint8_t by_c[kSide * kSide];
  static uint8_t by_cpp[sizeof by_c];
  const inkcell_font_t font = open_by_c();
  inkcell_style_t style = style_by_c(12, inkcell_filter_area);
  inkcell_grey8_target_t target = {};
  target.strip = {by_c, sizeof by_c, 0, 0, kSide, kSide, kSide, 0};
  target.level = 255;
  inkcell_sink_t sink;
  CHECK_EQ(inkcell_grey8_sink(&target, &sink), INKCELL_OK);
  const inkcell_text_circle_t circle = {32 << 6,
                                        32 << 6,
                                        20 << 6,
                                        3 << 14,
                                        INKCELL_CIRCLE_INSIDE,
                                        INKCELL_ANCHOR_RIGHT};
  inkcell_painter_t painter = {};
  painter.sink = &sink;
  inkcell_draw_on_circle(&painter, &font, kText, INKCELL_TERMINATED, &style,
                         &circle);
  inkcell_rect_t pixels;
  inkcell_circle_box(&font, kText, INKCELL_TERMINATED, &style, &circle,
                     &pixels);
  const Style same(12_px);
  const motion::TextCircle same_circle = {{32, 32},
                                          20_px,
                                          motion::from_degrees(270),
                                          motion::CircleSide::inside,
                                          Anchor::right};
  const port::Grey8Canvas canvas({by_cpp, 0, 0, kSide, kSide, kSide});
  motion::draw_on_circle(canvas, open(), same, same_circle, kText);
  CHECK_EQ(differences(by_c, by_cpp), 0);
  const Rect box = motion::draw_on_circle({}, open(), same, same_circle, kText);
  CHECK(is_same(pixels, box));
  style = {};
  inkcell_draw_on_circle(&painter, &font, kText, INKCELL_TERMINATED, &style,
                         &circle);
  CHECK_EQ(differences(by_c, by_cpp), 0);
}

TEST(a_paragraph_tells_its_pixels) {
  const inkcell_font_t font = open_by_c();
  inkcell_style_t style = style_by_c(14, inkcell_filter_text);
  const inkcell_rect_t rect = {4, 4, PARAGRAPH_WIDTH - 4, PARAGRAPH_HEIGHT - 4};
  inkcell_text_box_t box;
  inkcell_text_box_init(&box, &font, &style, &rect);
  inkcell_rect_t pixels;
  inkcell_text_box_box(&box, nullptr, kLongText, INKCELL_TERMINATED, nullptr, 0,
                       &pixels);
  const Font same_font = open();
  const Style same_style(14_px, kFilterText);
  const Rect same = TextBox(same_font, same_style,
                            {4, 4, PARAGRAPH_WIDTH - 4, PARAGRAPH_HEIGHT - 4})
                        .box(kLongText, {});
  CHECK(same.x1 > same.x0 && same.y1 > same.y0);
  CHECK(is_same(pixels, same));
}

TEST(a_morph_needs_its_pair) {
  const inkcell_font_t font = open_by_c();
  inkcell_outline_morph_t morph;
  CHECK_EQ(inkcell_outline_morph_open(&font, 1, 2, &morph), INKCELL_NO_GLYPH);
  CHECK_EQ(inkcell_outline_morph_open_master(&font, 1, &morph),
           INKCELL_NO_GLYPH);
  inkcell_style_t style = style_by_c(14, inkcell_filter_text);
  inkcell_rect_t box;
  inkcell_outline_morph_box(&morph, &style, 0, 0, 1 << 16, &box);
  CHECK(box.x1 <= box.x0);
  // A glyph and itself is a pair, which is drawn plain at its ends.
  CHECK_EQ(inkcell_outline_morph_open(&font, 2, 2, &morph), INKCELL_OK);
  inkcell_rect_t plain;
  inkcell_outline_morph_box(&morph, &style, 0, 0, 1 << 16, &box);
  inkcell_glyph_box(nullptr, &font, 2, &style, 0, 0, &plain);
  CHECK(plain.x1 > plain.x0);
  CHECK_EQ(box.x0, plain.x0);
  CHECK_EQ(box.y1, plain.y1);
  const int32_t advance = inkcell_outline_morph_advance(&morph, &style, 0);
  CHECK(advance > 0);
  CHECK_EQ(inkcell_outline_morph_advance(&morph, &style, 1 << 16), advance);
  CHECK_EQ(inkcell_ease_in_out(0), 0);
  const int32_t half = inkcell_ease_in_out(1 << 15);
  CHECK(half > 32700 && half < 32800);
  CHECK_EQ(inkcell_ease_in_out(2 << 16), 1 << 16);
}

TEST(broken_fonts_are_refused) {
  alignas(4) static const uint8_t kBad[64] = {1, 2, 3};
  static uint8_t pages[LABEL_WIDTH * LABEL_HEIGHT / 8];
  CHECK_EQ(draw_label(kBad, sizeof kBad, kText, pages), INKCELL_BAD_MAGIC);
  CHECK_EQ(draw_label(rom().data, rom().size - 4, kText, pages),
           INKCELL_CORRUPT);
  CHECK_EQ(draw_label(rom().data + 1, rom().size - 1, kText, pages),
           INKCELL_MISALIGNED);
  CHECK_EQ(pages[0], 0);
}
