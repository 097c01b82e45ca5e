// Styles of outline fonts: weights, glows, strokes, bilevel text, sub-pixels.
#include "channel_canvas.hpp"
#include "check.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "outline_font.hpp"
#include "outline_truth.hpp"
#include "picture.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using outline_record::OutlinePoint;

const Font& font = outline_record::sample_font();

constexpr int32_t kWidth = 32;
constexpr int32_t kHeight = 28;
constexpr int32_t kChannels = 3;

// Where the glyph's origin is. [1/64 px]
constexpr int32_t kX = 6 * 64 + 13;
constexpr int32_t kY = 21 * 64 + 40;
constexpr int32_t kSizePx = 18;
alignas(4) uint8_t ram[2560];

const Span<const OutlinePoint> kShapes[] = {{},
                                            outline_record::kDisc,
                                            outline_record::kBar,
                                            outline_record::kEll,
                                            outline_record::kFrame,
                                            outline_record::kLeaf};

// The glyph's edges, until the next call.
const outline_truth::Truth& truth_of(uint16_t glyph) {
  static outline_truth::Truth truth;
  truth.set(kShapes[glyph], kSizePx / 1024.0, kX / 64.0, kY / 64.0);
  return truth;
}

using Canvas = ChannelCanvas<kWidth, kHeight, kChannels>;

constexpr Rect kAll = {0, 0, kWidth, kHeight};
Canvas canvas;
Canvas other;
Canvas fill_canvas;

constexpr Point kOrigin = {Q26_6::from_raw(kX), Q26_6::from_raw(kY)};

Style style_of(const Filter& filter) {
  return Style(Q26_6::from_int(kSizePx), filter);
}
Style style_of(const Effect& effect) {
  Style style = style_of(kFilterText);
  style.set_effect(effect);
  return style;
}

void draw(uint16_t glyph, const Style& style, Canvas& out) {
  out.clear();
  Painter(out.sink(kAll), {ram, sizeof(ram)})
      .glyph(font, style, kOrigin, glyph);
}

// How far coverage may be from a picture of true distances.
struct Bound {
  int32_t worst;
  int32_t mean_q8;
};

// A pixel that may be anything.
constexpr int32_t kUnknown = -1;

// Compares the canvas with coverage(distance in Q10).
template <typename Coverage>
void check_truth(const Canvas& drawn,
                 uint16_t glyph,
                 const Bound& bound,
                 const Coverage& coverage) {
  const outline_truth::Truth& truth = truth_of(glyph);
  int32_t worst = 0;
  int32_t sum = 0;
  int32_t inked = 0;
  for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
    double distance = truth.distance(x + 0.5, y + 0.5) * 1024;
    distance = distance < -8000 ? -8000 : (distance > 8000 ? 8000 : distance);
    const int32_t wanted = coverage(static_cast<int32_t>(distance));
    const int32_t error =
        wanted == kUnknown ? 0 : magnitude(drawn.at(x, y) - wanted);
    worst = error > worst ? error : worst;
    sum += error;
    inked += wanted != 0 ? 1 : 0;
  }
  CHECK(inked > 0);
  CHECK(worst <= bound.worst);
  CHECK(sum * 256 <= bound.mean_q8 * inked);
}

void check_filter(const Filter& filter, const Bound& bound) {
  const Style style = style_of(filter);
  for (uint16_t glyph = 1; glyph <= 5; ++glyph) {
    draw(glyph, style, canvas);
    check_truth(canvas, glyph, bound,
                [&filter](int32_t d) { return filter.coverage(d); });
  }
}

constexpr Stroke kStroke(kFilterText, Q6_10::from_raw(1024));
constexpr Stroke kOuter(kFilterText, Q6_10::from_raw(1500), StrokePlace::outer);

// Whether both canvases hold one picture.
void check_same() {
  for (size_t i = 0; i < sizeof(canvas.pixels); ++i) {
    CHECK_EQ(canvas.pixels[i], other.pixels[i]);
  }
}

// Whether a picture is the same in strips of any height, with any RAM.
void check_strips(uint16_t glyph, const Style& style) {
  draw(glyph, style, canvas);
  constexpr size_t kBytes[] = {0, 900, 2560};
  for (const int32_t rows : each_of({1, 3, 16})) {
    for (const size_t bytes : kBytes) {
      other.clear();
      for (int32_t y = 0; y < kHeight; y += rows) {
        const Rect part = intersect(kAll, {0, y, kWidth, y + rows});
        Painter(other.sink(part), {ram, bytes})
            .glyph(font, style, kOrigin, glyph);
      }
      check_same();
      if (check::failed()) {
        return;
      }
    }
  }
}

// A channel of the canvas as a picture.
using Small = Picture<26, 24>;
void show(const Canvas& drawn, int32_t channel, Small& out) {
  const Sink sink = out.sink();
  for (const auto [x, y] : pixels_of(26, 24)) {
    const int32_t index = Canvas::index(x + 2, y + 2) + channel;
    sink.coverage(sink.context, x, y, &drawn.pixels[index], 1);
  }
}

}  // namespace

TEST(weights_shadows_and_glows_are_those_of_true_distances) {
  check_filter(with_weight(kFilterText, Q6_10::from_raw(300)), {20, 1024});
  check_filter(with_weight(kFilterText, Q6_10::from_raw(-300)), {20, 1024});
  check_filter(shadow_filter(Q6_10::from_int(2)), {20, 1024});
  check_filter(glow_filter(Q6_10::from_int(4)), {20, 1024});
}

TEST(strokes_are_what_lies_between_two_filters) {
  const Stroke* const strokes[] = {&kStroke, &kOuter};
  for (const Stroke* stroke : strokes) {
    const Style style = style_of(*stroke);
    for (uint16_t glyph = 1; glyph <= 5; ++glyph) {
      draw(glyph, style, canvas);
      check_truth(canvas, glyph, {24, 2048}, [stroke](int32_t d) {
        const int32_t covered =
            stroke->outer.coverage(d) - stroke->inner.coverage(d);
        return covered > 0 ? covered : 0;
      });
    }
  }
  const Style style = style_of(kStroke);
  draw(5, style, canvas);
  Small leaf;
  show(canvas, 0, leaf);
  CHECK_PICTURE_AT(leaf, 5, 6,
                   "..........::\n"
                   "......:+****\n"
                   "....:+*+:::*\n"
                   "...:*+:...:*\n"
                   "..:*:.....++\n"
                   ".:*:......*:\n"
                   ".++......:*.\n"
                   ":*:......++.\n"
                   "+*......:*:.\n"
                   "++.....:*:..\n"
                   "*:....+*+...\n"
                   "*::++**:....\n"
                   "***++:......\n");
}

TEST(fills_lie_within_strokes) {
  for (uint16_t glyph = 1; glyph <= 5; ++glyph) {
    fill_canvas.clear();
    const Sink fill = fill_canvas.sink(kAll);
    const StrokeAndFill both(kOuter, &fill);
    const Style style = style_of(both);
    draw(glyph, style, canvas);
    check_truth(fill_canvas, glyph, {20, 1024},
                [](int32_t d) { return kOuter.inner.coverage(d); });
    check_truth(canvas, glyph, {24, 2048}, [](int32_t d) {
      // Where the fill may be solid or not there is no telling.
      const int32_t filled = kOuter.inner.coverage(d);
      return filled > 235 && d < 560 ? kUnknown
             : filled == 255         ? 0
                                     : kOuter.outer.coverage(d);
    });
  }
}

TEST(bilevel_text_is_what_lies_within_the_threshold) {
  for (const int32_t threshold : each_of({0, -300})) {
    const Bilevel bilevel(2, Q6_10::from_raw(static_cast<int16_t>(threshold)));
    const Style style = style_of(bilevel);
    for (uint16_t glyph = 1; glyph <= 5; ++glyph) {
      const outline_truth::Truth& truth = truth_of(glyph);
      draw(glyph, style, canvas);
      for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
        const double d = truth.distance(x + 0.5, y + 0.5) * 1024;
        const uint8_t drawn = canvas.at(x, y);
        CHECK(drawn == 0 || drawn == 255);
        if (d > threshold + 40) {
          CHECK_EQ(drawn, 255);
        } else if (d < threshold - 40 && drawn != 0) {
          // Only where a stroke passes by.
          CHECK(d > -552);
        }
      }
    }
  }
}

TEST(thin_strokes_stay_connected) {
  const Bilevel two;
  const Bilevel four(4);
  const Style style = style_of(two);
  draw(4, style, canvas);
  Small bilevel;
  show(canvas, 0, bilevel);
  CHECK_PICTURE_AT(bilevel, 5, 7,
                   ".............#\n"
                   "............#.\n"
                   "............#.\n"
                   "............#.\n"
                   "...........#..\n"
                   "#######....#..\n"
                   "##....#....#..\n"
                   "##....#...#...\n"
                   "##....#...#...\n"
                   "##....#..#....\n"
                   "#######..#....\n"
                   "#######..#....\n"
                   "........#.....\n");
  draw(4, style_of(four), canvas);
  Small greys;
  show(canvas, 0, greys);
  CHECK_PICTURE_AT(greys, 5, 7,
                   ".............+\n"
                   "............+.\n"
                   "............+.\n"
                   "............+.\n"
                   "::::::::...+..\n"
                   "+######:...+..\n"
                   "+#::::#:...+..\n"
                   "+#...:#:..+...\n"
                   "+#...:#:..+...\n"
                   "+#::::#:.+....\n"
                   "+######:.+....\n"
                   "+++++++:.+....\n"
                   "........+.....\n");
}

TEST(sub_pixels_are_means_of_exact_thirds) {
  constexpr SubPixels kOrders[] = {SubPixels::rgb, SubPixels::bgr,
                                   SubPixels::rgb_vertical,
                                   SubPixels::bgr_vertical};
  for (const SubPixels order : kOrders) {
    const bool is_down =
        order == SubPixels::rgb_vertical || order == SubPixels::bgr_vertical;
    const bool is_red_first =
        order == SubPixels::rgb || order == SubPixels::rgb_vertical;
    const Lcd lcd(order);
    const Style style = style_of(lcd);
    // Thirds as pixels of a picture that is three times as wide or high.
    const auto em = Q16_16::from_raw(kSizePx << 16);
    const auto thrice = Q16_16::from_raw(3 * kSizePx << 16);
    const Matrix matrix = {
        is_down ? em : thrice, {}, {}, is_down ? thrice : em};
    Style thirds(matrix, kFilterArea);
    const Point origin = {Q26_6::from_raw(kX * (is_down ? 1 : 3)),
                          Q26_6::from_raw(kY * (is_down ? 3 : 1))};
    for (uint16_t glyph = 1; glyph <= 5; ++glyph) {
      draw(glyph, style, canvas);
      static uint8_t exact[3 * kWidth * kHeight + 2 * kWidth];
      static Rect window;
      for (uint8_t& third : exact) {
        third = 0;
      }
      window = is_down ? Rect{0, 0, kWidth, 3 * kHeight}
                       : Rect{0, 0, 3 * kWidth, kHeight};
      const Sink sink = {window, nullptr,
                         [](void*, int32_t x, int32_t y, const uint8_t* values,
                            int32_t count) {
                           for (int32_t i = 0; i < count; ++i) {
                             exact[kWidth + y * window.x1 + x + i] = values[i];
                           }
                         },
                         [](void*, int32_t x, int32_t y, int32_t count) {
                           for (int32_t i = 0; i < count; ++i) {
                             exact[kWidth + y * window.x1 + x + i] = 255;
                           }
                         }};
      Painter(sink).glyph(font, thirds, origin, glyph);
      const int32_t step = is_down ? kWidth : 1;
      for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
        const uint8_t* at =
            exact + kWidth +
            (is_down ? 3 * y * kWidth + x : y * window.x1 + 3 * x);
        for (int32_t i = 0; i < 3; ++i, at += step) {
          const int32_t mean = (at[-step] + at[0] + at[step]) / 3;
          const int32_t drawn =
              canvas.pixels[Canvas::index(x, y) + (is_red_first ? i : 2 - i)];
          CHECK(magnitude(drawn - mean) <= 4);
        }
      }
    }
  }
}

TEST(sub_pixels_have_their_colours) {
  const Lcd lcd;
  const Style style = style_of(lcd);
  draw(2, style, canvas);
  Small red;
  Small blue;
  show(canvas, 0, red);
  show(canvas, 2, blue);
  CHECK_PICTURE_AT(red, 8, 8,
                   "++++:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "*###:\n"
                   "++++:\n");
  CHECK_PICTURE_AT(blue, 7, 8,
                   "+++++\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+###+\n"
                   "+++++\n");
  // No colour: all channels are the mean.
  const Lcd grey(SubPixels::rgb, 0);
  draw(2, style_of(grey), other);
  for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
    const uint8_t* rgb = &canvas.pixels[Canvas::index(x, y)];
    const int32_t mean = (rgb[0] + rgb[1] + rgb[2]) / 3;
    for (int32_t i = 0; i < 3; ++i) {
      CHECK(magnitude(other.pixels[Canvas::index(x, y) + i] - mean) <= 1);
    }
  }
}

TEST(strips_and_ram_change_no_style) {
  const Bilevel two(2, Q6_10::from_raw(-100));
  const Bilevel four(4);
  const Lcd across;
  const Lcd down(SubPixels::bgr_vertical, 200);
  const Effect* const effects[] = {&kOuter, &two, &four, &across, &down};
  const Filter glow = glow_filter(Q6_10::from_int(4));
  const Filter bold = with_weight(kFilterText, Q6_10::from_raw(300));
  for (uint16_t glyph = 1; glyph <= 6; ++glyph) {
    check_strips(glyph, style_of(glow));
    check_strips(glyph, style_of(bold));
    for (const Effect* effect : effects) {
      check_strips(glyph, style_of(*effect));
    }
  }
}

TEST(turned_and_leaning_glyphs_have_styles_too) {
  const Lcd lcd;
  const Bilevel bilevel;
  const Matrix matrix = {Q16_16::from_raw(17 << 16), Q16_16::from_raw(5 << 16),
                         Q16_16::from_raw(-(3 << 16)),
                         Q16_16::from_raw(16 << 16)};
  Style style(matrix, kFilterText);
  const Effect* const effects[] = {&kStroke, &lcd, &bilevel};
  for (const Effect* effect : effects) {
    style.set_effect(*effect);
    check_strips(3, style);
  }
  Small ell;
  show(canvas, 0, ell);
  CHECK_PICTURE_AT(ell, 4, 7,
                   "#.........\n"
                   "##........\n"
                   "##........\n"
                   "##........\n"
                   "##........\n"
                   ".#........\n"
                   ".#........\n"
                   ".##.......\n"
                   ".##.....#.\n"
                   ".##..#####\n"
                   "..#####...\n"
                   "..##......\n");
}
