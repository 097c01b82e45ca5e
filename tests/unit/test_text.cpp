// Text: UTF-8, layout, measures, and drawing runs.
#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/painter.hpp"

#include "check.hpp"
#include "ink.hpp"
#include "picture.hpp"
#include "random.hpp"
#include "sample_rom.hpp"

namespace {

using namespace inkcell;
using sample_rom::rom;
using sample_rom::sample;

// Whether `bytes` read as `expected`, a list closed by kEnd.
constexpr uint32_t kEnd = 0xffffffff;
constexpr uint32_t kBad = 0xfffd;

bool reads_as(Text text, const uint32_t* expected) {
  while (text.size > 0) {
    const char* begin = text.data;
    const size_t size = text.size;
    if (next_code_point(text) != *expected++) {
      return false;
    }
    if (text.data <= begin ||
        static_cast<size_t>(text.data - begin) != size - text.size) {
      return false;
    }
  }
  return *expected == kEnd;
}

template <size_t kSize, size_t kCount>
void check_reads(const char (&bytes)[kSize],
                 const uint32_t (&expected)[kCount]) {
  CHECK(reads_as({bytes, kSize - 1}, expected));
}

// What two bytes must read as, written out from Unicode's table 3-7.
size_t expect_pair(uint32_t first, uint32_t second, uint32_t* out) {
  const bool second_follows = second >= 0x80 && second <= 0xbf;
  if (first >= 0xc2 && first <= 0xdf && second_follows) {
    out[0] = (first & 0x1f) << 6 | (second & 0x3f);
    return 1;
  }
  // A longer sequence whose second byte is allowed: one truncated whole.
  const bool truncated =
      (first == 0xe0 && second >= 0xa0 && second <= 0xbf) ||
      (first >= 0xe1 && first <= 0xef && first != 0xed && second_follows) ||
      (first == 0xed && second >= 0x80 && second <= 0x9f) ||
      (first == 0xf0 && second >= 0x90 && second <= 0xbf) ||
      (first >= 0xf1 && first <= 0xf3 && second_follows) ||
      (first == 0xf4 && second >= 0x80 && second <= 0x8f);
  if (truncated) {
    out[0] = kBad;
    return 1;
  }
  out[0] = first < 0x80 ? first : kBad;
  out[1] = second < 0x80 ? second : kBad;
  return 2;
}

size_t encode(uint32_t code_point, char* out) {
  const auto byte = [](uint32_t value) { return static_cast<char>(value); };
  if (code_point < 0x80) {
    out[0] = byte(code_point);
    return 1;
  }
  size_t size = code_point < 0x800 ? 2 : code_point < 0x10000 ? 3 : 4;
  for (size_t i = size - 1; i > 0; --i) {
    out[i] = byte(0x80 | (code_point & 0x3f));
    code_point >>= 6;
  }
  const uint32_t leads[] = {0xc0, 0xe0, 0xf0};
  out[0] = byte(leads[size - 2] | code_point);
  return size;
}

Style style_of(int32_t px) {
  return Style(Q26_6::from_int(px), kFilterText);
}

}  // namespace

TEST(what_shows_nothing_needs_no_glyph) {
  constexpr uint32_t kNothing[] = {0x9,    0xa,    0x20,   0xa0,   0xad,
                                   0x200b, 0x2003, 0xfe0f, 0xe0020};
  for (const uint32_t c : kNothing) {
    CHECK(!needs_glyph(c));
  }
  constexpr uint32_t kShown[] = {0x21, 0x41,   0x7e,   0xac,
                                 0xae, 0x2010, 0xe000, 0x1f600};
  for (const uint32_t c : kShown) {
    CHECK(needs_glyph(c));
  }
}

TEST(reads_well_formed_text) {
  check_reads("Az", {'A', 'z', kEnd});
  check_reads("\x7f\xc2\x80", {0x7f, 0x80, kEnd});
  check_reads("\xdf\xbf\xe0\xa0\x80", {0x7ff, 0x800, kEnd});
  check_reads("\xed\x9f\xbf\xee\x80\x80", {0xd7ff, 0xe000, kEnd});
  check_reads("\xef\xbf\xbf\xf0\x90\x80\x80", {0xffff, 0x10000, kEnd});
  check_reads("\xf4\x8f\xbf\xbf", {0x10ffff, kEnd});
  check_reads("\0", {0, kEnd});
}

// Unicode 15, tables 3-8 to 3-11.
TEST(replaces_maximal_parts) {
  check_reads("\xc0\xaf\xe0\x80\xbf\xf0\x81\x82\x41",
              {kBad, kBad, kBad, kBad, kBad, kBad, kBad, kBad, 'A', kEnd});
  check_reads("\xed\xa0\x80\xed\xbf\xbf\xed\xaf\x41",
              {kBad, kBad, kBad, kBad, kBad, kBad, kBad, kBad, 'A', kEnd});
  check_reads("\xf4\x91\x92\x93\xff\x41\x80\xbf\x42",
              {kBad, kBad, kBad, kBad, kBad, 'A', kBad, kBad, 'B', kEnd});
  check_reads("\xe1\x80\xe2\xf0\x91\x92\xf1\xbf\x41",
              {kBad, kBad, kBad, kBad, 'A', kEnd});
}

TEST(replaces_truncated_and_overlong_forms) {
  check_reads("\xe2\x82", {kBad, kEnd});
  check_reads("\xe2", {kBad, kEnd});
  check_reads("\xf0\x9f\x98", {kBad, kEnd});
  check_reads("\xf0\x9f\x98\x41", {kBad, 'A', kEnd});
  check_reads("\xf0\x9f\x41", {kBad, 'A', kEnd});
  check_reads("\xc1\xbf", {kBad, kBad, kEnd});
  check_reads("\xe0\x9f\xbf", {kBad, kBad, kBad, kEnd});
  check_reads("\xf0\x8f\xbf\xbf", {kBad, kBad, kBad, kBad, kEnd});
  check_reads("\xf5\x80\x80\x80", {kBad, kBad, kBad, kBad, kEnd});
  check_reads("\xfe\xff", {kBad, kBad, kEnd});
}

TEST(reads_every_pair_of_bytes) {
  for (uint32_t first = 0; first < 256; ++first) {
    for (uint32_t second = 0; second < 256; ++second) {
      const char bytes[] = {static_cast<char>(first),
                            static_cast<char>(second)};
      uint32_t expected[3];
      expected[expect_pair(first, second, expected)] = kEnd;
      CHECK(reads_as({bytes, 2}, expected));
    }
  }
}

// All of them on the host; on slow boards a step that is prime to 64.
TEST(reads_every_code_point) {
  const uint32_t step = INKCELL_BOARD_FIRMWARE ? 37 : 1;
  for (uint32_t code_point = 0; code_point <= 0x10ffff; code_point += step) {
    const bool surrogate = code_point >= 0xd800 && code_point <= 0xdfff;
    char bytes[4];
    const size_t size = encode(code_point, bytes);
    const uint32_t expected[] = {code_point, kEnd};
    CHECK(reads_as({bytes, size}, expected) == !surrogate);
    for (size_t part = 1; part < size && !surrogate; ++part) {
      const uint32_t bad[] = {kBad, kEnd};
      CHECK(reads_as({bytes, part}, bad));
    }
  }
}

TEST(lays_out_and_kerns) {
  const Font font = sample();
  PositionedGlyph buffer[8];
  Span<const PositionedGlyph> run;
  CHECK_OK(Painter().lay_out(font, Style(), "AB AC", buffer, run));
  const int32_t expected_x[] = {0, 650, 1350, 1650, 2400};
  const uint16_t expected_glyph[] = {2, 3, 1, 2, 4};
  CHECK_EQ(run.size, 5);
  CHECK(run.data == buffer);
  for (size_t i = 0; i < run.size && i < 5; ++i) {
    CHECK_EQ(run[i].x, expected_x[i]);
    CHECK_EQ(run[i].y, 0);
    CHECK_EQ(run[i].glyph, expected_glyph[i]);
  }
}

TEST(absent_code_points_become_notdef) {
  const Font font = sample();
  PositionedGlyph buffer[4];
  Span<const PositionedGlyph> run;
  CHECK_OK(
      Painter().lay_out(font, Style(), "a\xff\xf0\x9f\x98\x80", buffer, run));
  CHECK_EQ(run.size, 3);
  CHECK_EQ(run[0].glyph, 0);
  CHECK_EQ(run[1].glyph, 0);
  CHECK_EQ(run[2].glyph, 3);
  CHECK_EQ(run[2].x, 1200);
}

// A, what shows nothing, B: kerned as if they stood side by side; glyphs know
// where their text begins.
TEST(blanks_never_become_notdef) {
  const Font font = sample();
  const Text nothing[] = {"A\nB",
                          "A\rB",
                          "A\x7f"
                          "B",
                          "A\xc2\xad"
                          "B",
                          "A\xe2\x80\x8b"
                          "B",
                          "A\xe2\x80\xa8"
                          "B",
                          "A\xef\xb8\x8f"
                          "B",
                          "A\xef\xbb\xbf"
                          "B"};
  PositionedGlyph buffer[3];
  Span<const PositionedGlyph> run;
  for (const Text& text : nothing) {
    CHECK_OK(Painter().lay_out(font, Style(), text, buffer, run));
    CHECK_EQ(run.size, 2);
    CHECK_EQ(run[1].glyph, 3);
    CHECK_EQ(run[1].x, 650);
    CHECK_EQ(run[1].offset, text.size - 1);
  }
  const Text spaces[] = {"A\tB",
                         "A\xc2\xa0"
                         "B"};
  for (const Text& text : spaces) {
    CHECK_OK(Painter().lay_out(font, Style(), text, buffer, run));
    CHECK_EQ(run.size, 3);
    CHECK_EQ(run[1].glyph, 1);
    CHECK_EQ(run[2].x, 750 + 300);
  }
}

namespace {

// A font of A and B alone.
Font letters_only() {
  static constexpr font_builder::CmapEntry kCmap[] = {{'A', 1, 1}};
  static constexpr font_builder::GlyphSpec kGlyphs[] = {
      {600, {195, 0, 430, 625}, font_builder::bar, nullptr},
      {750, {82, 82, 668, 668}, font_builder::disc, nullptr},
      {700, {121, 121, 629, 629}, font_builder::ring, nullptr}};
  font_builder::FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {kGlyphs, 3};
  Font font;
  const size_t size = font_builder::build_font(spec, rom);
  CHECK_OK(open_any_font({rom, size}, font));
  return font;
}

}  // namespace

TEST(marks_never_become_notdef) {
  const Font font = letters_only();
  const uint32_t marks[] = {0x300,  0x307,  0x336,  0x338,  0x36f,  0x489,
                            0x591,  0x5bd,  0x5bf,  0x5c7,  0x64b,  0x670,
                            0x6ed,  0xe31,  0xe47,  0x1ab0, 0x1dff, 0x20dd,
                            0x20e3, 0x2dff, 0x302d, 0x3099, 0xfe20, 0xfe2f};
  PositionedGlyph buffer[3];
  Span<const PositionedGlyph> run;
  for (const uint32_t mark : marks) {
    char text[8] = {'A'};
    const size_t size = 1 + encode(mark, text + 1);
    text[size] = 'B';
    CHECK_OK(Painter().lay_out(font, Style(), {text, size + 1}, buffer, run));
    CHECK_EQ(run.size, 2);
    CHECK_EQ(run[1].x, 750);
  }
  // Punctuation between them, and letters beside them, are no marks.
  const uint32_t others[] = {0x2ff, 0x370, 0x5be, 0x5c0, 0x5d0, 0x6dd, 0xe32};
  for (const uint32_t other : others) {
    char text[4] = {};
    CHECK_OK(Painter().lay_out(font, Style(), {text, encode(other, text)},
                               buffer, run));
    CHECK_EQ(run.size, 1);
    CHECK_EQ(run[0].glyph, 0);
  }
}

TEST(notdef_kerns_like_any_glyph) {
  const Font font = sample();
  CHECK_EQ(font.kerning(0, 3), 0);
  // The first glyph's left class, behind its number: that of A.
  const Span<const uint8_t> section = font.section(format::section::kKerning);
  uint8_t* const members = rom + (section.data - rom) + format::kerning::kBytes;
  members[1] = 1;
  CHECK_EQ(font.kerning(0, 3), -100);
  PositionedGlyph buffer[2];
  Span<const PositionedGlyph> run;
  CHECK_OK(Painter().lay_out(font, Style(), "aB", buffer, run));
  CHECK_EQ(run[1].glyph, 3);
  CHECK_EQ(run[1].x, 600 - 100);
}

TEST(layout_needs_room) {
  const Font font = sample();
  PositionedGlyph buffer[3];
  buffer[2].glyph = 77;
  Span<const PositionedGlyph> run(buffer + 1, 1);
  CHECK_EQ(Painter().lay_out(font, Style(), "ABC", {buffer, 2}, run),
           Status::buffer_small);
  CHECK_EQ(run.size, 1);  // untouched
  CHECK_EQ(buffer[2].glyph, 77);
  CHECK_OK(Painter().lay_out(font, Style(), "ABC", buffer, run));
  CHECK_EQ(run.size, 3);
  CHECK_OK(Painter().lay_out(font, Style(), "", {}, run));
  CHECK_EQ(run.size, 0);
  CHECK_EQ(Painter().lay_out(font, Style(), "A", {}, run),
           Status::buffer_small);
}

TEST(measures_lines) {
  const Font font = sample();
  const TextMeasure line = measure(font, "AB AC");
  CHECK_EQ(line.advance, 2400 + 625);
  CHECK_EQ(line.x_min, 82);
  CHECK_EQ(line.y_min, 0);
  CHECK_EQ(line.x_max, 2400 + 430);
  CHECK_EQ(line.y_max, 668);
  const TextMeasure spaces = measure(font, "  ");
  CHECK_EQ(spaces.advance, 600);
  CHECK(spaces.x_max <= spaces.x_min);
  const TextMeasure nothing = measure(font, "");
  CHECK_EQ(nothing.advance, 0);
  const TextMeasure empty = measure(Font{}, "AB");
  CHECK_EQ(empty.advance, 0);
}

TEST(lines_may_lie_anywhere) {
  const Font font = sample();
  CHECK_EQ(measure(font, "A").y_min, 82);
  // The row of A, behind its advance: left, lower, right and upper end.
  const Span<const uint8_t> section = font.section(format::section::kMetrics);
  uint8_t* const row = rom + (section.data - rom) + format::metrics::kBytes +
                       2 * 2 * format::metrics::kColumns;
  constexpr int16_t kSides[] = {-400, -200, -300, -100};
  for (int i = 0; i < 4; ++i) {
    font_builder::put_u16(row + 2 + 2 * i, static_cast<uint16_t>(kSides[i]));
  }
  CHECK_EQ(measure(font, "A").x_min, -400);
  CHECK_EQ(measure(font, "A").y_min, -200);
  CHECK_EQ(measure(font, "A").x_max, -300);
  CHECK_EQ(measure(font, "A").y_max, -100);
}

// Up to 2^19 units half of 1/64 px, and what 16 fractional bits of the scale
// add; at the end of the range one more half.
TEST(lengths_in_px_round_to_the_nearest) {
  const Font font = sample();
  Random random(6);
  for (const int32_t px : each_of({4, 12, 17, 1024})) {
    const Style style = style_of(px);
    for (int i = 0; i < 600; ++i) {
      const int32_t limit = (i & 1) != 0 ? 1 << 19 : 1 << 24;
      const double bound = (i & 1) != 0 ? 0.55 : 1.05;
      const int32_t units = random.between(-limit, limit);
      const double exact = units * (px * 64.0) / 1000.0;
      const double error = exact - to_px(font, style, units).raw;
      CHECK(error <= bound && error >= -bound);
    }
    CHECK_EQ(to_px(font, style, 1000).raw, px * 64);
    CHECK_EQ(to_px(font, style, INT32_MAX).raw,
             to_px(font, style, 1 << 24).raw);
    CHECK_EQ(to_px(font, style, INT32_MIN).raw,
             to_px(font, style, -(1 << 24)).raw);
  }
}

TEST(long_lines_end_at_the_limit) {
  const Font font = sample();
  const Span<const uint8_t> metrics = font.section(format::section::kMetrics);
  // The builder's rows are 16 bits a column.
  constexpr uint32_t kRow = 2 * format::metrics::kColumns;
  font_builder::put_u16(
      rom + (metrics.data - rom) + format::metrics::kBytes + 2 * kRow,
      65535);  // the advance of A
  static char text[300];
  for (char& c : text) {
    c = 'A';
  }
  TextCursor cursor(font, {text, sizeof(text)});
  PositionedGlyph glyph;
  int32_t last = 0;
  while (cursor.next(glyph)) {
    CHECK(glyph.x >= last && glyph.x <= 1 << 24);
    last = glyph.x;
  }
  CHECK_EQ(cursor.advance(), 1 << 24);  // 300 times 65535 are more
  CHECK(!cursor.next(glyph));
  CHECK_EQ(measure(font, {text, sizeof(text)}).advance, 1 << 24);
  // A report tells of it.
  const Sink sink;
  TextReport report;
  const Painter painter(sink, {}, nullptr, &report);
  Painter(painter).measure(font, style_of(20), {text, 200});
  CHECK_EQ(report.status, Status::ok);
  painter.measure(font, style_of(20), {text, sizeof(text)});
  CHECK_EQ(report.status, Status::cut);
}

TEST(a_run_is_its_glyphs) {
  const Font font = sample();
  const Style style = style_of(20);
  PositionedGlyph buffer[8];
  Span<const PositionedGlyph> run;
  CHECK_OK(Painter().lay_out(font, Style(), "AB C", buffer, run));
  Ink whole;
  Painter(whole.sink()).glyphs(font, style, {3, 40}, run);
  Ink streamed;
  Painter(streamed.sink()).text(font, style, {3, 40}, "AB C");
  CHECK(whole == streamed);
  Ink single;
  for (const PositionedGlyph& glyph : run) {
    GlyphField field;
    CHECK_OK(read_field(font, glyph.glyph, field));
    // 20 px to 1000 units, in Q10: 20.48 to the unit.
    const FinePoint origin(3 * 1024 + (int64_t{glyph.x} * 2048 + 50) / 100,
                           40 * 1024);
    draw_field(field, style, origin, single.sink());
  }
  CHECK(whole == single);
  Ink alone;
  Painter(alone.sink()).glyph(font, style, {3, 40}, 2);
  Ink first;
  Painter(first.sink()).glyphs(font, style, {3, 40}, {buffer, 1});
  CHECK(alone.sum > 0);
  CHECK(alone == first);
}

TEST(positions_in_a_run_go_up) {
  const Font font = sample();
  const Style style = style_of(10);
  PositionedGlyph glyph;
  glyph.glyph = 2;
  glyph.x = 1000;
  glyph.y = 500;
  Ink raised;
  Painter(raised.sink()).glyphs(font, style, {0, 20}, {&glyph, 1});
  Ink plain;
  Painter(plain.sink()).glyph(font, style, {10, 15}, 2);
  CHECK(raised == plain);
}

TEST(turned_runs_follow_their_direction) {
  const Font font = sample();
  Direction up;  // to the top of the screen
  up.cosine.raw = 0;
  up.sine.raw = 1 << 30;
  Style style(20_px, kFilterText, up);
  PositionedGlyph glyph;
  glyph.glyph = 2;
  glyph.x = 1000;
  Ink moved;
  Painter(moved.sink()).glyphs(font, style, {50, 50}, {&glyph, 1});
  Ink plain;
  Painter(plain.sink()).glyph(font, style, {50, 30}, 2);
  CHECK(plain.sum > 0);
  CHECK(moved == plain);
}

TEST(absent_glyphs_are_left_out) {
  const Font font = sample();
  const Style style = style_of(20);
  Ink ink;
  Painter(ink.sink()).glyph(font, style, {0, 0}, 1);
  Painter(ink.sink()).glyph(font, style, {0, 0}, 5);
  Painter(ink.sink()).glyph(font, style, {0, 0}, 65535);
  Painter(ink.sink()).text(Font{}, style, {0, 0}, "AB");
  Painter(ink.sink()).text(font, style, {0, 0}, "");
  CHECK_EQ(ink.sum, 0);
}

TEST(draws_text_as_expected) {
  const Font font = sample();
  const Style style = style_of(12);
  Picture<24, 10> picture;
  picture.next_glyph();
  Painter(picture.sink()).text(font, style, {1, 9}, "AB");
  CHECK_PICTURE(picture,
                ".....:..................\n"
                "...+*#*+...:++:.........\n"
                "..+#####+.:*#*#+........\n"
                "..*#####*.+*:.+#:.......\n"
                ".:#######:*+..:#+.......\n"
                "..*#####*.+*:.+#:.......\n"
                "..+#####+.:*#*#+........\n"
                "...+*#*+...:++:.........\n"
                ".....:..................\n");
}

// 2^22 px are 2^32 / 1024.
TEST(positions_do_not_wrap) {
  const Font font = sample();
  const Style style = style_of(1000);  // a unit is a px
  const Point origin = {-355, 395};
  PositionedGlyph glyph;
  glyph.glyph = 2;
  for (const int32_t x : each_of({0, 1 << 22, -(1 << 22)})) {
    glyph.x = x;
    Ink ink;
    const Sink sink = ink.sink({0, 0, 40, 40});
    Painter(sink).glyphs(font, style, origin, {&glyph, 1});
    CHECK_EQ(ink.sum > 0, x == 0);
    ink.sum = 0;
    Painter(sink).glyph(font, style,
                        {Q26_6::from_raw(origin.x.raw + x * 64), origin.y}, 2);
    CHECK_EQ(ink.sum > 0, x == 0);
  }
}

TEST(far_positions_are_harmless) {
  const Font font = sample();
  const int32_t ends[] = {INT32_MIN, INT32_MIN / 2, INT32_MAX / 2, INT32_MAX};
  for (const int32_t px : each_of({4, 1024})) {
    const Style style = style_of(px);
    for (const int32_t x : ends) {
      for (const int32_t y : ends) {
        Ink ink;
        PositionedGlyph glyph;
        glyph.glyph = 2;
        glyph.x = x;
        glyph.y = static_cast<int16_t>(y);
        const Point origin = {Q26_6::from_raw(y), Q26_6::from_raw(x)};
        Painter(ink.sink()).glyphs(font, style, origin, {&glyph, 1});
        CHECK_EQ(ink.sum, 0);
      }
    }
  }
}
