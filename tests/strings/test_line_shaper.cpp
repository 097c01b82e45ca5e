// Painters whose lines are shaped draw, measure and move what boxes draw.
#include "inkcell/layout/line_shaper.hpp"

#include <initializer_list>

#include "draw_message.h"
#include "inkcell/motion/moving_letters.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/typewriter.hpp"
#include "inkcell/value_label.hpp"
#include "run_time_text.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::test;

constexpr Point kPen = {20, 60};

// A box around the text, whose line stands at the pen.
TextBox box_at_pen(Shaped& shaped) {
  TextBox box = shaped.box({20, 0, 20 + kWidth, 200});
  box.options.wraps = false;
  box.options.align = Align::left;
  box.rect.y0 = 60 - (baseline(box.options).raw >> 6);
  return box;
}

// Short lines: those of the cases are wider than the page.
// clang-format off
constexpr const char* kLines[] = {
    "السلام (123) عليكم",
    "مرحبا، لا إله [5]",
    "שלום (12) בְּרֵאשִׁ֖ית",
    "ปี่ ที่นี่ (12) น้ำ",
    "office Tie\u0302\u0301ng",
    "हिन्दी (१२) क्षत्रिय",
    "fi السلام fl",
    "A price of 5 عشرة"};
// clang-format on

}  // namespace

TEST(painters_draw_what_boxes_draw) {
  for (size_t i = 0; i < 8; ++i) {
    Shaped shaped(kCases[i].rom);
    LineShaper lines(shaped.shaper, shaped.bidi);
    const Text text(kLines[i]);
    const TextBox box = box_at_pen(shaped);
    Page expected;
    box.draw(text, Painter(expected.canvas));
    Page page;
    const Painter painter = Painter(page.canvas).with(lines);
    painter.text(shaped.font, shaped.style, kPen, text);
    CHECK(page.ink() > 200);
    CHECK_EQ(page.differences(expected), 0);
    // Nor do others forget how it is done: without the shaper it differs.
    Page plain;
    Painter(plain.canvas).text(shaped.font, shaped.style, kPen, text);
    CHECK(page.differences(plain) > 20);

    const PixelMeasure measure =
        painter.measure(shaped.font, shaped.style, text);
    CHECK_EQ(measure.advance.raw, box.measure(text, {}).width.raw);
    const Rect ink = painter.box(shaped.font, shaped.style, kPen, text);
    const Rect box_ink = box.box(text, {});
    CHECK(ink.x0 == box_ink.x0 && ink.y0 == box_ink.y0);
    CHECK(ink.x1 == box_ink.x1 && ink.y1 == box_ink.y1);

    PositionedGlyph room[64];
    Span<const PositionedGlyph> glyphs;
    CHECK_OK(painter.lay_out(shaped.font, shaped.style, text, room, glyphs));
    Page again;
    Painter(again.canvas).glyphs(shaped.font, shaped.style, kPen, glyphs);
    CHECK_EQ(again.differences(expected), 0);
    CHECK_EQ(
        painter.lay_out(shaped.font, shaped.style, text, {room, 3}, glyphs),
        Status::buffer_small);
  }
}

// docs/LAYOUT.md shows it.
TEST(a_painter_takes_a_shaper) {
  Shaped shaped(fonts::shaped_naskh);
  const Font& font = shaped.font;
  const Style& style = shaped.style;
  TextShaper& shaper = shaped.shaper;
  Bidi& bidi = shaped.bidi;
  Page page;
  const Painter painter(page.canvas);
  LineShaper lines(shaper, bidi);  // <inkcell/layout/line_shaper.hpp>
  const Painter shaping = painter.with(lines);
  shaping.text(font, style, kPen, "مرحبا");
  Page plain;
  Painter(plain.canvas).text(font, style, kPen, "مرحبا");
  CHECK(page.differences(plain) > 50);
}

TEST(c_shapes_lines_and_boxes) {
  Shaped shaped(fonts::shaped_naskh);
  const char* const text = "السلام عليكم، الكِتَابُ كلمةٌ طويلة (12)";
  static Page by_c;
  const Sink to_c = by_c.canvas;
  draw_message(reinterpret_cast<const inkcell_font_t*>(&shaped.font),
               reinterpret_cast<const inkcell_style_t*>(&shaped.style),
               reinterpret_cast<const inkcell_sink_t*>(&to_c), text);
  LineShaper lines(shaped.shaper, shaped.bidi);
  static Page by_cpp;
  const Painter painter(by_cpp.canvas);
  painter.with(lines).text(shaped.font, shaped.style, kPen, text);
  shaped.box({20, 80, 220, 180}).draw(text, painter);
  CHECK(by_c.ink() > 1000);
  CHECK_EQ(by_c.differences(by_cpp), 0);
}

TEST(value_labels_shape_by_their_painter) {
  Shaped shaped(fonts::shaped_naskh);
  LineShaper lines(shaped.shaper, shaped.bidi);
  Page page;
  const Painter painter = Painter(page.canvas).with(lines);
  for (const Anchor anchor : {Anchor::left, Anchor::centre, Anchor::right}) {
    ValueLabel label(shaped.font, shaped.style, {160, 60}, anchor);
    CHECK(!is_empty(label.set("الكلمة", painter)));
    const Rect changed = label.set("قبل", painter);
    Page drawn;
    label.draw(Painter(drawn.canvas).with(lines));
    const Q26_6 width =
        painter.measure(shaped.font, shaped.style, "قبل").advance;
    Point pen(160, 60);
    pen.x.raw -= width.raw * static_cast<int32_t>(anchor) / 2;
    Page expected;
    Painter(expected.canvas)
        .with(lines)
        .text(shaped.font, shaped.style, pen, "قبل");
    CHECK(drawn.ink() > 50);
    CHECK_EQ(drawn.differences(expected), 0);
    CHECK(intersect(changed, label.box()).x1 == label.box().x1);
  }
}

// Typed text is a part of the whole, letter by letter, from its own side.
TEST(typewriters_type_whole_letters) {
  for (size_t i = 0; i < 8; ++i) {
    Shaped shaped(kCases[i].rom);
    LineShaper lines(shaped.shaper, shaped.bidi);
    Page whole;
    const Painter painter = Painter(whole.canvas).with(lines);
    painter.text(shaped.font, shaped.style, kPen, kLines[i]);
    motion::Typewriter line(shaped.font, shaped.style, kPen, kLines[i], 100);
    Page shown;
    int32_t steps = 0;
    for (int32_t now = 0; now <= line.end_ms() + 600; now += 50) {
      const Rect changed = line.at(now, painter);
      Page page;
      line.draw(Painter(page.canvas).with(lines));
      int32_t outside = 0;
      for (int32_t at = 0; at < kWidth * kHeight; ++at) {
        const int32_t x = at % kWidth;
        const int32_t y = at / kWidth;
        const bool is_in = x >= changed.x0 && x < changed.x1 &&
                           y >= changed.y0 && y < changed.y1;
        outside += page.pixels[at] != shown.pixels[at] && !is_in ? 1 : 0;
      }
      CHECK_EQ(outside, 0);
      steps += page.differences(shown) != 0 ? 1 : 0;
      shown = page;
    }
    CHECK(steps > 8);
    CHECK_EQ(shown.differences(whole), 0);  // the caret is off
  }
}

TEST(carets_of_typewriters_go_the_way_of_the_text) {
  Shaped shaped(fonts::shaped_naskh);
  LineShaper lines(shaped.shaper, shaped.bidi);
  const Painter painter = Painter().with(lines);
  motion::Typewriter line(shaped.font, shaped.style, kPen, "سلام قبل", 100);
  const int32_t width =
      painter.measure(shaped.font, shaped.style, "سلام قبل").advance.raw >> 6;
  line.at(0, painter);
  int32_t last = line.caret().x0;
  CHECK(magnitude(last - (20 + width)) < 4);
  for (int32_t now = 100; now <= line.end_ms(); now += 100) {
    line.at(now, painter);
    CHECK(line.caret().x0 <= last);
    last = line.caret().x0;
  }
  CHECK(magnitude(last - 20) < 4);
}

// A letter and its marks are one, on a line, on a path and on a circle.
TEST(letters_move_with_their_marks) {
  Shaped shaped(fonts::shaped_naskh);
  LineShaper lines(shaped.shaper, shaped.bidi);
  const Painter painter = Painter().with(lines);
  const Text text("مُحَمَّدٌ لا");
  motion::RunGlyph room[40];
  motion::Run run;
  CHECK_OK(
      motion::lay_out(painter, shaped.font, text, Anchor::left, room, run));
  CHECK_EQ(run.letters, 6);
  CHECK_EQ(run.words, 2);
  CHECK(run.glyphs.size > 9);
  PositionedGlyph plain_room[40];
  Span<const PositionedGlyph> plain;
  CHECK_OK(painter.lay_out(shaped.font, shaped.style, text, plain_room, plain));
  motion::RunPlace where;
  where.origin = kPen;
  where.size = shaped.style.size();
  where.tracking = 3_px;
  motion::Pose turned;
  turned.angle.raw = 5000;
  for (size_t i = 1; i < run.glyphs.size; ++i) {
    const motion::PosedGlyph before =
        place(shaped.font, run, i - 1, where, turned);
    const motion::PosedGlyph now = place(shaped.font, run, i, where, turned);
    const bool is_same = run.glyphs[i].letter == run.glyphs[i - 1].letter;
    CHECK_EQ(magnitude(now.at.x.raw - before.at.x.raw) < 2, is_same);
    CHECK(magnitude(now.at.y.raw - before.at.y.raw) < 2);
    CHECK_EQ(unit_of(run, motion::Unit::glyph, i) ==
                 unit_of(run, motion::Unit::glyph, i - 1),
             is_same);
  }
  CHECK_EQ(unit_count(run, motion::Unit::glyph), 6u);

  // At the top of a circle a letter stands as on a line.
  const Text letter("مُّ");
  Page straight;
  Painter(straight.canvas)
      .with(lines)
      .text(shaped.font, shaped.style, kPen, letter);
  Page curved;
  motion::TextCircle circle;
  circle.radius = 100_px;
  circle.centre = {20, 160};
  circle.centre.x.raw +=
      painter.measure(shaped.font, shaped.style, letter).advance.raw / 2;
  circle.at.raw = 1 << 14;
  draw_on_circle(Painter(curved.canvas).with(lines), shaped.font, shaped.style,
                 circle, letter);
  int32_t far = 0;
  for (int32_t at = 0; at < kWidth * kHeight; ++at) {
    far += magnitude(straight.pixels[at] - curved.pixels[at]) > 32 ? 1 : 0;
  }
  CHECK(curved.ink() > 50);
  CHECK_EQ(far, 0);
}
