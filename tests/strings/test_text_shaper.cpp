// Text that comes at run time: boxes and labels draw what the shaper makes of
// whole runs, which fonts.shaped_words compares with HarfBuzz.
#include "inkcell/shaping/text_shaper.hpp"

#include <vector>

#include "inkcell/layout/label.hpp"
#include "inkcell/layout/spans.hpp"
#include "run_time_text.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::test;

// A line as whole runs of the shaper give it, from left to right.
class WholeRuns {
 public:
  WholeRuns(const Font& font, const Shaping& shaping)
      : font_(font), shaping_(shaping) {}

  void add(const Text& text, Bidi& bidi, const TextLine& line) {
    if (line.length == 0) {
      return;
    }
    BidiRun run = bidi.first_run(line.begin, line.end());
    do {
      std::vector<ScriptRun> scripts = {
          shaping_.first_run(text, run.begin, run.end)};
      ScriptRun next = scripts.back();
      while (shaping_.next_run(text, run.end, next)) {
        scripts.push_back(next);
      }
      const bool is_rtl = run.is_right_to_left();
      for (size_t i = 0; i < scripts.size(); ++i) {
        ScriptRun& part = scripts[is_rtl ? scripts.size() - 1 - i : i];
        part.is_right_to_left = is_rtl;
        add_part(text, part);
      }
    } while (bidi.next_run(line.begin, line.end(), run));
  }

  int32_t width() const { return x_; }
  const std::vector<PositionedGlyph>& glyphs() const { return glyphs_; }

 private:
  void add_part(const Text& text, const ScriptRun& part) {
    std::vector<TextGlyph> room(2 * (part.end - part.begin) + 2);
    Span<TextGlyph> glyphs(room.data(), room.size());
    CHECK_OK(shaping_.shape(text, part, glyphs));
    int32_t before = -1;
    for (const TextGlyph& glyph : glyphs) {
      // What is of no script kerns as pairs do.
      if (part.program == ScriptRun::kNoProgram && before >= 0) {
        x_ += font_.kerning(static_cast<uint16_t>(before), glyph.glyph);
      }
      before = glyph.glyph;
      PositionedGlyph at;
      at.x = x_ + glyph.x;
      at.y = glyph.y;
      at.glyph = glyph.glyph;
      glyphs_.push_back(at);
      x_ += glyph.advance;
    }
  }

  const Font& font_;
  const Shaping& shaping_;
  int32_t x_ = 0;
  std::vector<PositionedGlyph> glyphs_;
};

// Tabs are stops of the line.
bool has_tab(const Text& text, const TextLine& line) {
  for (uint32_t i = line.begin; i < line.end(); ++i) {
    if (text.data[i] == '\t') {
      return true;
    }
  }
  return false;
}

Text first_paragraph(Text text) {
  for (size_t i = 0; i < text.size; ++i) {
    text.size = text.data[i] == '\n' ? i : text.size;
  }
  return text;
}

}  // namespace

TEST(boxes_draw_what_whole_runs_are) {
  for (const Case& one : kCases) {
    Shaped shaped(one.rom);
    CHECK_EQ(shaped.shaping.parts_at_spaces(), one.parts_at_spaces);
    const Text text(one.text);
    for (const int32_t width : {312, 150, 90}) {
      const TextBox box = shaped.box({4, 4, 4 + width, kHeight});
      Page page;
      const Painter painter(page.canvas);
      TextLine room[40];
      Span<const TextLine> lines;
      CHECK_OK(box.lay_out(text, painter, room, lines));
      CHECK(lines.size > (width == 312 ? 0u : 1u));
      box.draw(text, painter, lines);
      CHECK(page.ink() > 100);

      Page whole;
      int32_t baseline_q6 = 4 * 64 + baseline(box.options).raw;
      for (const TextLine& line : lines) {
        shaped.bidi.prepare(text, line.paragraph, BaseDirection::from_text);
        WholeRuns runs(shaped.font, shaped.shaping);
        if (has_tab(text, line)) {
          // As another text that tells nothing of whole runs.
          Span<const PositionedGlyph> glyphs;
          PositionedGlyph glyph_room[200];
          CHECK_OK(lay_out(box.options, painter, text, line,
                           Q26_6::from_int(width), glyph_room, glyphs));
          Painter(whole.canvas)
              .glyphs(shaped.font, shaped.style,
                      {4_px, Q26_6::from_raw(baseline_q6)}, glyphs);
        } else {
          runs.add(text, shaped.bidi, line);
          CHECK_EQ(runs.width(), line.width);
          const int32_t left = line.base_level % 2 == 0
                                   ? 0
                                   : width * 64 * shaped.font.units_per_em() /
                                             shaped.style.size().raw -
                                         line.width;
          std::vector<PositionedGlyph> glyphs = runs.glyphs();
          for (PositionedGlyph& glyph : glyphs) {
            glyph.x += left;
          }
          Painter(whole.canvas)
              .glyphs(shaped.font, shaped.style,
                      {4_px, Q26_6::from_raw(baseline_q6)},
                      {glyphs.data(), glyphs.size()});
        }
        baseline_q6 += line_height(box.options).raw;
      }
      CHECK_EQ(page.differences(whole), 0);
    }
  }
}

// docs/LAYOUT.md shows it: in less room, without Devanagari.
TEST(a_box_takes_a_shaper) {
  Shaped shaped(fonts::shaped_naskh);
  TextBox box = shaped.box({4, 4, 304, kHeight});
  Page expected;
  box.draw(kArabic, Painter(expected.canvas));
  static TextGlyph room[64];       // the longest word, 16 bytes a glyph
  static TextShaper shaper(room);  // <inkcell/shaping/text_shaper.hpp>
  box.options.set_shaper(shaper);
  Page page;
  box.draw(kArabic, Painter(page.canvas));
  CHECK(page.ink() > 1000);
  CHECK_EQ(page.differences(expected), 0);
}

// In strips, and as a span of all.
TEST(shaped_text_does_not_depend_on_how_it_is_drawn) {
  for (const Case& one : kCases) {
    Shaped shaped(one.rom);
    TextBox box = shaped.box({4, 4, 154, kHeight});
    box.options.align = Align::justify;
    Page page;
    box.draw(one.text, Painter(page.canvas));
    Page strips;
    for (int32_t y = 0; y < kHeight; y += 7) {
      Sink part = strips.canvas;
      part.window = intersect(part.window, {0, y, kWidth, y + 7});
      box.draw(one.text, Painter(part));
    }
    CHECK_EQ(page.differences(strips), 0);
    Page spans;
    draw_span(box, one.text, TextSpan(), Painter(spans.canvas));
    CHECK_EQ(page.differences(spans), 0);
  }
}

// Words that the room does not hold are shaped in parts, which join; a report
// tells.
TEST(long_words_join_where_they_are_cut) {
  Shaped shaped(fonts::shaped_naskh);
  const char* const word = "مستنبطنقشهقنبسمعتسن";
  const TextBox box = shaped.box({0, 0, kWidth, 40});
  Page page;
  const Painter painter(page.canvas);
  box.draw(word, painter);
  TextGlyph small_room[6];
  TextShaper small(small_room);
  TextBox small_box = box;
  small_box.options.set_shaper(small);
  Page parts;
  TextReport report;
  Page short_word;
  small_box.draw("مستن", {short_word.canvas, {}, nullptr, &report});
  CHECK_EQ(report.status, Status::ok);
  small_box.draw(word, {parts.canvas, {}, nullptr, &report});
  CHECK_EQ(report.status, Status::buffer_small);
  CHECK(page.ink() > 100);
  CHECK_EQ(page.differences(parts), 0);
  // So does one that ends where a line is full.
  TextBox narrow = box;
  narrow.rect.x1 = 60;
  TextLine lines[9];
  Span<const TextLine> found;
  CHECK_OK(narrow.lay_out(word, painter, lines, found));
  CHECK(found.size > 1);
  PositionedGlyph room[40];
  Span<const PositionedGlyph> glyphs;
  const TextLine& line = found[0];
  CHECK_OK(lay_out(narrow.options, painter, word, line, 60_px, room, glyphs));
  TextGlyph run_room[40];
  Span<TextGlyph> run(run_room);
  ScriptRun all = shaped.shaping.first_run(word, 0, Text(word).size);
  CHECK_OK(shaped.shaping.shape(word, all, run));
  CHECK(glyphs.size < run.size);
  for (size_t i = 0; i < glyphs.size; ++i) {
    CHECK_EQ(glyphs[i].glyph, run[run.size - glyphs.size + i].glyph);
  }
}

TEST(carets_stand_between_clusters) {
  Shaped shaped(fonts::shaped_dejavu);
  const Text text = "سلام";
  const TextBox box = shaped.box({0, 0, 200, 40});
  const Painter painter;
  // Lam and alef are a ligature: one place for both.
  const int32_t lam = box.caret(text, painter, {2, false}).x0;
  CHECK_EQ(box.caret(text, painter, {4, false}).x0, lam);
  const int32_t seen = box.caret(text, painter, {0, false}).x0;
  const int32_t mim = box.caret(text, painter, {6, false}).x0;
  const int32_t end = box.caret(text, painter, {8, false}).x0;
  CHECK(seen > lam);
  CHECK(lam > mim);
  CHECK(mim > end);
  size_t last = 0;
  for (int32_t x = 199; x >= 0; --x) {
    const TextPlace place = box.hit(text, painter, x, 10);
    CHECK(place.offset != 4);
    CHECK(place.offset >= last);
    last = place.offset;
  }
  CHECK_EQ(last, 8u);
}

TEST(measures_are_those_of_what_is_drawn) {
  for (const Case& one : kCases) {
    Shaped shaped(one.rom);
    TextBox box = shaped.box({0, 0, 120, kHeight});
    const TextSize size = box.measure(one.text, {});
    CHECK(size.lines > 1);
    CHECK(size.width.raw <= 120 * 64);
    Page page;
    const Painter painter(page.canvas);
    box.draw(one.text, painter);
    const Rect ink = box.box(one.text, painter);
    int32_t outside = 0;
    for (int32_t y = 0; y < kHeight; ++y) {
      for (int32_t x = 0; x < kWidth; ++x) {
        const bool is_in =
            x >= ink.x0 && x < ink.x1 && y >= ink.y0 && y < ink.y1;
        outside += !is_in && page.pixels[y * kWidth + x] != 0 ? 1 : 0;
      }
    }
    CHECK_EQ(outside, 0);
  }
}

TEST(labels_scroll_what_boxes_draw) {
  for (const Case& one : kCases) {
    Shaped shaped(one.rom);
    TextBox box = shaped.box({0, 0, 4000, 40});
    box.options.wraps = false;
    box.options.align = Align::left;
    const Text text = first_paragraph(one.text);
    static PositionedGlyph room[400];
    ScrollingLabel label;
    CHECK_OK(ScrollingLabel::make(box.options, {}, text, {0, 0, kWidth, 40},
                                  room, label));
    for (const int32_t scroll : {0, 33, 150}) {
      Page moved;
      label.draw(Q26_6::from_int(scroll), Painter(moved.canvas));
      Page page;
      box.rect = {-scroll, 0, 4000, 40};
      const int32_t free_q6 = 40 * 64 - line_height(box.options).raw;
      box.rect.y0 = (free_q6 / 2) >> 6;
      box.draw(text, Painter(page.canvas));
      CHECK(moved.ink() > 50);
      CHECK_EQ(moved.differences(page), 0);
    }
  }
}

TEST(ellipses_cut_words_that_stay_joined) {
  Shaped shaped(fonts::shaped_dejavu);
  TextBox box = shaped.box({0, 0, 90, 24});
  box.options.wraps = false;
  for (const Ellipsis ellipsis : {Ellipsis::end, Ellipsis::middle}) {
    box.options.ellipsis = ellipsis;
    for (const char* const words : {kArabic, kLatin, kMixed}) {
      const Text text = first_paragraph(words);
      TextLine room[2];
      Span<const TextLine> lines;
      CHECK_OK(box.lay_out(text, {}, {room, 1}, lines));
      CHECK(lines[0].has_ellipsis);
      PositionedGlyph glyph_room[100];
      Span<const PositionedGlyph> glyphs;
      CHECK_OK(
          lay_out(box.options, {}, text, lines[0], 90_px, glyph_room, glyphs));
      CHECK(glyphs.size > 4);
      // The line is as wide as what it is made of.
      int32_t right = 0;
      for (const PositionedGlyph& glyph : glyphs) {
        const int32_t end = glyph.x + shaped.font.advance(glyph.glyph);
        right = end > right ? end : right;
      }
      CHECK(magnitude(right - (lines[0].base_level % 2 != 0
                                   ? 90 * 64 * shaped.font.units_per_em() /
                                         shaped.style.size().raw
                                   : lines[0].width)) <
            shaped.font.units_per_em() / 2);
    }
  }
}

// A face that shapes helps one that does not, and the other way round.
TEST(fallback_faces_shape_their_words) {
  Shaped shaped(fonts::shaped_latin);
  const Font naskh = open(fonts::shaped_naskh);
  const Style style(21_px);
  const Face other = {&naskh, &style};
  TextBox box = shaped.box({4, 4, 300, 60});
  box.options.fallback = {&other, 1};
  Page mixed;
  box.draw("سلام", Painter(mixed.canvas));
  TextBox alone(naskh, style, box.rect);
  alone.options.set_bidi(shaped.bidi);
  alone.options.set_shaper(shaped.shaper);
  // On the baseline of the first face.
  const int32_t lower_q6 =
      baseline(box.options).raw - baseline(alone.options).raw;
  CHECK_EQ(lower_q6 % 64, 0);
  alone.rect.y0 += lower_q6 / 64;
  Page page;
  alone.draw("سلام", Painter(page.canvas));
  CHECK(page.ink() > 100);
  // Widths are rounded to units of the first face.
  CHECK(page.ink() == mixed.ink() || page.differences(mixed) < page.ink() / 4);
}

TEST(reports_tell_what_is_not_shaped) {
  Shaped shaped(fonts::shaped_naskh);
  TextReport report;
  Page page;
  const Painter painter(page.canvas, {}, nullptr, &report);
  TextBox box = shaped.box({0, 0, 300, 40});
  box.draw("سلام مُحَمَّد", painter);
  CHECK_EQ(report.status, Status::ok);
  TextBox plain(shaped.font, shaped.style, box.rect);
  plain.draw("سلام", painter);
  CHECK_EQ(report.status, Status::needs_shaping);
  // Of a script that the font was not made for.
  report = {};
  Shaped other(fonts::shaped_dejavu);
  other.box(box.rect).draw("\u0e81\u0eb4", painter);
  CHECK_EQ(report.status, Status::needs_shaping);
}

TEST(letters_of_joined_words_are_not_spaced) {
  Shaped shaped(fonts::shaped_naskh);
  TextBox box = shaped.box({0, 0, 300, 40});
  const int32_t width = box.measure("سلام سلام", {}).width.raw;
  box.options.letter_spacing = 2_px;
  // Before the space, and behind it.
  const int32_t spaced = box.measure("سلام سلام", {}).width.raw;
  CHECK(magnitude(spaced - width - 2 * 128) <= 2);
}
