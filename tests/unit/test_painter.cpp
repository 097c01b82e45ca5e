// The painter: boxes of text against the pixels that drawing touches, and
// measures in pixels.
#include "inkcell/painter.hpp"

#include "check.hpp"
#include "ink.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/shaped_run.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"
#include "outline_font.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;

const Font& font = outline_record::sample_font();

constexpr char kText[] = "ADE F";
constexpr int32_t kTurned = 4;
// Text may leave the screen on all sides.
constexpr Rect kAll = {-200, -200, 300, 300};

// Whether `box` holds all that was touched, and at most `most` px more on a
// side.
bool holds(const Rect& box, const Rect& touched, int32_t most) {
  const int32_t more[] = {touched.x0 - box.x0, touched.y0 - box.y0,
                          box.x1 - touched.x1, box.y1 - touched.y1};
  bool is_right = !is_empty(touched);
  for (const int32_t side : more) {
    is_right &= side >= 0 && side <= most;
  }
  return is_right;
}

Point at(int32_t x_q6, int32_t y_q6) {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

void check_boxes(const char* name, const Style& style, int32_t most = 2) {
  bool is_right = true;
  const Point origins[] = {at(0, 0), at(13, 40), at(-411, 3001), at(640, -27)};
  for (const Point origin : origins) {
    Ink touched;
    const Sink sink = touched.sink(kAll);
    const Painter painter(sink);
    painter.text(font, style, origin, kText);
    is_right &=
        holds(painter.box(font, style, origin, kText), touched.box, most);
  }
  if (!is_right) {
    check::fail(__FILE__, __LINE__, name);
  }
}

Style style_of(int32_t px) {
  return Style(Q26_6::from_int(px), kFilterText);
}

Direction turned() {
  Direction direction;
  direction.cosine.raw = 858993459;
  direction.sine.raw = 644245094;
  return direction;
}

}  // namespace

TEST(boxes_of_text_hold_what_is_drawn) {
  for (const int32_t px : each_of({5, 12, 15, 40})) {
    check_boxes("plain", style_of(px));
  }
  Style style(17_px, kFilterArea);
  check_boxes("exact area", style);
  style = Style(20_px, kFilterText, turned());
  // The corners of the turned boxes of glyphs, which are round.
  check_boxes("turned", style, kTurned);
  style = Style({Q16_16::from_int(20), Q16_16::from_int(0), Q16_16::from_int(5),
                 Q16_16::from_int(24)},
                kFilterText);
  check_boxes("stretched and slanted", style);
}

TEST(boxes_of_text_hold_what_effects_draw) {
  const Stroke stroke(kFilterText, Q6_10::from_raw(1500));
  const Lcd lcd;
  const Bilevel bilevel;
  const Supersample samples;
  const MotionBlur blur(at(150, -75));
  Style style = style_of(16);
  style.set_effect(stroke);
  check_boxes("stroke", style);
  style.set_effect(lcd);
  check_boxes("sub-pixels", style);
  style.set_effect(bilevel);
  check_boxes("1 bit", style);
  style.set_effect(samples);
  check_boxes("supersampling", style);
  style.set_effect(blur);
  check_boxes("motion blur", style);
}

TEST(boxes_of_text_hold_what_fitted_styles_draw) {
  for (int32_t i = 0; i != 2; ++i) {
    const bool is_across = i == 1;
    Style style = style_of(13);
    FitOptions options;
    options.across = is_across;
    Fit fit;
    CHECK_OK(Fit::make(font, style, options, fit));
    style.set_fit(fit);
    check_boxes(is_across ? "fitted across" : "fitted", style);
  }
}

TEST(boxes_of_soft_edges_hold_them) {
  const Filter glow = glow_filter(Q6_10::from_raw(4096));
  const Filter shadow = shadow_filter(Q6_10::from_raw(2048));
  const Filter* const filters[] = {&glow, &shadow};
  for (const Filter* filter : filters) {
    Style style(16_px, *filter);
    Ink touched;
    const Sink sink = touched.sink(kAll);
    const Painter painter(sink);
    painter.text(font, style, {}, kText);
    const Rect box = painter.box(font, style, {}, kText);
    CHECK(is_same(intersect(box, touched.box), touched.box));
  }
}

TEST(what_shows_nothing_has_no_box) {
  const Painter painter;
  Style style = style_of(16);
  CHECK(is_empty(painter.box(font, style, {}, "")));
  CHECK(is_empty(painter.box(font, style, {}, " \n")));
  CHECK(is_empty(painter.box(Font(), style, {}, kText)));
  CHECK(is_empty(painter.box(font, style, {}, ShapedRun())));
  CHECK(is_empty(painter.box(font, style, {}, Span<const PositionedGlyph>())));
  CHECK(is_empty(painter.box(font, style, at(INT32_MAX, INT32_MIN), kText)));
  const Splat splat({});
  style.set_effect(splat);
  CHECK_EQ(font.check(style), Status::unsupported);
  CHECK(is_empty(painter.box(font, style, {}, kText)));
  CHECK_OK(Font().check(style));
}

TEST(boxes_of_glyphs_and_runs_are_those_of_their_text) {
  const Style style = style_of(16);
  const Point origin = at(77, -300);
  const Painter painter;
  const Rect box = painter.box(font, style, origin, "AD");
  PositionedGlyph room[2];
  Span<const PositionedGlyph> glyphs;
  CHECK_OK(Painter().lay_out(font, Style(), "AD", room, glyphs));
  CHECK(is_same(painter.box(font, style, origin, glyphs), box));
  room[1].face = 1;
  const Face face = {&font, &style};
  CHECK(is_same(painter.box(face, {&face, 1}, origin, glyphs), box));
  CHECK(is_same(painter.box(face, {}, origin, glyphs),
                painter.box(font, style, origin, "A")));
  CHECK(is_same(painter.glyph_box(font, style, origin, room[0].glyph),
                painter.box(font, style, origin, "A")));
  const ShapedGlyph shaped[] = {
      {room[0].glyph, 0, 0},
      {room[1].glyph, static_cast<int16_t>(room[1].x), 0}};
  CHECK(is_same(painter.box(font, style, origin, ShapedRun{{shaped, 2}, 0}),
                box));
}

TEST(measures_in_pixels_are_those_in_units) {
  const Style style = style_of(20);
  const TextMeasure units = measure(font, "AF");
  const PixelMeasure px = Painter().measure(font, style, "AF");
  CHECK(units.advance > 0 && units.y_max > 0 && units.x_min > 0);
  CHECK_EQ(px.advance.raw, to_px(font, style, units.advance).raw);
  CHECK_EQ(px.left.raw, to_px(font, style, units.x_min).raw);
  CHECK_EQ(px.right.raw, to_px(font, style, units.x_max).raw);
  CHECK_EQ(px.top.raw, to_px(font, style, -units.y_max).raw);
  CHECK_EQ(px.bottom.raw, to_px(font, style, -units.y_min).raw);
  const PixelMeasure none = Painter().measure(font, style, "");
  CHECK(none.advance.raw == 0 && none.left.raw == none.right.raw);
}

// The rows of ink above the baseline.
int32_t height_of(const Font& own, const Style& style, Text text) {
  Ink touched;
  Painter(touched.sink(kAll)).text(own, style, at(0, 200 * 64), text);
  return 200 - touched.box.y0;
}

TEST(sizes_by_the_height_of_capitals_and_digits) {
  using namespace outline_record;
  // '0' is lower than '1', as figures of old style are.
  const OutlineSource glyphs[] = {
      {600, {kBar, 4}}, {600, {kBar, 4}}, {600, {kEll, 6}}};
  const auto open = [&](uint32_t first, int32_t cap_height) {
    alignas(4) static uint8_t font_bytes[kSampleFontBytes];
    const size_t size = build_outline_font({glyphs, 3}, 0, first, font_bytes);
    font_builder::put_u16(font_bytes + format::header::kCapHeight,
                          static_cast<uint32_t>(cap_height));
    CHECK(font_builder::repair_checksums({font_bytes, size}));
    Font opened;
    CHECK_OK(Font::open({font_bytes, size}, opened));
    return opened;
  };
  const Font digits = open('0', 512);
  for (int32_t px = 5; px <= 60; px += 5) {
    const Q26_6 height = Q26_6::from_int(px);
    CHECK_EQ(height_of(digits, Style::for_digit_height(digits, height), "01"),
             px);
  }
  CHECK_EQ(Style::for_digit_height(digits, 37_px).size().raw,
           37 * 64 * 1024 / 740);
  // Without capitals: as the font says.
  CHECK_EQ(Style::for_cap_height(digits, 30_px).size().raw, 60 * 64);
  const Font capitals = open('H', 512);
  for (int32_t px = 5; px <= 60; px += 5) {
    const Q26_6 height = Q26_6::from_int(px);
    const Style style = Style::for_cap_height(capitals, height, kFilterText);
    CHECK_EQ(height_of(capitals, style, "H"), px);
    CHECK(&style.filter() == &kFilterText);
  }
  CHECK_EQ(Style::for_digit_height(capitals, 30_px).size().raw, 60 * 64);
  // With neither, of the em; always in range.
  for (const int32_t cap_height : each_of({0, -1, INT16_MIN})) {
    const Font none = open('a', cap_height);
    CHECK_EQ(Style::for_cap_height(none, 30_px).size().raw, 30 * 64);
    CHECK_EQ(Style::for_digit_height(none, 30_px).size().raw, 30 * 64);
  }
  const auto clamped = [&](int32_t raw) {
    return Style::for_cap_height(capitals, Q26_6::from_raw(raw)).size();
  };
  CHECK(clamped(INT32_MAX) == kMaxSize && clamped(kMaxSize.raw) == kMaxSize);
  CHECK(clamped(INT32_MIN) == kMinSize && clamped(0) == kMinSize);
  CHECK_EQ(Style::for_cap_height(Font(), 20_px).size().raw, 20 * 64);
}
