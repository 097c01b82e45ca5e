// Layout: places where lines end, boxes, labels, carets, directions.
#include "check.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/layout/text_box.hpp"
#include "layout_font.hpp"
#include "picture.hpp"

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
    CHECK(next_line(options, text, Q26_6::from_int(px), line));
    CHECK_EQ(line.end(), wanted.end);
    CHECK_EQ(line.next, wanted.next);
  }
  CHECK(!next_line(options, text, Q26_6::from_int(px), line));
}

// What docs/LAYOUT.md shows.
struct Screen {
  TextBox box;
  ScrollingLabel label;
  PositionedGlyph glyphs[64];
};

Status make_screen(const Font& font, const Style& style, Screen& out) {
  out.box = TextBox(font, style, {4, 4, 124, 44}, Align::centre);
  return ScrollingLabel::make(out.box.options, "Now playing: a long title",
                              {0, 48, 128, 64}, out.glyphs, out.label);
}

void draw_screen(const Screen& screen, int32_t scroll_px, const Sink& sink) {
  screen.box.draw("A paragraph that wraps, and is centred.", sink);
  screen.label.draw_endless(Q26_6::from_int(scroll_px), 16_px, sink);
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
  CHECK(next_line(options, "AB   ", Q26_6::from_int(99), line));
  CHECK_EQ(line.width, 1500);  // without spaces at the end
  options.letter_spacing = Q26_6::from_int(1);
  line = {};
  CHECK(next_line(options, "ABA", Q26_6::from_int(99), line));
  CHECK_EQ(line.width, 3 * 750 + 2 * 100);
  options.letter_spacing = {};
  line = {};
  CHECK(next_line(options,
                  "A\xe2\x80\x8b\xc2\xad\xef\xb8\x8f"
                  "B",
                  Q26_6::from_int(99), line));
  CHECK_EQ(line.width, 1500);  // what has no width adds nothing
}

TEST(soft_hyphens_show_where_lines_end) {
  const Setting setting;
  const LayoutOptions options(setting.font, setting.style);
  TextLine line;
  CHECK(next_line(options,
                  "AB\xc2\xad"
                  "AB",
                  Q26_6::from_int(22), line));
  CHECK(line.has_hyphen);
  CHECK_EQ(line.next, 4);
  CHECK_EQ(line.width, 2 * 750 + 600);
  CHECK(next_line(options,
                  "AB\xc2\xad"
                  "AB",
                  Q26_6::from_int(22), line));
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
  CHECK(next_line(options, text, Q26_6::from_int(99), line));
  CHECK_OK(lay_out(options, text, line, Q26_6::from_int(99), room, glyphs));
  CHECK_EQ(glyphs.size, 3);
  CHECK_EQ(line.width, 3 * 750);
  CHECK_EQ(line.width, measure(setting.font, text).advance);

  const Text hyphenated =
      "AA\xc2\xad"
      "AA";
  line = {};
  CHECK(next_line(options, hyphenated, Q26_6::from_int(16), line));
  CHECK_EQ(line.next, 4);
  CHECK_EQ(line.width, 2 * 750);
  CHECK_OK(
      lay_out(options, hyphenated, line, Q26_6::from_int(16), room, glyphs));
  CHECK_EQ(glyphs.size, 2);

  options.wraps = false;
  const Ellipsis places[] = {Ellipsis::end, Ellipsis::middle};
  for (const Ellipsis place : places) {
    options.ellipsis = place;
    line = {};
    CHECK(next_line(options, "AAAAA", Q26_6::from_int(24), line));
    shorten(options, "AAAAA", Q26_6::from_int(24), line);
    CHECK_OK(
        lay_out(options, "AAAAA", line, Q26_6::from_int(24), room, glyphs));
    CHECK_EQ(glyphs.size, 3);
    for (const PositionedGlyph& glyph : glyphs) {
      CHECK_EQ(glyph.glyph, 1);
    }
  }
}

TEST(tabs_stop) {
  const Setting setting;
  LayoutOptions options(setting.font, setting.style);
  const Q26_6 stops[] = {Q26_6::from_int(12), Q26_6::from_int(15)};
  options.tab_stops = stops;
  options.tab_width = Q26_6::from_int(20);
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  TextLine line;
  const Text text = "A\tB\tC\tC";
  CHECK(next_line(options, text, Q26_6::from_int(99), line));
  CHECK_OK(lay_out(options, text, line, Q26_6::from_int(99), room, glyphs));
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
  CHECK_PICTURE(picture,
                "......................\n"
                "......................\n"
                ".......:::...:::......\n"
                "......:##:..:##:......\n"
                "......:##:..:##:......\n"
                "......:##:..:##:......\n"
                "......:##:..:##:......\n"
                "......:##:..:##:......\n"
                "......:**:..:**:......\n"
                "......................\n"
                "......................\n"
                "......................\n"
                "......................\n"
                "..........:::.........\n"
                ".........:##:.........\n"
                ".........:##:.........\n"
                ".........:##:.........\n"
                ".........:##:.........\n"
                ".........:##:.........\n"
                ".........:**:.........\n");
}

TEST(boxes_justify) {
  const Setting setting;
  static Picture<40, 22> picture;  // stacks of boards have 4 KB
  setting.box({0, 0, 37, 22}, Align::justify).draw("C C C C", picture.sink());
  CHECK_PICTURE(picture,
                "........................................\n"
                "........................................\n"
                "..:::............:::.............:::....\n"
                ".:##:............+#*............:##:....\n"
                ".:##:............+#*............:##:....\n"
                ".:##:............+#*............:##:....\n"
                ".:##:............+#*............:##:....\n"
                ".:##:............+#*............:##:....\n"
                ".:**:............+#*............:**:....\n"
                ".................:......................\n"
                "........................................\n"
                "........................................\n"
                "........................................\n"
                "..:::...................................\n"
                ".:##:...................................\n"
                ".:##:...................................\n"
                ".:##:...................................\n"
                ".:##:...................................\n"
                ".:##:...................................\n"
                ".:**:...................................\n");
}

TEST(boxes_clip_and_shorten) {
  const Setting setting;
  Picture<32, 12> picture;
  TextBox box = setting.box({2, 1, 30, 12});
  box.options.ellipsis = Ellipsis::end;
  box.options.wraps = false;
  box.draw("CCCCCC", picture.sink());
  CHECK_PICTURE(picture,
                "................................\n"
                "................................\n"
                "................................\n"
                "....:::...:::...:::...:::.......\n"
                "...:##:..:##:..:##:..:##:.......\n"
                "...:##:..:##:..:##:..:##:.......\n"
                "...:##:..:##:..:##:..:##:.......\n"
                "...:##:..:##:..:##:..:##:.......\n"
                "...:##:..:##:..:##:..:##:.......\n"
                "...:**:..:**:..:**:..:**:.......\n");
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
  CHECK(next_line(options, text, Q26_6::from_int(99), line));
  CHECK_OK(lay_out(options, text, line, Q26_6::from_int(99), room, glyphs));
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
  CHECK_EQ(box.caret(text, {0, false}).x0, 3);
  CHECK_EQ(box.caret(text, {1, false}).x0, 3 + 7);
  CHECK_EQ(box.caret(text, {3, false}).x0, 3);
  CHECK_EQ(box.caret(text, {3, false}).y0,
           2 + line_height(box.options).floor());
  CHECK_EQ(box.hit(text, 0, 0).offset, 0);
  CHECK_EQ(box.hit(text, 3 + 9, 3).offset, 1);
  CHECK_EQ(box.hit(text, 3 + 13, 3).offset, 2);
  CHECK_EQ(box.hit(text, 99, 99).offset, 5);
  // A word that breaks: its place stands at the end of a line, or at the start
  // of the next.
  const Text word = "ABAB";
  const TextPlace place = box.hit(word, 3 + 16, 3);
  CHECK_EQ(place.offset, 2);
  CHECK(place.is_line_end);
  CHECK_EQ(box.caret(word, place).x0, 3 + 15);
  CHECK_EQ(box.caret(word, {2, false}).x0, 3);
}

// A stands in the first face, the Hebrew letter in the second one, that is half
// as large; a letter that no face has becomes .notdef of the first.
TEST(faces_fall_back) {
  alignas(4) static uint8_t sample_rom[font_builder::kSampleFontBytes];
  const size_t size = font_builder::build_sample_font(sample_rom);
  Font sample;
  CHECK_OK(open_any_font({sample_rom, size}, sample));
  const Setting setting;
  Style small(5_px, kFilterText);
  const Face fallback[] = {{&setting.font, &small}};
  LayoutOptions options(sample, setting.style);
  options.fallback = fallback;
  const Text text = "A\xd7\x90Z";
  TextLine line;
  CHECK(next_line(options, text, Q26_6::from_int(100), line));
  PositionedGlyph room[8];
  Span<const PositionedGlyph> glyphs;
  CHECK_OK(lay_out(options, text, line, Q26_6::from_int(100), room, glyphs));
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
  CHECK_EQ(ScrollingLabel::make(options, "CCCCCCCC", {0, 0, 20, 12}, {room, 7},
                                label),
           Status::buffer_small);
  CHECK_OK(ScrollingLabel::make(options, "CACAC", {1, 0, 21, 12}, room, label));
  CHECK(label.needs_scrolling());
  Picture<22, 12> picture;
  label.draw_endless(Q26_6::from_int(-10), Q26_6::from_int(4), picture.sink());
  CHECK_PICTURE(picture,
                "......................\n"
                "......................\n"
                "...:::.......:::...++.\n"
                "..:##:......:##:..+##.\n"
                "..:##:......:##:.:###.\n"
                "..:##:......:##:.:###.\n"
                "..:##:......:##:..*##.\n"
                "..:##:......:##:..:*#.\n"
                "..:**:......:**:....:.\n");
}

TEST(screens_have_paragraphs_and_labels) {
  const Setting setting;
  static Screen screen;
  CHECK_OK(make_screen(setting.font, setting.style, screen));
  struct Rows {
    int32_t first = INT32_MAX;
    int32_t last = 0;
  } rows;
  Sink sink;
  sink.window = {0, 0, 128, 64};
  sink.context = &rows;
  sink.coverage = [](void* context, int32_t, int32_t y, const uint8_t*,
                     int32_t) {
    Rows& seen = *static_cast<Rows*>(context);
    seen.first = y < seen.first ? y : seen.first;
    seen.last = y > seen.last ? y : seen.last;
  };
  sink.solid = [](void*, int32_t, int32_t, int32_t) {};
  draw_screen(screen, 40, sink);
  CHECK(rows.first >= 4 && rows.first < 16);
  CHECK(rows.last > 48 && rows.last < 64);
  // The same with Bidi: the text is from left to right.
  static uint16_t cells[256];  // one for each byte of the longest paragraph
  static Bidi bidi(cells);
  TextBox box = screen.box;
  const size_t lines = box.measure("A paragraph that wraps").lines;
  box.options.set_bidi(bidi);
  CHECK_EQ(box.measure("A paragraph that wraps").lines, lines);
}
