// Shaped runs: what is drawn, measured and laid out, and any numbers in them.
#include "inkcell/painter.hpp"
#include "inkcell/shaped_run.hpp"

#include <fonts/labels.hpp>

#include "check.hpp"
#include "draw_greeting.h"
#include "ink.hpp"
#include "inkcell/fit.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kWidth = 320;
constexpr int32_t kHeight = 48;

using Page = Picture<kWidth, kHeight, Overlap::greatest>;

const ShapedRun* const kRuns[] = {
    &fonts::labels_strings::title, &fonts::labels_strings::greeting,
    &fonts::labels_strings::mixed, &fonts::labels_strings::price,
    &fonts::labels_strings::plain, &fonts::labels_strings::marks};

Font open() {
  Font font;
  CHECK_OK(Font::open(fonts::labels, font));
  return font;
}

Style style_of(int32_t px) {
  Style style(Q26_6::from_int(px), kFilterText);
  return style;
}

// Fitted to the grid, advances too.
struct FittedStyle {
  FittedStyle(const Font& font, int32_t px) : style(style_of(px)) {
    FitOptions options;
    options.across = true;
    CHECK_OK(Fit::make(font, style, options, fit));
    style.set_fit(fit);
  }

  Style style;
  Fit fit;
};

constexpr Point kOrigin = {Q26_6::from_int(4), Q26_6::from_int(28)};

}  // namespace

// What docs/STRINGS.md shows, where the font is called ui.
namespace fonts {
namespace ui_strings = labels_strings;
}  // namespace fonts

namespace {

// Centred in `width` px.
void draw_title(const Font& font,
                const Style& style,
                int32_t width,
                int32_t baseline,
                const Sink& sink) {
  const ShapedRun& title = fonts::ui_strings::title;
  const Painter painter(sink);
  const Q26_6 wide = painter.measure(font, style, title).advance;
  const int32_t left = (64 * width - wide.raw) / 2;
  painter.text(font, style, {Q26_6::from_raw(left), Q26_6::from_int(baseline)},
               title);
}

}  // namespace

// With 2048 units to the em and 32 px, a unit is 1/64 px: glyphs that are drawn
// one by one at such places lie where the run has them.
TEST(run_is_its_glyphs_one_by_one) {
  const Font font = open();
  CHECK_EQ(font.units_per_em(), 2048);
  const Style style = style_of(32);
  for (const ShapedRun* run : kRuns) {
    static Page by_run;
    static Page one_by_one;
    by_run.clear();
    one_by_one.clear();
    Painter(by_run.sink()).text(font, style, kOrigin, *run);
    int32_t x = 0;
    for (const ShapedGlyph& glyph : run->glyphs) {
      x += glyph.x;
      Painter(one_by_one.sink())
          .glyph(font, style,
                 {Q26_6::from_raw(kOrigin.x.raw + x),
                  Q26_6::from_raw(kOrigin.y.raw - glyph.y)},
                 glyph.glyph);
    }
    CHECK(by_run.ink() > 255 * 100);
    CHECK(by_run == one_by_one);
  }
}

TEST(run_is_what_its_layout_draws) {
  const Font font = open();
  for (int32_t px = 9; px <= 40; px += 5) {
    const Style style = style_of(px);
    for (const ShapedRun* run : kRuns) {
      static Page by_run;
      static Page by_layout;
      by_run.clear();
      by_layout.clear();
      Painter(by_run.sink()).text(font, style, kOrigin, *run);
      PositionedGlyph room[32];
      Span<const PositionedGlyph> glyphs;
      CHECK_OK(Painter().lay_out(font, Style(), *run, room, glyphs));
      CHECK_EQ(glyphs.size, run->glyphs.size);
      Painter(by_layout.sink()).glyphs(font, style, kOrigin, glyphs);
      CHECK(by_run == by_layout);
    }
  }
}

TEST(layout_needs_room_for_all_glyphs) {
  const Font font = open();
  const ShapedRun& run = fonts::labels_strings::title;
  PositionedGlyph room[32];
  Span<const PositionedGlyph> glyphs;
  CHECK_EQ(Painter().lay_out(font, Style(), run, {room, run.glyphs.size - 1},
                             glyphs),
           Status::buffer_small);
  CHECK_EQ(glyphs.size, 0);
  CHECK_OK(
      Painter().lay_out(font, Style(), run, {room, run.glyphs.size}, glyphs));
  CHECK_EQ(glyphs.size, run.glyphs.size);
}

// The ink lies in the box of measure(), to a pixel for the filter's ramp.
TEST(measure_has_the_ink) {
  const Font font = open();
  const Style style = style_of(32);
  for (const ShapedRun* run : kRuns) {
    const PixelMeasure box = Painter().measure(font, style, *run);
    CHECK_EQ(box.advance.raw, to_px(font, style, run->advance).raw);
    CHECK(box.right.raw > box.left.raw && box.bottom.raw > box.top.raw);
    Ink ink;
    Painter(ink.sink()).text(font, style, kOrigin, *run);
    const auto near = [](int32_t px, Q26_6 length) {
      const int32_t apart = 64 * px - length.raw;
      return apart >= -128 && apart <= 128;
    };
    CHECK(near(ink.box.x0 - 4, box.left));
    CHECK(near(ink.box.x1 - 4, box.right));
    CHECK(near(ink.box.y0 - 28, box.top));
    CHECK(near(ink.box.y1 - 28, box.bottom));
  }
}

// Without ligatures, marks and blanks a run is a line of text.
TEST(fitted_letters_stand_as_those_of_text) {
  const Font font = open();
  for (int32_t px = 8; px <= 20; ++px) {
    const FittedStyle fitted(font, px);
    const ShapedRun& run = fonts::labels_strings::plain;
    PositionedGlyph room[32];
    Span<const PositionedGlyph> glyphs;
    CHECK_OK(Painter().lay_out(font, fitted.style, run, room, glyphs));
    TextCursor cursor(font, "Settings:12:34", fitted.style);
    PositionedGlyph letter;
    size_t count = 0;
    while (cursor.next(letter) && count < glyphs.size) {
      CHECK_EQ(glyphs[count].glyph, letter.glyph);
      CHECK_EQ(glyphs[count].x, letter.x);
      ++count;
    }
    CHECK_EQ(count, glyphs.size);
    CHECK_EQ(Painter().measure(font, fitted.style, run).advance.raw,
             to_px(font, fitted.style, cursor.advance()).raw);
  }
}

// Letters of all runs lie on whole pixels, and marks as near to their letter as
// designed, to half a pixel.
TEST(fitted_glyphs_stand_on_whole_pixels) {
  const Font font = open();
  for (int32_t px = 8; px <= 20; ++px) {
    const FittedStyle fitted(font, px);
    for (const ShapedRun* run : kRuns) {
      PositionedGlyph room[32];
      Span<const PositionedGlyph> glyphs;
      CHECK_OK(Painter().lay_out(font, fitted.style, *run, room, glyphs));
      PositionedGlyph designed[32];
      Span<const PositionedGlyph> as_designed;
      CHECK_OK(Painter().lay_out(font, Style(), *run, designed, as_designed));
      for (size_t i = 0; i < glyphs.size; ++i) {
        const int32_t x_q6 = to_px(font, fitted.style, glyphs[i].x).raw;
        const int32_t off_q6 = ((x_q6 + 32) & 63) - 32;
        CHECK(off_q6 >= -1 && off_q6 <= 1);
        CHECK_EQ(glyphs[i].y, as_designed[i].y);
        if (i != 0 && as_designed[i].y != 0) {
          const int32_t wide_q6 =
              to_px(font, fitted.style, glyphs[i].x - glyphs[i - 1].x).raw;
          const int32_t designed_q6 =
              to_px(font, fitted.style, as_designed[i].x - as_designed[i - 1].x)
                  .raw;
          CHECK(wide_q6 - designed_q6 <= 34 && designed_q6 - wide_q6 <= 34);
        }
      }
    }
  }
}

TEST(styles_that_are_not_fitted_keep_the_design) {
  const Font font = open();
  const Style style = style_of(11);
  for (const ShapedRun* run : kRuns) {
    PositionedGlyph room[32];
    Span<const PositionedGlyph> glyphs;
    CHECK_OK(Painter().lay_out(font, style, *run, room, glyphs));
    int32_t designed = 0;
    for (size_t i = 0; i < glyphs.size; ++i) {
      designed += run->glyphs[i].x;
      CHECK_EQ(glyphs[i].x, designed);
      CHECK_EQ(glyphs[i].y, run->glyphs[i].y);
    }
    CHECK_EQ(Painter().measure(font, style, *run).advance.raw,
             to_px(font, style, run->advance).raw);
  }
}

TEST(blanks_have_an_advance_and_no_glyphs) {
  const ShapedRun& blank = fonts::labels_strings::blank;
  CHECK_EQ(blank.glyphs.size, 0);
  CHECK(blank.advance > 0);
  const Font font = open();
  const Style style = style_of(32);
  const PixelMeasure box = Painter().measure(font, style, blank);
  CHECK_EQ(box.advance.raw, to_px(font, style, blank.advance).raw);
  CHECK_EQ(box.right.raw, 0);
  CHECK_EQ(box.bottom.raw, 0);
}

TEST(title_is_centred) {
  const Font font = open();
  Ink ink;
  draw_title(font, style_of(24), kWidth, 30, ink.sink({0, 24, kWidth, 25}));
  CHECK(ink.box.x0 > 0 && ink.box.x0 < ink.box.x1);
  const int32_t off = ink.box.x0 - (kWidth - ink.box.x1);
  CHECK(off >= -4 && off <= 4);
}

// Runs of another font, and any numbers: nothing is read outside the font.
TEST(any_numbers_are_safe) {
  const Font font = open();
  ShapedGlyph glyphs[600];
  for (int32_t i = 0; i < 600; ++i) {
    glyphs[i].glyph = static_cast<uint16_t>(i * 109);
    glyphs[i].x = static_cast<int16_t>(i < 20 ? i - 7 : 32767);
    glyphs[i].y = static_cast<int16_t>(i * 77 - 23000);
  }
  const ShapedRun run = {glyphs, INT32_MIN};
  static Page page;
  Painter(page.sink()).text(font, style_of(12), kOrigin, run);
  static PositionedGlyph room[600];
  Span<const PositionedGlyph> placed;
  CHECK_OK(Painter().lay_out(font, Style(), run, room, placed));
  CHECK_EQ(placed[599].x, 1 << 24);
  // A 64th of a pixel is a font unit.
  CHECK_EQ(font.units_per_em(), 2048);
  CHECK(Painter().measure(font, style_of(32), run).right.raw <= 1 << 24);
  const FittedStyle fitted(font, 40);
  Painter(page.sink()).text(font, fitted.style, kOrigin, run);
  CHECK(Painter().measure(font, fitted.style, run).right.raw > 0);
  // A font without glyphs has none of them.
  static Page empty;
  Painter(empty.sink()).text(Font(), style_of(12), kOrigin, run);
  CHECK_EQ(empty.ink(), 0);
}

// The font has the characters of this file's literals, not only glyphs of runs.
TEST(literals_have_their_characters) {
  const Font font = open();
  for (Text text =
           "Z\u00df"
           "\xc2\xb5";
       text.size != 0;) {
    uint16_t glyph = 0;
    CHECK_OK(font.glyph_of(next_code_point(text), glyph));
  }
  uint16_t glyph = 0;
  CHECK_EQ(font.glyph_of('Q', glyph), Status::no_glyph);
}

TEST(c_draws_the_same) {
  inkcell_font_t font_c;
  CHECK_EQ(open_greeting_font(&font_c), INKCELL_OK);
  const Font font = open();
  const Style style = style_of(20);
  static Page by_c;
  static Page by_cpp;
  const Sink to_c = by_c.sink();
  draw_greeting(&font_c, reinterpret_cast<const inkcell_style_t*>(&style),
                reinterpret_cast<const inkcell_sink_t*>(&to_c));
  Painter(by_cpp.sink())
      .text(font, style, kOrigin, fonts::labels_strings::greeting);
  CHECK(by_c.ink() > 255 * 100);
  CHECK(by_c == by_cpp);

  inkcell_positioned_glyph_t room[32];
  size_t count = 1;
  inkcell_pixel_measure_t box;
  const Style plain = style_of(12);
  const auto* const plain_c = reinterpret_cast<const inkcell_style_t*>(&plain);
  CHECK_EQ(measure_greeting(&font_c, plain_c, room, 3, &count, &box),
           INKCELL_BUFFER_SMALL);
  CHECK_EQ(count, 0);
  CHECK_EQ(measure_greeting(&font_c, plain_c, room, 32, &count, &box),
           INKCELL_OK);
  CHECK_EQ(count, fonts::labels_strings::greeting.glyphs.size);
  const PixelMeasure expected =
      Painter().measure(font, plain, fonts::labels_strings::greeting);
  CHECK_EQ(box.advance_q6, expected.advance.raw);
  CHECK_EQ(box.left_q6, expected.left.raw);
  CHECK_EQ(box.top_q6, expected.top.raw);

  const FittedStyle fitted(font, 10);
  const void* same = &font_c;
  const FittedStyle fitted_c(*static_cast<const Font*>(same), 10);
  CHECK_EQ(
      measure_greeting(
          &font_c, reinterpret_cast<const inkcell_style_t*>(&fitted_c.style),
          room, 32, &count, &box),
      INKCELL_OK);
  CHECK_EQ(box.advance_q6,
           Painter()
               .measure(font, fitted.style, fonts::labels_strings::greeting)
               .advance.raw);
}
