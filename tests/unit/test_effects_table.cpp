// Every effect on outlines: the same picture however a glyph is cut and
// whatever RAM is lent, never that of plain drawing; and what the newer ones
// show.
#include "channel_canvas.hpp"
#include "check.hpp"
#include "ink.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/circle_samples.hpp"
#include "inkcell/field/splat.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"
#include "outline_font.hpp"
#include "own_effects.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;

const Font& font = outline_record::sample_font();

constexpr int32_t kWidth = 28;
constexpr int32_t kHeight = 26;
constexpr Rect kAll = {0, 0, kWidth, kHeight};
constexpr int32_t kFill = 3;  // after red, green and blue
constexpr int32_t kChannels = 4;
constexpr Point kOrigin = {Q26_6::from_raw(7 * 64 + 13),
                           Q26_6::from_raw(19 * 64 + 40)};
constexpr uint16_t kDisc = 1;
constexpr uint16_t kBar = 2;
constexpr uint16_t kFrame = 4;
constexpr uint16_t kLeaf = 5;

alignas(4) uint8_t ram[2560];

using Canvas = ChannelCanvas<kWidth, kHeight, kChannels>;

Canvas whole;
Canvas canvas;

Sink fill_sink;

constexpr Stroke kStroke(kFilterText,
                         Q6_10::from_raw(1024),
                         StrokePlace::inner);
constexpr StrokeAndFill kBoth(kStroke, &fill_sink);
constexpr Lcd kLcd;
constexpr Lcd kLcdVertical(SubPixels::bgr_vertical);
constexpr Bilevel kTwoLevels;
constexpr Bilevel kFourLevels(4);
constexpr Supersample kSupersample;
constexpr MotionBlur kBlur({Q26_6::from_raw(150), Q26_6::from_raw(-75)});
constexpr EdgeContrast kContrast;

struct Row {
  const char* name;
  const Effect* effect;
};

enum StyleKind : int32_t { kUpright, kTurned, kArea, kStyles };

Style style_of(int32_t kind, int32_t px) {
  const Q26_6 size = Q26_6::from_int(px);
  Style style;
  if (kind == kTurned) {
    Direction direction;
    direction.cosine.raw = 858993459;
    direction.sine.raw = 644245094;
    style = Style(size, kFilterText, direction);
  } else if (kind == kArea) {
    style = Style(size, kFilterArea);
  } else {
    style = Style(size, kFilterText);
  }
  return style;
}

// RAM and the sink's callbacks.
struct Terms {
  int32_t ram_bytes;
  bool takes_blocks;
  bool is_prepared;
};

void draw_part(const Style& style, const Rect& part, const Terms& terms) {
  const Sink sink = canvas.sink(part, terms.takes_blocks);
  const Workspace lent = {ram, static_cast<size_t>(terms.ram_bytes)};
  fill_sink = canvas.fill(part);
  if (terms.is_prepared) {
    PreparedGlyph glyph;
    CHECK_OK(PreparedGlyph::make(font, kLeaf, style, kOrigin, lent, glyph));
    glyph.draw(sink);
  } else {
    Painter(sink, lent).glyph(font, style, kOrigin, kLeaf);
  }
}

void draw_parts(const Style& style,
                int32_t columns,
                int32_t rows,
                const Terms& terms) {
  canvas.clear();
  for (int32_t y = 0; y < kHeight; y += rows) {
    for (int32_t x = 0; x < kWidth; x += columns) {
      draw_part(style, intersect(kAll, {x, y, x + columns, y + rows}), terms);
    }
  }
}

int32_t differing() {
  int32_t count = 0;
  for (size_t i = 0; i < sizeof(whole.pixels); ++i) {
    count += whole.pixels[i] != canvas.pixels[i] ? 1 : 0;
  }
  return count;
}

void check_row(const Row& row, int32_t kind) {
  constexpr Terms kAmple = {2560, false, false};
  constexpr Terms kTerms[] = {{0, false, false},
                              {0, true, false},
                              {1100, true, false},
                              {2560, false, true},
                              {2560, true, false}};
  constexpr int32_t kCuts[][2] = {
      {kWidth, kHeight}, {kWidth, 1}, {kWidth, 5}, {kWidth, 16}, {7, kHeight}};
  Style style = style_of(kind, 15);
  draw_parts(style, kWidth, kHeight, kAmple);
  whole = canvas;
  style.set_effect(*row.effect);
  CHECK_OK(font.check(style));
  draw_parts(style, kWidth, kHeight, kAmple);
  bool is_right = differing() > 20;
  whole = canvas;
  for (const auto& cut : kCuts) {
    for (const Terms& terms : kTerms) {
      draw_parts(style, cut[0], cut[1], terms);
      is_right &= differing() == 0;
    }
  }
  if (!is_right) {
    check::fail(__FILE__, __LINE__, row.name);
  }
}

// The mean of plain pictures at these places [1/64 px], by shares of 256, in
// `whole`.
struct Shift {
  int32_t right_q6;
  int32_t down_q6;
  int32_t share;
};
template <size_t kCount>
void draw_mean(const Style& style, const Shift (&shifts)[kCount]) {
  static uint16_t sums[kWidth * kHeight];
  for (uint16_t& sum : sums) {
    sum = 128;
  }
  for (const Shift& shift : shifts) {
    canvas.clear();
    Painter(canvas.sink(kAll, true), {ram, sizeof(ram)})
        .glyph(font, style,
               {Q26_6::from_raw(kOrigin.x.raw + shift.right_q6),
                Q26_6::from_raw(kOrigin.y.raw + shift.down_q6)},
               kLeaf);
    for (int32_t i = 0; i < kWidth * kHeight; ++i) {
      sums[i] = static_cast<uint16_t>(sums[i] + canvas.pixels[i * kChannels] *
                                                    shift.share);
    }
  }
  whole.clear();
  for (int32_t i = 0; i < kWidth * kHeight * kFill; ++i) {
    whole.pixels[i / kFill * kChannels + i % kFill] =
        static_cast<uint8_t>(sums[i / kFill] >> 8);
  }
}

// Changes of coverage to the left of a column and from there on.
struct Change {
  int32_t left;
  int32_t right;
};
Change change_of(uint16_t glyph,
                 int32_t px,
                 int32_t column,
                 const EdgeContrast& options) {
  Style style = style_of(kUpright, px);
  Canvas* const canvases[] = {&whole, &canvas};
  for (Canvas* each : canvases) {
    each->clear();
    Painter(each->sink(kAll, true), {ram, sizeof(ram)})
        .glyph(font, style, kOrigin, glyph);
    style.set_effect(options);
  }
  Change change = {0, 0};
  for (int32_t i = 0; i < kWidth * kHeight; ++i) {
    (i % kWidth < column ? change.left : change.right) +=
        canvas.pixels[i * kChannels] - whole.pixels[i * kChannels];
  }
  return change;
}

Picture<17, 15> drawn(uint16_t glyph, int32_t px, const Effect* effect) {
  Style style = style_of(kArea, px);
  if (effect != nullptr) {
    style.set_effect(*effect);
  }
  Picture<17, 15> picture;
  Painter(picture.sink(), {ram, sizeof(ram)})
      .glyph(font, style,
             {Q26_6::from_raw(2 * 64 + 20), Q26_6::from_raw(12 * 64 + 10)},
             glyph);
  return picture;
}

}  // namespace

TEST(every_effect_draws_the_same_picture_in_parts) {
  const Row rows[] = {{"stroke", &kStroke},
                      {"stroke and fill", &kBoth},
                      {"sub-pixels", &kLcd},
                      {"sub-pixels on each other", &kLcdVertical},
                      {"1 bit", &kTwoLevels},
                      {"2 bits", &kFourLevels},
                      {"supersampling", &kSupersample},
                      {"motion blur", &kBlur},
                      {"edge contrast", &kContrast},
                      {"own, of coverage", &own_effects::kHatch},
                      {"own, of distances", &own_effects::kHalo},
                      {"own, of neighbours", &own_effects::kRelief}};
  for (const Row& row : rows) {
    for (int32_t kind = 0; kind < kStyles; ++kind) {
      check_row(row, kind);
    }
  }
}

TEST(only_what_takes_fields_is_refused) {
  Style style = style_of(kUpright, 15);
  static constexpr CircleSamples kSamples(kFilterText);
  static uint32_t sums[kMinSplatSums];
  const Splat splat(sums);
  const Effect* const refused[] = {&kSamples, &splat};
  for (const Effect* effect : refused) {
    style.set_effect(*effect);
    CHECK_EQ(font.check(style), Status::unsupported);
    CHECK(is_empty(Painter().glyph_box(font, style, kOrigin, kDisc)));
  }
  style.clear_effect();
  CHECK_OK(font.check(style));
}

TEST(supersampling_is_the_mean_of_five_pictures) {
  constexpr Supersample kSoft(kPaperRadius);
  for (int32_t kind = 0; kind < kStyles; ++kind) {
    Style style = style_of(kind, 15);
    draw_mean(style, {{0, 0, 48},
                      {-32, -32, 52},
                      {-32, 32, 52},
                      {32, -32, 52},
                      {32, 32, 52}});
    style.set_effect(kSoft);
    draw_parts(style, kWidth, kHeight, {0, true, false});
    CHECK_EQ(differing(), 0);
  }
}

// A path of 2.625 px to the right and 1.3125 px up: seven pictures.
TEST(motion_blur_is_the_mean_of_pictures_along_the_path) {
  constexpr MotionBlur kLong({Q26_6::from_raw(168), Q26_6::from_raw(-84)});
  for (int32_t kind = 0; kind < kStyles; ++kind) {
    Style style = style_of(kind, 15);
    draw_mean(style, {{-72, 36, 36},
                      {-48, 24, 37},
                      {-24, 12, 36},
                      {0, 0, 37},
                      {24, -12, 36},
                      {48, -24, 37},
                      {72, -36, 37}});
    style.set_effect(kLong);
    draw_parts(style, kWidth, kHeight, {0, true, false});
    CHECK_EQ(differing(), 0);
  }
}

// 32 px to the left, which 40 are clamped to, and down: blurred pictures keep
// their ink, and nothing is cut off.
TEST(the_longest_path_keeps_the_ink) {
  constexpr MotionBlur kLongest({-40, 32});
  Style style = style_of(kArea, 15);
  Ink plain;
  Ink blurred;
  constexpr Rect kWide = {-40, -40, 80, 80};
  Painter(plain.sink(kWide)).glyph(font, style, kOrigin, kDisc);
  style.set_effect(kLongest);
  const Rect box = Painter().glyph_box(font, style, kOrigin, kDisc);
  Painter(blurred.sink(kWide)).glyph(font, style, kOrigin, kDisc);
  CHECK(plain.sum - blurred.sum < plain.sum / 20);
  CHECK(blurred.sum - plain.sum < plain.sum / 20);
  CHECK(box.x1 - box.x0 >= 9 + 32 && box.x1 - box.x0 <= 9 + 36);
  CHECK(box.y1 - box.y0 >= 9 + 32 && box.y1 - box.y0 <= 9 + 36);
}

// A bar from 200 to 440 u: its left edge darker, its right one lighter.
TEST(left_edges_of_outlines_are_darker_and_right_ones_lighter) {
  const Change change = change_of(kBar, 20, 13, EdgeContrast(90, 0));
  CHECK(change.left > 100);
  CHECK(change.right < -100);
  const int32_t sum = change.left + change.right;
  CHECK(sum < 60 && sum > -60);
}

// At 20 px the hairline of the frame is 0.2 px wide, its bars are 2 px.
TEST(only_thin_strokes_of_outlines_are_darker) {
  const Change change = change_of(kFrame, 20, 17, EdgeContrast(0, 128));
  CHECK_EQ(change.left, 0);
  CHECK(change.right > 100);
  // Nor are the tops of bowls, whose pixels have little ink on both sides.
  const Change of_disc = change_of(kDisc, 20, 17, EdgeContrast(0, 128));
  CHECK_EQ(of_disc.left, 0);
  CHECK_EQ(of_disc.right, 0);
}

TEST(supersampled_edges_are_soft) {
  CHECK_PICTURE_AT(drawn(kBar, 14, &kSupersample), 4, 3,
                   ":+++:\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":*#*+\n"
                   ":***:\n"
                   ":::::\n");
}

TEST(moving_discs_leave_a_trail) {
  constexpr MotionBlur kFast({4, -2});
  CHECK_PICTURE_AT(drawn(kDisc, 12, &kFast), 1, 3,
                   ".....:::::..\n"
                   "...:+++++::.\n"
                   ".::*****++:.\n"
                   "::+**#**++::\n"
                   "::+**##**+::\n"
                   "::+**##**+:.\n"
                   "::++**#*+::.\n"
                   ":::++**+:...\n"
                   ".::::::.....\n"
                   "...::.......\n");
}

TEST(lower_left_edges_are_darker) {
  constexpr EdgeContrast kMost(255, 255);
  CHECK_PICTURE_AT(drawn(kFrame, 16, nullptr), 3, 1,
                   "...........:\n"
                   "...........:\n"
                   "..........::\n"
                   ":::::::...:.\n"
                   "*#####+...:.\n"
                   "**+++#+..::.\n"
                   "**..:#+..:..\n"
                   "**..:#+.::..\n"
                   "**+++#+.::..\n"
                   "*#####+.:...\n"
                   ":::::::::...\n"
                   ".......:....\n");
  CHECK_PICTURE_AT(drawn(kFrame, 16, &kMost), 3, 1,
                   "...........:\n"
                   "...........+\n"
                   "..........::\n"
                   ":::::::...:.\n"
                   "*#####:...+.\n"
                   "*****#:..::.\n"
                   "**..:#:..:..\n"
                   "**..:#:.:+..\n"
                   "**:::#:.::..\n"
                   "*#####+.:...\n"
                   ":+++++:::...\n"
                   ".......:....\n");
}

TEST(programs_write_effects_of_their_own) {
  CHECK_PICTURE_AT(drawn(kFrame, 16, &own_effects::kHatch), 3, 1,
                   "...........:\n"
                   "...........:\n"
                   "..........::\n"
                   ":::::::...:.\n"
                   "*:::#::...:.\n"
                   ":::+:::..::.\n"
                   "::..::+..:..\n"
                   ":*..:#:..:..\n"
                   "*:::+::.::..\n"
                   ":::#:::.:...\n"
                   ":::::::::...\n"
                   ".......:....\n");
  CHECK_PICTURE_AT(drawn(kBar, 12, &own_effects::kHalo), 3, 3,
                   "######\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "#....#\n"
                   "######\n");
}
