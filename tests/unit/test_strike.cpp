// Strikes: the pictures of outlines, at another cost; and fonts of strikes
// alone.
#include "inkcell/strike/strike.hpp"

#include "inkcell/strike/outline_strike.hpp"

#include "check.hpp"
#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/strike/verify.hpp"
#include "inkcell/stroke.hpp"
#include "outline_record.hpp"
#include "picture.hpp"
#include "random.hpp"
#include "strike_font.hpp"

namespace {

using namespace inkcell;
using format::StrikeFit;
using strike_font::StrikeSpec;
using strike_font::Values;

constexpr uint16_t kGlyphs = 8;
constexpr int32_t kWidth = 96;
constexpr int32_t kHeight = 32;
constexpr int32_t kPixels = kWidth * kHeight;

alignas(4) uint8_t rom[12288];
strike_font::StrikeWriter<8192> strikes;
alignas(4) uint8_t bytes[kPixels];
uint8_t with_strikes[kPixels];
uint8_t from_outlines[kPixels];

// A canvas of some format over `bytes`, and a pixel of it.
template <typename Canvas>
struct Format;
template <>
struct Format<port::A8Canvas> {
  static constexpr int32_t kStride = kWidth;
  static constexpr uint8_t kBits = 4;
  static uint8_t value(int32_t x, int32_t y) { return bytes[y * kWidth + x]; }
};
template <>
struct Format<port::MonoPagesCanvas> {
  static constexpr int32_t kStride = kWidth;
  static constexpr uint8_t kBits = 1;
  static uint8_t value(int32_t x, int32_t y) {
    return bytes[y / 8 * kWidth + x] >> y % 8 & 1;
  }
};
template <>
struct Format<port::MonoRowsCanvas> {
  static constexpr int32_t kStride = kWidth / 8;
  static constexpr uint8_t kBits = 1;
  static uint8_t value(int32_t x, int32_t y) {
    return bytes[y * kStride + x / 8] >> (7 - x % 8) & 1;
  }
};
template <>
struct Format<port::Grey2Canvas> {
  static constexpr int32_t kStride = kWidth / 4;
  static constexpr uint8_t kBits = 2;
  static uint8_t value(int32_t x, int32_t y) {
    return bytes[y * kStride + x / 4] >> (6 - x % 4 * 2) & 3;
  }
};

// An empty canvas of so many rows from row `y0` on, or of all.
template <typename Canvas>
Canvas clean(int32_t y0 = 0, int32_t rows = kHeight) {
  constexpr int32_t kStride = Format<Canvas>::kStride;
  for (uint8_t& byte : bytes) {
    byte = 0;
  }
  Strip strip;
  strip.pixels = {bytes, sizeof bytes};
  strip.y0 = y0;
  strip.width = kWidth;
  strip.height = rows;
  strip.stride = kStride;
  return Canvas(strip);
}

template <typename Canvas>
void keep(uint8_t (&out)[kPixels]) {
  for (int32_t i = 0; i < kPixels; ++i) {
    out[i] = Format<Canvas>::value(i % kWidth, i / kWidth);
  }
}

size_t outline_size() {
  return outline_record::build_sample_font({rom, sizeof rom});
}

// The picture that outlines show of a glyph at a whole pixel, with 4 bits to
// the nearest of 16 levels.
template <typename Canvas>
void draw_values(const Font& font,
                 const Style& style,
                 uint16_t glyph,
                 Values& out) {
  constexpr int32_t kX = 8, kY = 24;
  const Canvas canvas = clean<Canvas>();
  Painter(canvas).glyph(font, style, {Q26_6::from_int(kX), Q26_6::from_int(kY)},
                        glyph);
  out.left = -kX;
  out.top = -kY;
  out.width = Values::kSide;
  out.height = kHeight;
  for (int32_t y = 0; y < kHeight; ++y) {
    for (int32_t x = 0; x < Values::kSide; ++x) {
      const int32_t value = Format<Canvas>::value(x, y);
      out.at[y][x] = static_cast<uint8_t>(
          Format<Canvas>::kBits == 4 ? (value * 15 + 127) / 255 : value);
    }
  }
  out.crop();
}

// The sample font with a strike of a style, opened with a coding. Marked: each
// picture is a row of three pixels, which no glyph is.
template <typename Canvas>
Font font_with(const Style& style,
               StrikeFit fit,
               bool is_marked,
               const Coding& coding = kOutlineStrikeCoding) {
  size_t size = outline_size();
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  const auto px = static_cast<uint16_t>(style.size().raw / 64);
  constexpr uint8_t kBits = Format<Canvas>::kBits;
  strikes.begin(1);
  strikes.add({px, kBits, fit, 0, kGlyphs, 700},
              [&](uint16_t glyph, Values& values) {
                if (is_marked) {
                  values.width = 3;
                  values.height = 1;
                  for (int32_t i = 0; i != 3; ++i) {
                    values.at[0][i] = (1 << kBits) - 1;
                  }
                } else {
                  draw_values<Canvas>(font, style, glyph, values);
                }
              });
  size = strike_font::add_section({rom, sizeof rom}, size,
                                  format::section::kStrikes, strikes.bytes());
  CHECK(size != 0);
  CHECK_OK(Font::open({rom, size}, coding, font));
  CHECK_OK(font.verify());
  CHECK_OK(verify_strikes(font));
  return font;
}

constexpr Point kPen = {Q26_6::from_raw(2 * 64 + 20),
                        Q26_6::from_raw(20 * 64 + 7)};
constexpr char kText[] = "ABCDEFGA";

// The greatest difference of a text between strikes and outlines.
template <typename Canvas>
int32_t difference(const Font& font, const Style& style, Point pen = kPen) {
  Font outlines;
  CHECK_OK(Font::open(font.rom(), outlines));
  Canvas canvas = clean<Canvas>();
  Painter(canvas).text(outlines, style, pen, kText);
  keep<Canvas>(from_outlines);
  canvas = clean<Canvas>();
  Painter(canvas).text(font, style, pen, kText);
  keep<Canvas>(with_strikes);
  int32_t most = 0;
  bool is_empty = true;
  for (int32_t i = 0; i < kPixels; ++i) {
    const int32_t difference = with_strikes[i] - from_outlines[i];
    most = magnitude(difference) > most ? magnitude(difference) : most;
    is_empty &= from_outlines[i] == 0;
  }
  CHECK(!is_empty);
  return most;
}

// What a strike serves: its picture is that of outlines, within `most`, and
// a marked one shows.
template <typename Canvas>
void check_served(const Style& strike,
                  const Style& drawn,
                  StrikeFit fit,
                  int32_t most) {
  CHECK(difference<Canvas>(font_with<Canvas>(strike, fit, false), drawn) <=
        most);
  CHECK(difference<Canvas>(font_with<Canvas>(strike, fit, true), drawn) > most);
}

// What it does not: a marked one does not show.
template <typename Canvas>
void check_passed_over(const Style& strike,
                       const Style& drawn,
                       StrikeFit fit,
                       Point pen = kPen) {
  CHECK_EQ(difference<Canvas>(font_with<Canvas>(strike, fit, true), drawn, pen),
           0);
}

// As text is drawn on a canvas of few levels by itself, and by its own style.
template <typename Canvas>
void check_few_levels() {
  for (const int32_t px : each_of({8, 12, 17, 24})) {
    const Style style = Style(Q26_6::from_int(px));
    const Style own = Canvas::style(Q26_6::from_int(px));
    check_served<Canvas>(own, style, StrikeFit::both, 0);
    check_served<Canvas>(own, own, StrikeFit::both, 0);
  }
}

TEST(mono_pages_show_the_same_by_strikes) {
  check_few_levels<port::MonoPagesCanvas>();
}
TEST(mono_rows_show_the_same_by_strikes) {
  check_few_levels<port::MonoRowsCanvas>();
}
TEST(grey2_shows_the_same_by_strikes) {
  check_few_levels<port::Grey2Canvas>();
}

TEST(grey_canvases_show_the_same_within_half_a_level) {
  for (const int32_t px : each_of({8, 12, 17, 24})) {
    const Q26_6 size = Q26_6::from_int(px);
    check_served<port::A8Canvas>(strike_style(size), strike_style(size),
                                 StrikeFit::both, 8);
    check_served<port::A8Canvas>(strike_height_style(size),
                                 strike_height_style(size), StrikeFit::heights,
                                 8);
  }
}

TEST(designed_glyphs_are_served_at_whole_pixels) {
  const Style style = Style(12_px).clear_fit();
  for (const bool is_marked : each_of({false, true})) {
    const Font font =
        font_with<port::A8Canvas>(style, StrikeFit::none, is_marked);
    // A glyph alone, on a whole pixel, beside it, and above it.
    for (const int32_t dx : each_of({0, 1})) {
      for (const int32_t dy : each_of({0, 1})) {
        const Point at = {Q26_6::from_raw(640 + dx),
                          Q26_6::from_raw(1280 + dy)};
        port::A8Canvas canvas = clean<port::A8Canvas>();
        Painter(canvas).glyph(font, style, at, 3);
        keep<port::A8Canvas>(with_strikes);
        Font outlines;
        CHECK_OK(Font::open(font.rom(), outlines));
        canvas = clean<port::A8Canvas>();
        Painter(canvas).glyph(outlines, style, at, 3);
        keep<port::A8Canvas>(from_outlines);
        int32_t most = 0;
        for (int32_t i = 0; i < kPixels; ++i) {
          const int32_t is = magnitude(with_strikes[i] - from_outlines[i]);
          most = is > most ? is : most;
        }
        CHECK(is_marked && dx + dy == 0 ? most > 8 : most <= 8);
        CHECK(dx + dy == 0 || most == 0);
      }
    }
  }
}

TEST(other_styles_are_drawn_from_outlines) {
  using Mono = port::MonoPagesCanvas;
  using A8 = port::A8Canvas;
  const Style mono = Mono::style(12_px);
  check_passed_over<Mono>(mono, Style(13_px), StrikeFit::both);
  check_passed_over<Mono>(mono, Style(Q26_6::from_raw(769)), StrikeFit::both);
  check_passed_over<Mono>(mono, Style(12_px).clear_fit(), StrikeFit::both);
  check_passed_over<Mono>(mono, Style(12_px), StrikeFit::none);
  check_passed_over<Mono>(mono, Style(12_px), StrikeFit::source);
  check_passed_over<Mono>(mono, Style(12_px, kFilterText), StrikeFit::both);
  constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1));
  check_passed_over<Mono>(mono, Style(12_px).set_effect(kStroke),
                          StrikeFit::both);
  check_passed_over<Mono>(mono,
                          Style(12_px, kFilterArea,
                                {Fixed<int32_t, 30>::from_raw(1037154959),
                                 Fixed<int32_t, 30>::from_raw(277904834)}),
                          StrikeFit::both);
  // Pictures of 1 bit on a canvas of many levels.
  check_passed_over<A8>(mono, mono, StrikeFit::both);
  const Style grey = strike_style(12_px);
  check_passed_over<A8>(grey, Style(12_px), StrikeFit::both);
  check_passed_over<A8>(grey, strike_height_style(12_px), StrikeFit::both);
  check_passed_over<A8>(grey, strike_style(13_px), StrikeFit::both);
  check_passed_over<A8>(grey, Style(12_px), StrikeFit::none, kPen);
}

// Thresholds and dither make another picture of coverage.
TEST(other_thresholds_are_drawn_from_outlines) {
  const Font font = font_with<port::MonoPagesCanvas>(
      port::MonoPagesCanvas::style(12_px), StrikeFit::both, true);
  Font outlines;
  CHECK_OK(Font::open(font.rom(), outlines));
  port::MonoPagesCanvas canvas = clean<port::MonoPagesCanvas>();
  canvas.set_threshold(90);
  Painter(canvas).text(font, Style(12_px), kPen, kText);
  keep<port::MonoPagesCanvas>(with_strikes);
  canvas = clean<port::MonoPagesCanvas>();
  canvas.set_threshold(90);
  Painter(canvas).text(outlines, Style(12_px), kPen, kText);
  keep<port::MonoPagesCanvas>(from_outlines);
  CHECK_EQ(__builtin_memcmp(with_strikes, from_outlines, kPixels), 0);
}

// The coding of bits has no use for other strikes.
TEST(bit_coding_draws_bits_alone) {
  const Style mono = port::MonoPagesCanvas::style(12_px);
  CHECK(difference<port::MonoPagesCanvas>(
            font_with<port::MonoPagesCanvas>(mono, StrikeFit::both, true,
                                             kOutlineBitStrikeCoding),
            mono) > 0);
  CHECK_EQ(difference<port::A8Canvas>(
               font_with<port::A8Canvas>(strike_style(12_px), StrikeFit::both,
                                         true, kOutlineBitStrikeCoding),
               strike_style(12_px)),
           0);
}

TEST(strips_show_the_same) {
  const Font font =
      font_with<port::A8Canvas>(strike_style(24_px), StrikeFit::both, false);
  port::A8Canvas canvas = clean<port::A8Canvas>();
  Painter(canvas).text(font, strike_style(24_px), kPen, kText);
  keep<port::A8Canvas>(from_outlines);
  for (const int32_t rows : each_of({1, 3, 8, 13})) {
    for (int32_t y0 = 0; y0 < kHeight; y0 += rows) {
      canvas =
          clean<port::A8Canvas>(y0, rows < kHeight - y0 ? rows : kHeight - y0);
      Painter(canvas).text(font, strike_style(24_px), kPen, kText);
      CHECK_EQ(
          __builtin_memcmp(bytes, from_outlines + y0 * kWidth,
                           static_cast<size_t>(canvas.strip().height * kWidth)),
          0);
    }
  }
}

// Fonts of strikes alone.

constexpr const char* kArrow[] = {"...#....", "..###...", ".#####..",
                                  "...#....", "...#...#"};
constexpr const char* kShades[] = {"....:::+++***###", "....:::+++***###",
                                   "#*+:.:+*#.#:*+.#"};

template <size_t kRows>
void set_values(const char* const (&rows)[kRows],
                uint8_t bits,
                int32_t left,
                Values& out) {
  out.left = left;
  out.top = -static_cast<int32_t>(kRows);
  out.height = static_cast<int32_t>(kRows);
  for (int32_t y = 0; y < out.height; ++y) {
    int32_t x = 0;
    for (const char* at = rows[y]; *at != '\0'; ++at, ++x) {
      const int32_t quarter = *at == '.'   ? 0
                              : *at == ':' ? 1
                              : *at == '+' ? 2
                              : *at == '*' ? 3
                                           : 4;
      out.at[y][x] = static_cast<uint8_t>(quarter * ((1 << bits) - 1) / 4);
    }
    out.width = x;
  }
}

// Glyph 1 ('A') is an arrow, glyph 2 has shades.
Font strikes_alone(uint8_t bits, uint16_t px = 10) {
  size_t size = outline_size();
  strikes.begin(1);
  strikes.add({px, bits, StrikeFit::source, 0, kGlyphs},
              [&](uint16_t glyph, Values& values) {
                if (glyph == 1) {
                  set_values(kArrow, bits, 1, values);
                } else if (glyph == 2) {
                  set_values(kShades, bits, -1, values);
                }
              });
  size = strike_font::add_section({rom, sizeof rom}, size,
                                  format::section::kGlyphs, strikes.bytes());
  CHECK(size != 0);
  strike_font::set_alone({rom, size}, px);
  Font font;
  CHECK_EQ(Font::open({rom, size}, font), Status::unsupported);
  CHECK_OK(Font::open({rom, size}, kStrikeCoding, font));
  CHECK_OK(font.verify());
  CHECK_OK(verify_strikes(font));
  return font;
}

TEST(bits_alone) {
  const Font font = strikes_alone(1);
  Picture<12, 7> picture;
  Painter(picture.sink())
      .glyph(font, Style(10_px), {Q26_6::from_raw(90), Q26_6::from_raw(370)},
             1);
  CHECK_PICTURE(picture,
                "............\n"
                ".....#......\n"
                "....###.....\n"
                "...#####....\n"
                ".....#......\n"
                ".....#...#..\n"
                "............\n");
}

TEST(greys_alone) {
  for (const uint8_t bits : each_of({uint8_t{2}, uint8_t{4}})) {
    const Font font = strikes_alone(bits);
    Picture<18, 4> picture;
    Painter(picture.sink()).glyph(font, Style(10_px), {1_px, 3_px}, 2);
    CHECK_EQ(picture.at(0, 0), 0);
    CHECK_EQ(picture.at(13, 0), 255);
    for (int32_t x = 0; x < 16; ++x) {
      const int32_t quarter = "0000111222333444"[x] - '0';
      const int32_t full = (1 << bits) - 1;
      CHECK_EQ(picture.at(x, 1), quarter * full / 4 * (255 / full));
      CHECK_EQ(picture.at(x, 1), picture.at(x, 0));
    }
    CHECK_EQ(picture.at(4, 2), 0);
    CHECK_EQ(picture.at(8, 2), 255);
  }
}

// Each pixel is a square, wherever windows cut it.
TEST(multiples_are_squares) {
  for (const uint8_t bits : each_of({uint8_t{1}, uint8_t{2}, uint8_t{4}})) {
    const Font font = strikes_alone(bits);
    Picture<20, 8> once;
    Painter(once.sink()).glyph(font, Style(10_px), {2_px, 6_px}, 2);
    for (const int32_t scale : each_of({2, 3, 7})) {
      static Picture<140, 56> picture;
      picture.clear();
      const Style style(Q26_6::from_int(10 * scale));
      CHECK_OK(font.check(style));
      picture.draw_parts(5, 33, [&](const Sink& sink) {
        Painter(sink).glyph(
            font, style,
            {Q26_6::from_int(2 * scale), Q26_6::from_int(6 * scale)}, 2);
      });
      for (int32_t y = 0; y < 8 * scale; ++y) {
        for (int32_t x = 0; x < 20 * scale; ++x) {
          CHECK_EQ(picture.at(x, y), once.at(x / scale, y / scale));
        }
      }
    }
  }
}

TEST(boxes_hold_pictures_alone) {
  const Font font = strikes_alone(1);
  const Rect box = Painter().glyph_box(font, Style(20_px), {3_px, 30_px}, 1);
  CHECK_EQ(box.x0, 5);
  CHECK_EQ(box.x1, 21);
  CHECK_EQ(box.y0, 20);
  CHECK_EQ(box.y1, 30);
  CHECK(is_empty(Painter().glyph_box(font, Style(15_px), {}, 1)));
  CHECK(is_empty(Painter().glyph_box(font, Style(10_px), {}, 7)));
}

TEST(other_styles_are_refused_alone) {
  const Font font = strikes_alone(1);
  CHECK_OK(font.check(Style(10_px)));
  CHECK_OK(font.check(Style(1000_px)));
  CHECK_OK(font.check(strike_style(10_px)));
  CHECK_EQ(font.check(Style(15_px)), Status::unsupported);
  CHECK_EQ(font.check(Style(5_px)), Status::unsupported);
  CHECK_EQ(font.check(Style(10_px, kFilterText)), Status::unsupported);
  constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1));
  CHECK_EQ(font.check(Style(10_px).set_effect(kStroke)), Status::unsupported);
  CHECK_EQ(font.check(Style(10_px, kFilterArea,
                            {Fixed<int32_t, 30>::from_raw(1037154959),
                             Fixed<int32_t, 30>::from_raw(277904834)})),
           Status::unsupported);
  alignas(8) static uint8_t ram[1024];
  PreparedGlyph prepared;
  CHECK_EQ(PreparedGlyph::make(font, 1, Style(10_px), {}, {ram, sizeof ram},
                               prepared),
           Status::unsupported);
}

// Canvases of 1 bit fit text; a cache passes strikes on.
TEST(canvases_and_caches_show_strikes_alone) {
  const Font font = strikes_alone(1);
  alignas(8) static uint8_t ram[2048];
  GlyphCache cache;
  CHECK_OK(GlyphCache::make({ram, sizeof ram}, {}, cache));
  for (const bool has_cache : each_of({false, true})) {
    port::MonoPagesCanvas canvas = clean<port::MonoPagesCanvas>();
    Painter(canvas, {}, has_cache ? &cache : nullptr)
        .text(font, Style(10_px), {2_px, 20_px}, "A");
    keep<port::MonoPagesCanvas>(with_strikes);
    for (int32_t y = 0; y < 5; ++y) {
      for (int32_t x = 0; x < 8; ++x) {
        CHECK_EQ(with_strikes[(15 + y) * kWidth + 3 + x],
                 kArrow[y][x] == '#' ? 1 : 0);
      }
    }
  }
  CHECK_EQ(cache.stats().glyphs, 0u);
}

// Whatever the bytes are, nothing is drawn outside the window, and calls end.
TEST(any_bytes_are_safe) {
  Random random(48);
  const Style mono = port::MonoPagesCanvas::style(12_px);
  for (const bool is_alone : each_of({false, true})) {
    Font font = is_alone ? strikes_alone(4)
                         : font_with<port::A8Canvas>(strike_style(12_px),
                                                     StrikeFit::both, false);
    const Span<const uint8_t> section =
        is_alone ? font.glyph_table() : font.section(format::section::kStrikes);
    auto* const at = const_cast<uint8_t*>(section.data);
    for (int32_t round = 0; round != 4000; ++round) {
      const size_t place = random.below(
          (round & 1) != 0 ? 36 : static_cast<uint32_t>(section.size));
      const uint8_t before = at[place];
      at[place] = static_cast<uint8_t>(random.next());
      static Picture<40, 30, Overlap::greatest> picture(-8, -12);
      picture.clear();
      const Sink sink = picture.sink();
      const Style style = is_alone ? Style(20_px) : strike_style(12_px);
      for (uint16_t glyph = 0; glyph != kGlyphs; ++glyph) {
        picture.next_glyph();
        Painter(sink).glyph(font, style, {}, glyph);
        static_cast<void>(Painter(sink).glyph_box(font, style, {}, glyph));
      }
      static_cast<void>(verify_strikes(font));
      // Half of the mistakes stay.
      at[place] = (round & 2) != 0 ? before : at[place];
    }
  }
  static_cast<void>(mono);
}

TEST(verify_finds_mistakes) {
  const Font font = strikes_alone(4);
  auto* const at = const_cast<uint8_t*>(font.glyph_table().data);
  constexpr uint32_t kEntry = format::strikes::kBytes;
  namespace strike = format::strike;
  for (const uint32_t place :
       each_of({uint32_t{0}, kEntry + strike::kPx + 1, kEntry + strike::kBits,
                kEntry + strike::kFit, kEntry + strike::kGlyphs,
                kEntry + strike::kCoding, kEntry + strike::kColumnBits,
                kEntry + strike::kReserved, kEntry + strike::kBoxes + 2,
                kEntry + strike::kPictures + 2})) {
    at[place] = static_cast<uint8_t>(at[place] + 32);
    CHECK_EQ(verify_strikes(font), Status::corrupt);
    at[place] = static_cast<uint8_t>(at[place] - 32);
  }
  CHECK_OK(verify_strikes(font));
}

}  // namespace
