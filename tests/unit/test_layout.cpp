// Layout: places where lines end, boxes, labels, carets, directions.
#include "check.hpp"
#include "ink.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/painter.hpp"
#include "layout_font.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "sample_rom.hpp"

namespace {

using namespace inkcell;

alignas(4) uint8_t rom[layout_font::kBytes];

// At 10 px/em: letters 7.5 px, bars 6 px, spaces 5 px wide.
struct Setting {
  Font font = layout_font::open(rom);
  Style style;

  Setting() { style = Style(10_px, kFilterText); }
  TextBox box(const Rect& rect, Align align = Align::start) const {
    return TextBox(font, style, rect, align);
  }
};

bool breaks_at(Text text, const size_t* expected, size_t count) {
  LineBreaker breaker(text);
  LineBreak place;
  for (size_t i = 0; i != count; ++i) {
    if (!breaker.next(place) || place.offset != expected[i]) {
      return false;
    }
  }
  return !breaker.next(place);
}

template <size_t kCount>
void check_breaks(Text text, const size_t (&expected)[kCount]) {
  CHECK(breaks_at(text, expected, kCount));
}

// The ends of lines, and where the next ones begin.
struct Expected {
  uint32_t end;
  uint32_t next;
};

template <size_t kCount>
void check_lines(const LayoutOptions& options,
                 Text text,
                 int32_t px,
                 const Expected (&expected)[kCount]) {
  TextLine line;
  for (const Expected& wanted : expected) {
    CHECK(next_line(options, {}, text, Q26_6::from_int(px), line));
    CHECK_EQ(line.end(), wanted.end);
    CHECK_EQ(line.next, wanted.next);
  }
  CHECK(!next_line(options, {}, text, Q26_6::from_int(px), line));
}

// What docs/LAYOUT.md shows.
struct Screen {
  TextBox box;
  ScrollingLabel label;
  PositionedGlyph glyphs[64];
};

Status make_screen(const Font& font, const Style& style, Screen& out) {
  out.box = TextBox(font, style, {4, 4, 124, 44}, Align::centre);
  out.box.vertical = VerticalAlign::middle;
  out.box.options.ellipsis = Ellipsis::end;
  return ScrollingLabel::make(out.box.options, {}, "Now playing: a long title",
                              {0, 48, 128, 64}, out.glyphs, out.label);
}

void draw_screen(const Screen& screen,
                 int32_t scroll_px,
                 const Painter& painter) {
  screen.box.draw("A paragraph that wraps, and is centred.", painter);
  screen.label.draw_endless(Q26_6::from_int(scroll_px), 16_px, painter);
}

}  // namespace

TEST(lines_may_end_at_spaces_and_hyphens) {
  check_breaks("well-known words", {5, 11, 16});
  check_breaks("a\nb", {2, 3});
  check_breaks("(a) 1,000.5 b", {4, 12, 13});
  check_breaks(
      "a\xc2\xa0"
      "b",
      {4});  // no-break space
  check_breaks(
      "a\xe2\x80\x8b"
      "b",
      {4, 5});  // zero width space
  check_breaks("\xe4\xb8\x80\xe4\xba\x8c\xe3\x80\x82", {3, 9});  // no 。 alone
}

TEST(lines_wrap) {
  const Setting setting;
  LayoutOptions options(setting.font, setting.style);
  check_lines(options, "AB CC A", 33, {{5, 6}, {7, 7}});
  check_lines(options, "AB CC A", 20, {{2, 3}, {5, 6}, {7, 7}});
  check_lines(options, "ABAB", 16, {{2, 2}, {4, 4}});  // no room for the word
  check_lines(options, "A", 1, {{1, 1}});              // nor for a letter
  check_lines(options, "A\r\n\nB\n", 99, {{1, 3}, {3, 4}, {5, 6}, {6, 6}});
  check_lines(options, "", 99, {{0, 0}});
  options.wraps = false;
  check_lines(options, "AB CC A", 20, {{7, 7}});
}

TEST(widths_are_those_of_what_is_seen) {
  const Setting setting;
  LayoutOptions options(setting.font, setting.style);
  TextLine line;
  CHECK(next_line(options, {}, "AB   ", 99_px, line));
  CHECK_EQ(line.width, 1500);  // without spaces at the end
  options.letter_spacing = 1_px;
  line = {};
  CHECK(next_line(options, {}, "ABA", 99_px, line));
  CHECK_EQ(line.width, 3 * 750 + 2 * 100);
  options.letter_spacing = {};
  line = {};
  CHECK(next_line(options, {},
                  "A\xe2\x80\x8b\xc2\xad\xef\xb8\x8f"
                  "B",
                  99_px, line));
  CHECK_EQ(line.width, 1500);  // what has no width adds nothing
}

TEST(soft_hyphens_show_where_lines_end) {
  const Setting setting;
  const LayoutOptions options(setting.font, setting.style);
  TextLine line;
  CHECK(next_line(options, {},
                  "AB\xc2\xad"
                  "AB",
                  22_px, line));
  CHECK(line.has_hyphen);
  CHECK_EQ(line.next, 4);
  CHECK_EQ(line.width, 2 * 750 + 600);
  CHECK(next_line(options, {},
                  "AB\xc2\xad"
                  "AB",
                  22_px, line));
  CHECK(!line.has_hyphen);
}

// The same in boxes as in draw_text(), and nothing for signs that no face has.
TEST(fonts_may_lack_what_layout_adds) {
  static const font_builder::CmapEntry kCmap[] = {{'A', 0, 1}};
  static const font_builder::GlyphSpec kGlyphs[] = {
      {600, {195, 0, 430, 625}, font_builder::bar, nullptr},
      {750, {82, 82, 668, 668}, font_builder::disc, nullptr}};
  font_builder::FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {kGlyphs, 2};
  Setting setting;
  const size_t size = font_builder::build_font(spec, rom);
  CHECK_OK(open_any_font({rom, size}, setting.font));
  LayoutOptions options(setting.font, setting.style);
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  TextLine line;
  const Text text = "A A\xcc\x87\xd6\xb0\xcc\x81 A";
  CHECK(next_line(options, {}, text, 99_px, line));
  CHECK_OK(lay_out(options, {}, text, line, 99_px, room, glyphs));
  CHECK_EQ(glyphs.size, 3);
  CHECK_EQ(line.width, 3 * 750);
  CHECK_EQ(line.width, measure(setting.font, text).advance);

  const Text hyphenated =
      "AA\xc2\xad"
      "AA";
  line = {};
  CHECK(next_line(options, {}, hyphenated, 16_px, line));
  CHECK_EQ(line.next, 4);
  CHECK_EQ(line.width, 2 * 750);
  CHECK_OK(lay_out(options, {}, hyphenated, line, 16_px, room, glyphs));
  CHECK_EQ(glyphs.size, 2);

  options.wraps = false;
  for (const Ellipsis place : each_of({Ellipsis::end, Ellipsis::middle})) {
    options.ellipsis = place;
    line = {};
    CHECK(next_line(options, {}, "AAAAA", 24_px, line));
    shorten(options, {}, "AAAAA", 24_px, line);
    CHECK_OK(lay_out(options, {}, "AAAAA", line, 24_px, room, glyphs));
    CHECK_EQ(glyphs.size, 3);
    for (const PositionedGlyph& glyph : glyphs) {
      CHECK_EQ(glyph.glyph, 1);
    }
  }
}

TEST(tabs_stop) {
  const Setting setting;
  LayoutOptions options(setting.font, setting.style);
  const Q26_6 stops[] = {12_px, 15_px};
  options.tab_stops = stops;
  options.tab_width = 20_px;
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  TextLine line;
  const Text text = "A\tB\tC\tC";
  CHECK(next_line(options, {}, text, 99_px, line));
  CHECK_OK(lay_out(options, {}, text, line, 99_px, room, glyphs));
  CHECK_EQ(glyphs.size, 4);
  CHECK_EQ(glyphs[1].x, 1200);
  CHECK_EQ(glyphs[2].x, 2000);  // behind the last stop: multiples
  CHECK_EQ(glyphs[3].x, 4000);
  CHECK_EQ(glyphs[3].offset, 6);
}

TEST(boxes_align) {
  const Setting setting;
  Picture<22, 22> picture;
  setting.box({1, 0, 21, 22}, Align::centre).draw("CC C", picture.sink());
  CHECK_PICTURE_AT(picture, 6, 2,
                   ".:::...:::\n"
                   ":##:..:##:\n"
                   ":##:..:##:\n"
                   ":##:..:##:\n"
                   ":##:..:##:\n"
                   ":##:..:##:\n"
                   ":**:..:**:\n"
                   "..........\n"
                   "..........\n"
                   "..........\n"
                   "..........\n"
                   "....:::...\n"
                   "...:##:...\n"
                   "...:##:...\n"
                   "...:##:...\n"
                   "...:##:...\n"
                   "...:##:...\n"
                   "...:**:...\n");
}

TEST(boxes_justify) {
  const Setting setting;
  static Picture<40, 22> picture;  // stacks of boards have 4 KB
  setting.box({0, 0, 37, 22}, Align::justify).draw("C C C C", picture.sink());
  CHECK_PICTURE_AT(picture, 1, 2,
                   ".:::............:::.............:::\n"
                   ":##:............+#*............:##:\n"
                   ":##:............+#*............:##:\n"
                   ":##:............+#*............:##:\n"
                   ":##:............+#*............:##:\n"
                   ":##:............+#*............:##:\n"
                   ":**:............+#*............:**:\n"
                   "................:..................\n"
                   "...................................\n"
                   "...................................\n"
                   "...................................\n"
                   ".:::...............................\n"
                   ":##:...............................\n"
                   ":##:...............................\n"
                   ":##:...............................\n"
                   ":##:...............................\n"
                   ":##:...............................\n"
                   ":**:...............................\n");
}

TEST(boxes_clip_and_shorten) {
  const Setting setting;
  Picture<32, 12> picture;
  TextBox box = setting.box({2, 1, 30, 12});
  box.options.ellipsis = Ellipsis::end;
  box.options.wraps = false;
  box.draw("CCCCCC", picture.sink());
  CHECK_PICTURE_AT(picture, 3, 3,
                   ".:::...:::...:::...:::\n"
                   ":##:..:##:..:##:..:##:\n"
                   ":##:..:##:..:##:..:##:\n"
                   ":##:..:##:..:##:..:##:\n"
                   ":##:..:##:..:##:..:##:\n"
                   ":##:..:##:..:##:..:##:\n"
                   ":**:..:**:..:**:..:**:\n");
}

// The last line of a box holds what it has room for, not whole words.
TEST(an_ellipsis_fills_its_line) {
  const Setting setting;
  TextBox box = setting.box({0, 0, 34, 11});
  box.options.ellipsis = Ellipsis::end;  // three points of 6 px
  TextLine room[4];
  Span<const TextLine> lines;
  CHECK_OK(box.lay_out("A ABABABAB", {}, room, lines));
  CHECK_EQ(lines.size, 1);
  CHECK(lines[0].has_ellipsis);
  CHECK_EQ(lines[0].skip_at, 1);  // 'A' and no more than 16 px
  box.rect.x1 = 46;
  CHECK_OK(box.lay_out("A ABABABAB", {}, room, lines));
  CHECK_EQ(lines[0].skip_at, 4);  // 'A AB'
  CHECK_EQ(lines[0].width, 3 * 750 + 500 + 3 * 600);
  // In the second line, too, and not beyond its paragraph.
  box.rect.y1 = 22;
  CHECK_OK(box.lay_out("A\nA ABABABAB", {}, room, lines));
  CHECK_EQ(lines.size, 2);
  CHECK(!lines[0].has_ellipsis);
  CHECK_EQ(lines[1].skip_at, 4);
  CHECK_OK(box.lay_out("A\nA\nABABABAB", {}, room, lines));
  CHECK_EQ(lines.size, 2);
  CHECK_EQ(lines[1].skip_at, 1);
  // By hand.
  TextLine line;
  CHECK(next_line(box.options, {}, "A ABABABAB", 46_px, line));
  CHECK_EQ(line.next, 2);
  shorten(box.options, {}, "A ABABABAB", 46_px, line);
  CHECK_EQ(line.skip_at, 4);
}

// A disc for A, twice as wide as its advance.
Font open_overhanging() {
  static const font_builder::CmapEntry kCmap[] = {{'A', 0, 1}};
  static const font_builder::GlyphSpec kGlyphs[] = {
      {600, {195, 0, 430, 625}, font_builder::bar, nullptr},
      {300, {82, 82, 668, 668}, font_builder::disc, nullptr}};
  font_builder::FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {kGlyphs, 2};
  Font font;
  const size_t size = font_builder::build_font(spec, rom);
  CHECK_OK(open_any_font({rom, size}, font));
  return font;
}

TEST(ink_may_overhang_a_box) {
  const Font font = open_overhanging();
  const Style style(10_px, kFilterText);
  TextBox box(font, style, {3, 8, 30, 20});
  box.options.line_height = 4_px;  // less than the disc
  const TextSize size = box.measure("A", {});
  box.rect.x1 = 3 + size.width.floor();
  box.rect.y1 = 8 + size.height.floor();
  CHECK_EQ(box.rect.x1, 6);
  CHECK_EQ(box.rect.y1, 12);
  static Picture<20, 20> whole, boxed, cut;
  inkcell::Painter(whole.sink()).text(font, style, {3, 13}, "A");
  box.draw("A", boxed.sink());
  CHECK(whole.ink() > 26 * 255);
  CHECK_EQ(whole.ink(), boxed.ink());
  const Rect ink = box.box("A", {});
  const Rect by_painter = Painter().box(font, style, {3, 13}, "A");
  CHECK(is_same(ink, by_painter));
  CHECK(ink.x1 > box.rect.x1 && ink.y0 < box.rect.y0);
  // Ink is cut where somebody asks for it.
  box.clip = box.rect;
  box.draw("A", cut.sink());
  CHECK(cut.ink() < 12 * 255);
  CHECK_EQ(box.box("A", {}).x1, 6);
  CHECK_EQ(box.box("A", {}).y0, 8);
}

TEST(lines_outside_a_box_are_left_out) {
  const Setting setting;
  static Picture<30, 60> picture;
  TextBox box = setting.box({4, 20, 20, 35});
  const Text text = "C\nC\nC\nC";
  box.draw(text, picture.sink());
  // The second line alone, which begins in it; the third begins at 42.
  CHECK(picture.at(7, 24) != 0 && picture.at(7, 38) != 0);
  CHECK_EQ(picture.at(7, 50), 0);
  CHECK(box.box(text, {}).y0 >= 20 && box.box(text, {}).y0 <= 22);
  CHECK(box.box(text, {}).y1 >= 39 && box.box(text, {}).y1 <= 42);
  box.vertical = VerticalAlign::bottom;
  CHECK(box.box(text, {}).y0 >= 13 && box.box(text, {}).y0 <= 15);
  CHECK(box.box(text, {}).y1 >= 32 && box.box(text, {}).y1 <= 35);
}

TEST(mixed_lines_are_ordered) {
  const Setting setting;
  // The rings stand for alef, the bars of letters for bet and C.
  const Text text = "A \xd7\x90\xd7\x91 C";
  uint16_t cells[16];
  Bidi bidi(cells);
  LayoutOptions options(setting.font, setting.style);
  options.set_bidi(bidi);
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  TextLine line;
  CHECK(next_line(options, {}, text, 99_px, line));
  CHECK_OK(lay_out(options, {}, text, line, 99_px, room, glyphs));
  const uint16_t expected[] = {0, 4, 2, 7};  // offsets from left to right
  CHECK_EQ(glyphs.size, 4);
  for (size_t i = 0; i != 4; ++i) {
    CHECK_EQ(glyphs[i].offset, expected[i]);
  }
}

TEST(carets_and_hits_agree) {
  const Setting setting;
  const TextBox box = setting.box({3, 2, 23, 60});
  const Text text = "AB CC";
  CHECK_EQ(box.caret(text, {}, {0, false}).x0, 3);
  CHECK_EQ(box.caret(text, {}, {1, false}).x0, 3 + 7);
  CHECK_EQ(box.caret(text, {}, {3, false}).x0, 3);
  CHECK_EQ(box.caret(text, {}, {3, false}).y0,
           2 + line_height(box.options).floor());
  CHECK_EQ(box.hit(text, {}, 0, 0).offset, 0);
  CHECK_EQ(box.hit(text, {}, 3 + 9, 3).offset, 1);
  CHECK_EQ(box.hit(text, {}, 3 + 13, 3).offset, 2);
  CHECK_EQ(box.hit(text, {}, 99, 99).offset, 5);
  // A word that breaks: its place stands at the end of a line, or at the start
  // of the next.
  const Text word = "ABAB";
  const TextPlace place = box.hit(word, {}, 3 + 16, 3);
  CHECK_EQ(place.offset, 2);
  CHECK(place.is_line_end);
  CHECK_EQ(box.caret(word, {}, place).x0, 3 + 15);
  CHECK_EQ(box.caret(word, {}, {2, false}).x0, 3);
}

// A stands in the first face, the Hebrew letter in the second one, that is half
// as large; a letter that no face has becomes .notdef of the first.
TEST(faces_fall_back) {
  const Font sample = sample_rom::sample();
  const Setting setting;
  Style small(5_px, kFilterText);
  const Face fallback[] = {{&setting.font, &small}};
  LayoutOptions options(sample, setting.style);
  options.fallback = fallback;
  const Text text = "A\xd7\x90Z";
  TextLine line;
  CHECK(next_line(options, {}, text, 100_px, line));
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  CHECK_OK(lay_out(options, {}, text, line, 100_px, room, glyphs));
  CHECK_EQ(glyphs.size, 3);
  CHECK_EQ(glyphs[0].face, 0);
  CHECK_EQ(glyphs[1].face, 1);
  CHECK_EQ(glyphs[1].offset, 1);
  CHECK_EQ(glyphs[2].face, 0);
  CHECK_EQ(glyphs[2].glyph, 0);
  CHECK_EQ(glyphs[2].offset, 3);
  CHECK_EQ(glyphs[2].x - glyphs[1].x, 750 / 2);
}

TEST(labels_scroll) {
  const Setting setting;
  const LayoutOptions options(setting.font, setting.style);
  PositionedGlyph room[8];
  ScrollingLabel label;
  CHECK_EQ(ScrollingLabel::make(options, {}, "CCCCCCCC", {0, 0, 20, 12},
                                {room, 7}, label),
           Status::buffer_small);
  CHECK_OK(
      ScrollingLabel::make(options, {}, "CACAC", {1, 0, 21, 12}, room, label));
  CHECK(label.needs_scrolling());
  Picture<22, 12> picture;
  label.draw_endless(Q26_6::from_int(-10), 4_px, picture.sink());
  CHECK_PICTURE_AT(picture, 2, 2,
                   ".:::.......:::...++\n"
                   ":##:......:##:..+##\n"
                   ":##:......:##:.:###\n"
                   ":##:......:##:.:###\n"
                   ":##:......:##:..*##\n"
                   ":##:......:##:..:*#\n"
                   ":**:......:**:....:\n");
}

TEST(a_label_that_fits_is_not_cut) {
  const Font font = open_overhanging();
  const Style style(10_px, kFilterText);
  LayoutOptions options(font, style);
  options.line_height = 4_px;
  PositionedGlyph room[8];
  ScrollingLabel label;
  CHECK_OK(ScrollingLabel::make(options, {}, "A", {3, 8, 6, 12}, room, label));
  static Picture<20, 20> whole, drawn, scrolled;
  inkcell::Painter(whole.sink()).text(font, style, {3, 13}, "A");
  label.draw({}, drawn.sink());
  CHECK_EQ(whole.ink(), drawn.ink());
  label.draw(1_px, scrolled.sink());
  CHECK(scrolled.ink() <= 12 * 255);
}

TEST(screens_have_paragraphs_and_labels) {
  const Setting setting;
  static Screen screen;
  CHECK_OK(make_screen(setting.font, setting.style, screen));
  Ink ink;
  draw_screen(screen, 40, ink.sink({0, 0, 128, 64}));
  CHECK(ink.box.y0 >= 4 && ink.box.y0 < 16);
  CHECK(ink.box.y1 > 49 && ink.box.y1 <= 64);
  // The same with Bidi: the text is from left to right.
  static uint16_t cells[256];  // one for each byte of the longest paragraph
  static Bidi bidi(cells);
  TextBox box = screen.box;
  const size_t lines = box.measure("A paragraph that wraps", {}).lines;
  box.options.set_bidi(bidi);
  CHECK_EQ(box.measure("A paragraph that wraps", {}).lines, lines);
}
