// Glyphs of outlines as pictures, and what must not change them.
#include "check.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/stroke.hpp"
#include "outline_record.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;
using outline_record::corner;
using outline_record::off;
using outline_record::OutlinePoint;
using outline_record::OutlineSource;
using outline_record::start;

alignas(4) uint8_t rom[1024];
alignas(8) uint8_t ram[2560];

// In units of 1/1024 em, at 16 px a px is 64.
constexpr OutlinePoint kSquare[] = {
    {start, 96, 96}, {corner, 480, 96}, {corner, 480, 480}, {corner, 96, 480}};
constexpr OutlinePoint kRing[] = {
    {start, 704, 352}, {off, 704, 704},   {off, 0, 704},   {off, 0, 0},
    {off, 704, 0},     {start, 224, 352}, {off, 224, 480}, {off, 480, 480},
    {off, 480, 224},   {off, 224, 224}};
// The ring, and two squares turned by 90 and 180 degrees; and the same as an
// outline.
constexpr outline_record::Component kParts[] = {
    {2, 0, 0},
    {1, 1300, 0, true, {0, -16384, 16384, 0}},
    {1, 1000, 988, true, {-8192, 0, 0, -8192}}};
constexpr OutlinePoint kWhole[] = {
    {start, 704, 352},   {off, 704, 704},    {off, 0, 704},
    {off, 0, 0},         {off, 704, 0},      {start, 224, 352},
    {off, 224, 480},     {off, 480, 480},    {off, 480, 224},
    {off, 224, 224},     {start, 820, 96},   {corner, 1204, 96},
    {corner, 1204, 480}, {corner, 820, 480}, {start, 760, 748},
    {corner, 952, 748},  {corner, 952, 940}, {corner, 760, 940}};

enum Glyph : uint16_t { square = 1, ring, parts, whole };

Font open() {
  const OutlineSource glyphs[] = {{600},
                                  {600, {kSquare, 4}},
                                  {720, {kRing, 10}},
                                  {1300, {}, {kParts, 3}, {0, 0, 1204, 940}},
                                  {1300, {kWhole, 18}}};
  const size_t size = outline_record::build_outline_font({glyphs, 5}, 0, 'A',
                                                         {rom, sizeof(rom)});
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  CHECK_OK(font.verify());
  return font;
}

constexpr Point at(int32_t x_q6, int32_t y_q6) {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

Style text_style(int32_t px = 16) {
  return Style(Q26_6::from_int(px), kFilterText);
}
Style area_style(int32_t px = 16) {
  return Style(Q26_6::from_int(px), kFilterArea);
}
constexpr Filter kWide =
    make_filter({Q6_10::from_raw(-3000), Q6_10::from_raw(2000)});

// The triangle of sides 3, 4 and 5.
Direction turned() {
  Direction direction;
  direction.cosine.raw = 858993459;
  direction.sine.raw = -644245094;
  return direction;
}

template <int32_t kWidth, int32_t kHeight>
void draw(Picture<kWidth, kHeight>& picture,
          uint16_t glyph,
          const Style& style,
          Point origin) {
  Painter(picture.sink()).glyph(open(), style, origin, glyph);
}

// At 16 px, and mirrored.
constexpr const char* kRingByArea =
    "..::+++::...\n"
    ".:*#####*:..\n"
    ":*#######*:.\n"
    "+####*####+.\n"
    "*##*:::*##*.\n"
    "*##+...+##*.\n"
    "*##+...+##*.\n"
    "*##*:::*##*.\n"
    "+#########+.\n"
    ":*#######*:.\n"
    ".:*#####*:..\n"
    "..::+++::...\n";

// In the middle of the sheet below.
constexpr Point kMiddle = at(5 * 64 + 21, 27 * 64 + 37);

constexpr int32_t kSide = 40;
constexpr Rect kAll = {-3, -2, -3 + kSide, -2 + kSide};
Picture<kSide, kSide> picture(kAll.x0, kAll.y0);
Picture<kSide, kSide> expected(kAll.x0, kAll.y0);

void draw_whole(const Font& font, uint16_t glyph, const Style& style) {
  picture.clear();
  Painter(picture.sink()).glyph(font, style, kMiddle, glyph);
}

// Every style that outlines have.
struct Styles {
  static constexpr int32_t kCount = 9;
  Style styles[kCount];
  Stroke stroke{kFilterText, Q6_10::from_raw(900), StrokePlace::inner};
  Lcd lcd{SubPixels::rgb, 200};
  Bilevel bilevel;

  Styles() {
    styles[0] = text_style();
    styles[1] = area_style();
    styles[2] = Style(16_px, kWide);
    styles[3] = Style(14_px, kFilterText, turned());
    styles[4] = Style(14_px, kFilterArea, turned());
    styles[5] = Style(14_px, kWide, turned());
    styles[6] = text_style();
    styles[6].set_effect(stroke);
    styles[7] = text_style();
    styles[7].set_effect(lcd);
    styles[8] = text_style();
    styles[8].set_effect(bilevel);
  }
};

}  // namespace

TEST(a_square_by_distance_and_area) {
  Picture<9, 9> by_distance;
  draw(by_distance, square, text_style(), at(0, 8 * 64));
  CHECK_PICTURE(by_distance,
                ".+++++++.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+++++++.\n");
  Picture<9, 9> by_area;
  draw(by_area, square, area_style(), at(0, 8 * 64));
  CHECK_PICTURE(by_area,
                ".:+++++:.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".+#####+.\n"
                ".:+++++:.\n");
}

TEST(a_ring_by_distance_and_area) {
  Picture<12, 12> by_distance;
  draw(by_distance, ring, text_style(), at(0, 11 * 64 + 32));
  CHECK_PICTURE(by_distance,
                "...:+++:....\n"
                ".:*#####*:..\n"
                ":#########:.\n"
                "+####*####+.\n"
                "*##*:.:*##*.\n"
                "*##+...+##*.\n"
                "*##+...+##*.\n"
                "*##*:::*##*.\n"
                "+#########+.\n"
                ":#########:.\n"
                ".:*#####*:..\n"
                "...:+++:....\n");
  Picture<12, 12> by_area;
  draw(by_area, ring, area_style(), at(0, 11 * 64 + 32));
  CHECK_PICTURE(by_area, kRingByArea);
}

TEST(a_wide_filter_reaches_far) {
  Picture<16, 16> soft;
  Style style(16_px, kWide);
  draw(soft, square, style, at(4 * 64, 12 * 64));
  CHECK_PICTURE_AT(soft, 3, 2,
                   ":::::::::::\n"
                   "::+++++++::\n"
                   ":+++++++++:\n"
                   ":++*****++:\n"
                   ":++*###*++:\n"
                   ":++*###*++:\n"
                   ":++*###*++:\n"
                   ":++*****++:\n"
                   ":+++++++++:\n"
                   "::+++++++::\n"
                   ":::::::::::\n");
}

TEST(a_turned_square_and_a_mirrored_one) {
  Picture<14, 12> leaning;
  Style style(16_px, kFilterText, turned());
  draw(leaning, square, style, at(64, 64 * 6));
  CHECK_PICTURE(leaning,
                "......:.......\n"
                "......*+......\n"
                ".....+##*:....\n"
                "....:####*:...\n"
                "...:*######+..\n"
                "...*######*...\n"
                "...:*####*:...\n"
                ".....+###:....\n"
                "......:*+.....\n"
                ".......:......\n");
  const auto px = [](int32_t whole) { return Q16_16::from_raw(whole * 65536); };
  Picture<12, 12> mirrored;
  style = Style({px(-16), px(0), px(0), px(16)}, kFilterArea);
  draw(mirrored, ring, style, at(11 * 64, 11 * 64 + 32));
  CHECK_PICTURE(mirrored, kRingByArea);
}

TEST(windows_leave_the_picture) {
  const Font font = open();
  Styles styles;
  for (const Style& style : styles.styles) {
    for (uint16_t glyph = square; glyph <= whole; ++glyph) {
      draw_whole(font, glyph, style);
      CHECK(picture.ink() > 0);
      expected = picture;
      for (int32_t cut = 3; cut < kSide; cut += 9) {
        picture.clear();
        bool is_left = false;
        picture.draw_parts(cut, cut, [&](const Sink& sink) {
          is_left = !is_left;
          Painter(sink, is_left ? Workspace(ram, 900) : Workspace())
              .glyph(font, style, kMiddle, glyph);
        });
        CHECK(picture == expected);
      }
    }
  }
}

TEST(workspaces_leave_the_picture) {
  const Font font = open();
  Styles styles;
  for (const Style& style : styles.styles) {
    draw_whole(font, whole, style);
    expected = picture;
    const size_t sizes[] = {0, 1, 3, 791, 792, 867, 868, 1500, sizeof(ram) - 3};
    for (const size_t size : sizes) {
      for (uint32_t odd = 0; odd < 4; ++odd) {
        picture.clear();
        picture.draw_strips(13, [&](const Sink& sink) {
          for (uint8_t& byte : ram) {
            byte = 0x5a;  // its content has no meaning
          }
          Painter(sink, {ram + odd, size}).glyph(font, style, kMiddle, whole);
        });
        CHECK(picture == expected);
      }
    }
  }
}

TEST(composites_equal_their_parts) {
  const Font font = open();
  Styles styles;
  for (const Style& style : styles.styles) {
    draw_whole(font, whole, style);
    expected = picture;
    draw_whole(font, parts, style);
    // Points of parts that are mapped are rounded.
    CHECK(picture.difference(expected) <= 2);
  }
}

TEST(a_prepared_glyph_is_the_same) {
  const Font font = open();
  Styles styles;
  for (const Style& style : styles.styles) {
    for (uint16_t glyph = square; glyph <= whole; ++glyph) {
      draw_whole(font, glyph, style);
      expected = picture;
      PreparedGlyph prepared;
      CHECK_OK(PreparedGlyph::make(font, glyph, style, kMiddle,
                                   {ram, sizeof(ram)}, prepared));
      picture.clear();
      picture.draw_strips(7, [&](const Sink& sink) { prepared.draw(sink); });
      CHECK(picture == expected);
      CHECK(picture.lies_in(prepared.box()));
    }
  }
}

TEST(a_prepared_glyph_says_what_it_lacks) {
  const Font font = open();
  const Style style = text_style();
  PreparedGlyph prepared;
  CHECK_EQ(
      PreparedGlyph::make(font, square, style, kMiddle, {ram, 791}, prepared),
      Status::buffer_small);
  CHECK_EQ(PreparedGlyph::make(font, 5, style, kMiddle, {ram, 2000}, prepared),
           Status::no_glyph);
  CHECK(is_empty(prepared.box()));
  CHECK_OK(PreparedGlyph::make(font, 0, style, kMiddle, {ram, 2000}, prepared));
  CHECK(is_empty(prepared.box()));
  picture.clear();
  prepared.draw(picture.sink());
  CHECK_EQ(picture.ink(), 0);
}

TEST(areas_are_the_same_at_every_position) {
  const Font font = open();
  const Style style = area_style();
  for (int32_t x_q6 = 0; x_q6 < 64; x_q6 += 7) {
    for (int32_t y_q6 = 0; y_q6 < 64; y_q6 += 9) {
      picture.clear();
      Painter(picture.sink())
          .glyph(font, style, at(x_q6, 20 * 64 + y_q6), square);
      // 6 px by 6 px.
      CHECK(picture.ink() >= 36 * 254 && picture.ink() <= 36 * 256);
    }
  }
}
