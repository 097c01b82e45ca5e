// Grid fitting: where strokes and advances go, in numbers and in pictures.
#include "inkcell/fit.hpp"

#include "check.hpp"
#include "grid_record.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/painter.hpp"
#include "picture.hpp"
#include "place/style_parts.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace outline_record;

alignas(4) uint8_t rom[2048];

int32_t advance_px(const Fit& fit, const Font& font, uint16_t glyph) {
  return kGridFit.advance_px(font, Style().set_fit(fit), glyph);
}

void fit_glyph(const Fit& fit,
               const Font& font,
               uint16_t glyph,
               FinePoint& origin,
               GlyphWarp& warp) {
  GlyphMetrics metrics;
  CHECK_OK(font.glyph_metrics(glyph, metrics));
  kGridFit.fit(font, Style().set_fit(fit), glyph, metrics, origin, warp);
}

// Three bars, such as those of e, with a stroke that hangs into the upper
// counter; n; v; and an oblong with serifs.
constexpr OutlinePoint kThree[] = {
    {start, 60, 0},     {corner, 540, 0},   {corner, 540, 70},
    {corner, 150, 70},  {corner, 150, 200}, {corner, 540, 200},
    {corner, 540, 270}, {corner, 150, 270}, {corner, 150, 442},
    {corner, 450, 442}, {corner, 450, 320}, {corner, 540, 320},
    {corner, 540, 512}, {corner, 60, 512}};
constexpr OutlinePoint kTwo[] = {
    {start, 60, 0},   {corner, 150, 0}, {corner, 150, 442}, {corner, 450, 442},
    {corner, 450, 0}, {corner, 540, 0}, {corner, 540, 512}, {corner, 60, 512}};
constexpr OutlinePoint kWedge[] = {
    {start, 40, 512}, {corner, 210, 0}, {corner, 300, 0}, {corner, 470, 512}};
constexpr OutlinePoint kSerif[] = {{start, 40, 0},     {corner, 270, 0},
                                   {corner, 270, 30},  {corner, 200, 30},
                                   {corner, 200, 512}, {corner, 110, 512},
                                   {corner, 110, 30},  {corner, 40, 30}};

enum Glyph : uint16_t { three = 1, two, wedge, serif, space };

Font open(const Hints& hints) {
  const OutlineSource glyphs[] = {{600},
                                  {600, {kThree, 14}},
                                  {600, {kTwo, 8}},
                                  {510, {kWedge, 4}},
                                  {310, {kSerif, 8}},
                                  {300}};
  const size_t size =
      build_outline_font({glyphs, 6}, 0, 'A', {rom, sizeof rom}, hints);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font;
}

void fill(GridRecord& record) {
  record.usual_zones();
  record.glyph_without_hints();
  record.glyph(false, 4, 2);
  record.stroke_in_zone(0, false, 0);
  record.stroke(0, 200);
  record.end(320, false);
  record.stroke_in_zone(0, true, 1);
  record.stem(60);
  record.stem(450);
  record.glyph(true, 2, 2);
  record.edge(0, false);
  record.stroke_in_zone(0, true, 1);
  record.stem(60);
  record.stem(450);
  record.glyph(true, 2, 0);
  record.edge(0, false);
  record.edge(1, false);
  record.insets_glyph(2, 1, 70, 70);
  record.stroke_in_zone(1, false, 0, 30);
  record.edge(1, false);
  record.stem(110);
  record.glyph_without_hints();
}

Font hinted_font() {
  GridRecord record;
  fill(record);
  const Font font = open(record.write());
  CHECK_OK(font.verify());
  return font;
}

Style style_of(int32_t px_q6) {
  return Style(Q26_6::from_raw(px_q6), kFilterText);
}

Fit fit_of(const Font& font, int32_t px_q6, const FitOptions& options = {}) {
  Fit fit;
  CHECK_OK(Fit::make(font, style_of(px_q6), options, fit));
  return fit;
}

constexpr FitOptions kAcross = {true, 0, FitOptions::kAll};
constexpr FitOptions kBilevel = {true, 2, FitOptions::kAll};

GlyphWarp warp_of(const Font& font, const Fit& fit, uint16_t glyph) {
  FinePoint origin = {300, 700};
  GlyphWarp warp = {};
  fit_glyph(fit, font, glyph, origin, warp);
  return warp;
}

struct Knot {
  int32_t from_q8;
  int32_t to_q8;
};

template <size_t kCount>
void check_knots(const AxisMap& map, const Knot (&knots)[kCount]) {
  constexpr auto kKnots = static_cast<int32_t>(kCount);
  CHECK_EQ(map.count, kKnots);
  for (int32_t i = 0; i < kKnots && i < map.count; ++i) {
    CHECK_EQ(map.knots[i].from_q8, knots[i].from_q8);
    CHECK_EQ(map.knots[i].to_q8, knots[i].to_q8);
  }
}

}  // namespace

// At 11 px the x-height is 5.5 px and becomes 6. Bars of 48/64 px, the middle
// one inside a row; the end keeps a row above it.
TEST(heights_lie_between_rows) {
  const Font font = hinted_font();
  check_knots(warp_of(font, fit_of(font, 11 * 64), three).y, {{0, 0},
                                                              {193, 192},
                                                              {550, 544},
                                                              {743, 736},
                                                              {880, 992},
                                                              {1216, 1344},
                                                              {1408, 1536}});
  // At 10 px it is 5 px as it is.
  check_knots(warp_of(font, fit_of(font, 10 * 64), two).y,
              {{0, 0}, {1105, 1088}, {1280, 1280}});
}

TEST(bars_of_bilevel_text_fill_rows) {
  const Font font = hinted_font();
  const FitOptions options = {false, 2, FitOptions::kAll};
  const GlyphWarp warp = warp_of(font, fit_of(font, 11 * 64, options), three);
  check_knots(warp.y, {{0, 0},
                       {193, 256},
                       {550, 512},
                       {743, 768},
                       {880, 1024},
                       {1216, 1280},
                       {1408, 1536}});
  CHECK_EQ(warp.x.count, 0);
}

// 0.8 px above the x-height, a dot whose zone is rounded down; below the
// baseline, one whose zone is rounded up.
TEST(a_row_stays_free_beside_dots) {
  GridRecord record;
  record.usual_zones();
  record.zone(-146, 0, false);
  record.glyph_without_hints();
  record.glyph(true, 2, 0);
  record.edge(1, false);
  record.stroke_in_zone(0, true, 2, 130);
  record.glyph(true, 2, 0);
  record.stroke_in_zone(0, false, 3, 80);
  record.edge(0, false);
  for (int i = 0; i < 3; ++i) {
    record.glyph_without_hints();
  }
  const Font font = open(record.write());
  const FitOptions options = {false, 2, FitOptions::kAll};
  const Fit fit = fit_of(font, 11 * 64, options);
  check_knots(warp_of(font, fit, 1).y,
              {{1408, 1536}, {1623, 1792}, {1980, 2304}});
  check_knots(warp_of(font, fit, 2).y, {{-401, -512}, {-181, -256}, {0, 0}});
}

// 0.88 px of stem in the middle of a pixel, and four px from one to the next.
TEST(stems_stand_in_whole_pixels) {
  const Font font = hinted_font();
  const Fit fit = fit_of(font, 10 * 64, kAcross);
  check_knots(warp_of(font, fit, two).x,
              {{150, 272}, {375, 496}, {1125, 1296}, {1350, 1520}});
  CHECK_EQ(advance_px(fit, font, two), 6);
  const Fit bilevel = fit_of(font, 10 * 64, kBilevel);
  check_knots(warp_of(font, bilevel, two).x,
              {{150, 256}, {375, 512}, {1125, 1280}, {1350, 1536}});
  CHECK_EQ(advance_px(bilevel, font, two), 6);
}

// 4.2 px become 4.
TEST(ink_without_stems_is_whole) {
  const Font font = hinted_font();
  const Fit fit = fit_of(font, 10 * 64, kAcross);
  check_knots(warp_of(font, fit, wedge).x, {{100, 256}, {1175, 1280}});
  CHECK_EQ(advance_px(fit, font, wedge), 5);
  // Odd with two levels, so that its apex is a pixel.
  const Fit bilevel = fit_of(font, 10 * 64, kBilevel);
  check_knots(warp_of(font, bilevel, wedge).x, {{100, 256}, {1175, 1024}});
  CHECK_EQ(advance_px(fit, font, space), 3);
  CHECK_EQ(warp_of(font, fit, space).x.count, 0);
}

// Below 16 px wings of serifs go into the zone, and the ink begins at the stem.
TEST(serifs_of_bilevel_text_are_left_out) {
  const Font font = hinted_font();
  const GlyphWarp small = warp_of(font, fit_of(font, 10 * 64, kBilevel), serif);
  check_knots(small.y, {{0, 0}, {75, 0}, {1280, 1280}});
  check_knots(small.x, {{275, 256}, {500, 512}});
  CHECK_EQ(advance_px(fit_of(font, 10 * 64, kBilevel), font, serif), 3);
  const GlyphWarp large = warp_of(font, fit_of(font, 16 * 64, kBilevel), serif);
  CHECK_EQ(large.y.knots[1].to_q8, 256);
  CHECK_EQ(large.x.count, 4);
}

TEST(diagonals_get_the_weight_of_stems) {
  const Font font = hinted_font();
  // 56 become 64: 4/64 px on each side.
  CHECK_EQ(fit_of(font, 10 * 64, kBilevel).bilevel_weight().raw, -34);
  // 84 become 64.
  CHECK_EQ(fit_of(font, 15 * 64, kBilevel).bilevel_weight().raw, 190);
}

TEST(heights_can_be_fitted_alone) {
  const Font font = hinted_font();
  const Fit fit = fit_of(font, 10 * 64, kAcross);
  const GlyphWarp both = warp_of(font, fit, two);
  FinePoint origin = {300, 700};
  GlyphWarp warp = {};
  GlyphMetrics metrics;
  CHECK_OK(font.glyph_metrics(two, metrics));
  Style style = style_of(10 * 64);
  style.set_fit(kFitHeights, &fit);
  kFitHeights.fit(font, style, two, metrics, origin, warp);
  CHECK_EQ(origin.x_q10, 300);
  CHECK_EQ(origin.y_q10, 1024);
  CHECK_EQ(warp.x.count, 0);
  CHECK_EQ(warp.y.count, both.y.count);
  for (int32_t i = 0; i != warp.y.count; ++i) {
    CHECK_EQ(warp.y.knots[i].to_q8, both.y.knots[i].to_q8);
  }
  CHECK(!kFitHeights.has_advances(style));
  CHECK(kGridFit.has_advances(style));
}

// What canvases of 1 bit do to a style that leaves its fit open.
TEST(sinks_of_few_levels_fit_text) {
  const Font font = hinted_font();
  Sink sink;
  sink.levels = &detail::kTwoLevelRule;
  const Painter painter(sink);
  Style room;
  const Style open(10_px);
  CHECK(detail::StyleParts::is_fit_open(open));
  const Style& fitted = painter.adapted(open, room);
  CHECK(&fitted == &room && !detail::StyleParts::is_fit_open(fitted));
  // Once is enough.
  Style other;
  CHECK(&painter.adapted(fitted, other) == &fitted);
  CHECK(fitted.has_whole_advances());
  CHECK(is_same(fitted, two_level_style(10_px)));
  // As with a Fit.
  CHECK_EQ(fitted.fitter()->advance_px(font, fitted, two),
           advance_px(fit_of(font, 10 * 64, kBilevel), font, two));
  FinePoint origin = {300, 700};
  GlyphWarp warp = {};
  GlyphMetrics metrics;
  CHECK_OK(font.glyph_metrics(two, metrics));
  fitted.fitter()->fit(font, fitted, two, metrics, origin, warp);
  CHECK_EQ(origin.x_q10, 0);
  CHECK_EQ(origin.y_q10, 1024);
  const GlyphWarp same = warp_of(font, fit_of(font, 10 * 64, kBilevel), two);
  CHECK_EQ(warp.x.count, same.x.count);
  for (int32_t i = 0; i != warp.x.count; ++i) {
    CHECK_EQ(warp.x.knots[i].to_q8, same.x.knots[i].to_q8);
  }
  // Moving, large or closed text keeps its advances, with the effect.
  CHECK(!painter.for_motion().adapted(open, room).is_fitted());
  CHECK(!painter.adapted(Style(40_px), room).is_fitted());
  Style closed(10_px);
  closed.clear_fit();
  CHECK(!painter.adapted(closed, room).is_fitted());
  CHECK(room.effect() != nullptr);
}

TEST(a_fit_can_be_made_again) {
  const Font font = hinted_font();
  Fit fit = fit_of(font, 10 * 64, kBilevel);
  CHECK_OK(Fit::make(font, style_of(40 * 64), kBilevel, fit));
  CHECK(!fit.has_advances());
  CHECK_EQ(fit.bilevel_weight().raw, 0);
  CHECK_EQ(warp_of(font, fit, two).y.count, 0);
}

TEST(fitting_fades_and_ends) {
  const Font font = hinted_font();
  const auto shift = [&font](int32_t px, const FitOptions& options) {
    const AxisMap map =
        warp_of(font, fit_of(font, px * 64 + 32, options), two).y;
    return map.count == 0 ? 0 : map.knots[2].to_q8 - map.knots[2].from_q8;
  };
  // The x-height is 1/4 px more than whole.
  CHECK_EQ(shift(24, {}), (192 * 248) >> 8);
  CHECK_EQ(shift(32, {}), (192 * 120) >> 8);
  CHECK_EQ(shift(40, {}), 0);
  CHECK_EQ(shift(24, {false, 0, 128}), (192 * 124) >> 8);
  // Bilevel text is fitted or not.
  CHECK_EQ(shift(32, {false, 2, FitOptions::kAll}), 192);
  CHECK(!fit_of(font, 40 * 64, kAcross).has_advances());
  Fit fit;
  CHECK_EQ(Fit::make(font, style_of(640), {true, 3, 256}, fit),
           Status::bad_argument);
  CHECK_EQ(Fit::make(font, style_of(640), {true, 2, 257}, fit),
           Status::bad_argument);
}

TEST(fonts_without_hints_keep_all_but_baselines) {
  const Font font = open({});
  const Fit fit = fit_of(font, 10 * 64, kAcross);
  CHECK(!fit.has_advances());
  FinePoint origin = {300, 700};
  GlyphWarp warp = {};
  fit_glyph(fit, font, two, origin, warp);
  CHECK_EQ(warp.x.count + warp.y.count, 0);
  CHECK_EQ(origin.x_q10, 300);
  CHECK_EQ(origin.y_q10, 1024);
}

// Whatever the levels and hints: equal widths are equal columns, as a table and
// the digits of a face need them, and ink stays in its column.
TEST(advances_are_those_of_the_design) {
  constexpr int32_t kShoulder = 32;  // of stems of 3/4 to 5/4 px
  const Font font = hinted_font();
  for (int32_t px = 8; px < 40; ++px) {
    for (uint8_t levels = 0; levels <= 4;
         levels = static_cast<uint8_t>(levels + 2)) {
      const Fit fit = fit_of(font, px * 64, {true, levels, FitOptions::kAll});
      for (uint16_t glyph = three; glyph <= space; ++glyph) {
        const int32_t designed = font.advance(glyph) * px * 64 / 1024;
        const int32_t advance = advance_px(fit, font, glyph);
        CHECK(advance * 64 >= designed - 36 && advance * 64 <= designed + 28);
        const AxisMap map = warp_of(font, fit, glyph).x;
        // Grey text of more is fitted less and less.
        if (map.count != 0 && (levels != 0 || px <= 24)) {
          CHECK(map.knots[0].to_q8 >= 256 - kShoulder);
          CHECK(map.knots[map.count - 1].to_q8 <= advance * 256 + kShoulder);
        }
      }
      CHECK_EQ(advance_px(fit, font, three), advance_px(fit, font, two));
    }
  }
}

TEST(lines_keep_their_length_and_columns) {
  const Font font = hinted_font();
  for (int32_t px = 8; px < 40; ++px) {
    const Style styles[] = {two_level_style(Q26_6::from_int(px)),
                            four_level_style(Q26_6::from_int(px))};
    for (const Style& style : styles) {
      const auto width_px = [&](Text text) {
        return Painter().measure(font, style, text).advance.raw / 64;
      };
      constexpr char kLine[] = "DCDECADECDABEDDCDECBADECDCDE";
      const int32_t designed =
          to_px(font, style, measure(font, kLine).advance).raw / 64;
      CHECK(width_px(kLine) >= designed - 2 && width_px(kLine) <= designed + 2);
      CHECK_EQ(width_px("CDEABBAC"), width_px("CDEBABBC"));
      CHECK_EQ(width_px("DEAAAAAAAAAAED"), width_px("DEBBBBBBBBBBED"));
    }
  }
}

// Positions are whole pixels, however long the line and wherever it begins.
TEST(text_is_measured_as_it_is_drawn) {
  const Font font = hinted_font();
  Style style = style_of(10 * 64);
  const Fit fit = fit_of(font, 10 * 64, kAcross);
  style.set_fit(fit);
  CHECK(style.has_whole_advances());
  static char text[120];
  for (size_t i = 0; i < sizeof text; ++i) {
    text[i] = static_cast<char>('A' + i % 5);
  }
  const Text all(text, sizeof text);
  const int32_t width = Painter().measure(font, style, all).advance.raw;
  CHECK_EQ(width % 64, 0);
  CHECK(width / 64 == 543 || width / 64 == 544);  // 543.75 px as designed
  static PositionedGlyph room[sizeof text];
  Span<const PositionedGlyph> glyphs;
  CHECK_OK(Painter().lay_out(font, style, all, {room, sizeof text}, glyphs));
  CHECK_EQ(glyphs.size, sizeof text);
  int32_t x_px = 0;
  TextCursor cursor(font, all, style);
  PositionedGlyph at;
  for (size_t i = 0; i < glyphs.size; ++i) {
    const int32_t x = to_px(font, style, glyphs[i].x).raw;
    CHECK(x % 64 == 0 && x >= x_px * 64 - 64 && x <= x_px * 64 + 64);
    CHECK(cursor.next(at) && at.x == glyphs[i].x);
    x_px = x / 64 + advance_px(fit, font, glyphs[i].glyph);
  }
  // Without the style they are the font's.
  CHECK_EQ(measure(font, all).advance, 24 * (600 + 600 + 510 + 310 + 300));

  for (int32_t part = 0; part < 64; part += 16) {
    const Point origin = {Q26_6::from_raw(64 + part), Q26_6::from_raw(480)};
    static Picture<32, 9> whole;
    static Picture<32, 9> drawn;
    whole = Picture<32, 9>();
    drawn = Picture<32, 9>();
    const Point rounded = {Q26_6::from_int(part < 32 ? 1 : 2), origin.y};
    CHECK_OK(Painter().lay_out(font, style, "BAB", {room, 3}, glyphs));
    for (const PositionedGlyph& glyph : glyphs) {
      Painter(whole.sink()).glyphs(font, style, rounded, {&glyph, 1});
      Painter(drawn.sink()).glyphs(font, style, origin, {&glyph, 1});
      whole.next_glyph();
      drawn.next_glyph();
    }
    for (int32_t i = 0; i < 32 * 9; ++i) {
      CHECK_EQ(whole.at(i % 32, i / 32), drawn.at(i % 32, i / 32));
    }
  }
}

namespace {

// One glyph at a time: boxes of neighbours may overlap.
void draw_each(const Font& font, const Style& style, Picture<18, 8>& picture) {
  TextCursor cursor(font, "ABD", style);
  PositionedGlyph at;
  while (cursor.next(at)) {
    Painter(picture.sink()).glyphs(font, style, {0, 7}, {&at, 1});
    picture.next_glyph();
  }
}

}  // namespace

TEST(fitted_glyphs_look_sharp) {
  const Font font = hinted_font();
  Style style = style_of(11 * 64);
  const Fit fit = fit_of(font, 11 * 64, kAcross);
  style.set_fit(fit);
  Picture<18, 8> grey;
  draw_each(font, style, grey);
  CHECK_PICTURE(grey,
                "..................\n"
                ".*****.*****.*....\n"
                ".*...*.*...*.*....\n"
                ".*...:.*...*.*....\n"
                ".*****.*...*.*....\n"
                ".*.....*...*.*....\n"
                ".*****.*...*.*....\n");
  const Fit whole = fit_of(font, 11 * 64, kBilevel);
  const Bilevel bilevel(2, whole.bilevel_weight());
  style.set_fit(whole);
  style.set_effect(bilevel);
  Picture<18, 8> picture;
  draw_each(font, style, picture);
  CHECK_PICTURE(picture,
                "..................\n"
                ".#####.#####.#....\n"
                ".#...#.#...#.#....\n"
                ".#.....#...#.#....\n"
                ".#####.#...#.#....\n"
                ".#.....#...#.#....\n"
                ".#####.#...#.#....\n");
}

// Maps ascend, advances are whole and not negative, and whatever is drawn stays
// in the window, for any bytes at any size.
TEST(any_hints_are_safe) {
  static uint8_t bytes[128];
  for (Random& random : Rounds(23, INKCELL_BOARD_FIRMWARE ? 30 : 1500)) {
    random.fill(bytes);
    bytes[0] = static_cast<uint8_t>(random.below(9));
    bytes[4] = static_cast<uint8_t>(random.below(9));
    bytes[5] = static_cast<uint8_t>(random.below(3));
    HintBits glyphs[6];
    for (HintBits& glyph : glyphs) {
      glyph = {bytes + random.below(60), random.below(400)};
    }
    const Font font = open({{bytes, sizeof bytes}, {glyphs, 6}});
    const int32_t px_q6 = random.between(4 * 64, 42 * 64);
    Style style = style_of(px_q6);
    FitOptions options;
    options.across = random.below(4) != 0;
    options.levels = static_cast<uint8_t>(random.below(3) * 2);
    Fit fit;
    if (Fit::make(font, style, options, fit) != Status::ok) {
      continue;
    }
    style.set_fit(fit);
    for (uint16_t glyph = 0; glyph < 6; ++glyph) {
      const GlyphWarp warp = warp_of(font, fit, glyph);
      const AxisMap* const maps[] = {&warp.x, &warp.y};
      for (const AxisMap* map : maps) {
        CHECK(map->count >= 0 && map->count <= AxisMap::kMaxKnots);
        for (int32_t i = 1; i < map->count; ++i) {
          CHECK(map->knots[i].from_q8 > map->knots[i - 1].from_q8);
          CHECK(map->knots[i].to_q8 >= map->knots[i - 1].to_q8);
        }
      }
      CHECK(!fit.has_advances() || advance_px(fit, font, glyph) >= 0);
      Picture<24, 24> picture;
      Painter(picture.sink()).glyph(font, style, {2, 18}, glyph);
    }
  }
}
