// Painters of LCD text, outlines and crisp text: what they draw, and that
// windows do not change it.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/crisp.hpp"
#include "inkcell/effects.hpp"
#include "inkcell/lcd.hpp"
#include "rounds.hpp"

#if INKCELL_EDGE_CELLS

namespace {

using namespace inkcell;

constexpr int32_t kSide = INKCELL_BOARD_FIRMWARE ? 20 : 40;
constexpr int32_t kRounds = INKCELL_BOARD_FIRMWARE ? 40 : 300;
// What must be found at least, so that a test is worth something: few windows
// of boards show much.
constexpr int32_t kSome = INKCELL_BOARD_FIRMWARE ? 4 : 75;

alignas(4) uint8_t bytes[1024];
FieldRecord record;

// Three coverages a pixel, alike where a sink is given one.
using Pixels = uint8_t[3 * kSide * kSide];
Pixels picture;
Pixels second;  // of the fill

// Keeps what is drawn; fails if pixels leave the window or come twice.
struct Canvas {
  Rect window;
  Rect shown;  // the part that may be drawn to
  uint8_t* pixels;
  uint8_t drawn[kSide * kSide / 8];  // a bit a pixel

  Canvas(const Rect& all, Pixels& target)
      : window(all), shown(all), pixels(target) {
    for (int32_t i = 0; i < 3 * kSide * kSide; ++i) {
      pixels[i] = 0;
    }
    show(all);
  }
  void show(const Rect& part) {
    shown = part;
    for (uint8_t& eight : drawn) {
      eight = 0;
    }
  }
  Sink grey_sink() { return {shown, this, coverage, solid}; }
  Sink rgb_sink() {
    return {shown, this, coverage, solid, nullptr, coverage_rgb};
  }

  // The coverages of a pixel: kept by nobody if it is out of place.
  uint8_t* put(int32_t x, int32_t y) {
    static uint8_t nobody[3];
    const bool fits =
        y >= shown.y0 && y < shown.y1 && x >= shown.x0 && x < shown.x1;
    CHECK(fits && "pixels inside the window");
    if (!fits) {
      return nobody;
    }
    const int32_t i = (y - window.y0) * kSide + x - window.x0;
    const int32_t bit = 1 << i % 8;
    CHECK((drawn[i / 8] & bit) == 0 && "no pixel twice");
    drawn[i / 8] = static_cast<uint8_t>(drawn[i / 8] | bit);
    return pixels + 3 * i;
  }
  static void draw(void* context,
                   int32_t x,
                   int32_t y,
                   const uint8_t* coverage,
                   int32_t count,
                   int32_t channels) {
    CHECK(count >= 1);
    for (int32_t i = 0; i < count; ++i) {
      uint8_t* pixel = static_cast<Canvas*>(context)->put(x + i, y);
      for (int32_t j = 0; j < 3; ++j) {
        pixel[j] = channels == 0   ? uint8_t{255}
                   : channels == 1 ? coverage[i]
                                   : coverage[3 * i + j];
      }
    }
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    CHECK(count <= kMaxSpan);
    draw(context, x, y, coverage, count, 1);
  }
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* coverage,
                           int32_t count) {
    CHECK(count <= kMaxSpan);
    draw(context, x, y, coverage, count, 3);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    draw(context, x, y, nullptr, count, 0);
  }
};

GlyphField open() {
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

GlyphField any_field(Random& random) {
  record = FieldRecord();
  record.linked = (random.next() & 1) != 0;
  record.tile_log2 = static_cast<uint8_t>(6 + random.below(4));
  record.tiles_x = static_cast<uint8_t>(1 + random.below(3));
  record.tiles_y = static_cast<uint8_t>(1 + random.below(3));
  record.x0_u = static_cast<int16_t>(random.between(-300, 100));
  record.y0_u = static_cast<int16_t>(random.between(-300, 100));
  record.make(random, 1 << (record.tile_log2 - 1));
  return open();
}

TextStyle style_of(int32_t size_q6, const Filter& filter, bool turned = false) {
  Direction turn;
  if (turned) {
    turn.cosine.raw = 858993459;
    turn.sine.raw = -644245094;
  }
  TextStyle style;
  CHECK_OK(TextStyle::make(Q26_6::from_raw(size_q6), filter, turn, style));
  return style;
}

FinePoint any_origin(Random& random) {
  return {random.between(-9999, 9999), random.between(-9999, 9999)};
}

Rect window_in(Random& random, const Rect& box) {
  const int32_t x0 = random.between(box.x0 - 3, box.x1 + 2);
  const int32_t y0 = random.between(box.y0 - 3, box.y1 + 2);
  return {x0, y0, x0 + random.between(1, kSide), y0 + random.between(1, kSide)};
}

int32_t distance_q10(const GlyphField& field,
                     const TextStyle& style,
                     FinePoint origin,
                     int32_t x,
                     int32_t y) {
  Q6_10 distance;
  distance_row(field, style, origin, x, y, {&distance, 1});
  return distance.raw;
}

// Calls check(x, y, coverages) for every pixel of a window.
template <typename Check>
void for_pixels(const Rect& window, const Check& check) {
  for (int32_t y = window.y0; y < window.y1; ++y) {
    for (int32_t x = window.x0; x < window.x1; ++x) {
      const int32_t i = 3 * ((y - window.y0) * kSide + x - window.x0);
      check(x, y, i);
    }
  }
}

const Outline kOutline =
    make_outline(kFilterText, Q6_10::from_raw(1500), OutlinePlace::outer);

// Draws in one piece and in many, and compares. `fill`: the second picture too.
void check_windows(const GlyphField& field,
                   const TextStyle& style,
                   const FinePoint& origin,
                   OutlineAndFill* both) {
  static Pixels whole;
  static Pixels whole_second;
  const Rect box = field_box(field, style, origin);
  const Rect all = {box.x0 + 1, box.y0 + 1, box.x0 + 1 + kSide,
                    box.y0 + 1 + kSide};
  for (int32_t cut = kSide; cut > 0; cut = cut * 2 / 3) {
    Canvas canvas(all, picture);
    Canvas fill(all, second);
    const int32_t x = all.x0 + cut;
    for (int32_t y = all.y0; y < all.y1; y += cut) {
      const Rect halves[] = {{all.x0, y, x, y + cut}, {x, y, all.x1, y + cut}};
      for (const Rect& half : halves) {
        canvas.show(intersect(all, half));
        fill.show(intersect(all, half));
        const Sink fill_sink = fill.grey_sink();
        if (both != nullptr) {
          both->fill = &fill_sink;
        }
        draw_field(field, style, origin, canvas.rgb_sink());
      }
    }
    for (int32_t i = 0; i < 3 * kSide * kSide; ++i) {
      if (cut == kSide) {
        whole[i] = picture[i];
        whole_second[i] = second[i];
      }
      CHECK_EQ(picture[i], whole[i]);
      CHECK_EQ(second[i], whole_second[i]);
    }
  }
}

}  // namespace

TEST(windows_change_no_style) {
  for (Rounds rounds(51, kRounds / 2); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    GlyphField field = any_field(random);
    const auto side = [&random](int32_t least_u) {
      return static_cast<int16_t>(random.between(least_u, least_u + 200));
    };
    field.ink = {side(field.x0_u), side(field.y0_u), side(field.x0_u + 200),
                 side(field.y0_u + 200)};
    const bool is_turned = round % 3 == 0;
    const bool is_outlined = round % 2 == 0;
    TextStyle style =
        style_of(random.between(8 * 64, 48 * 64),
                 is_outlined ? kOutline.outer : kFilterText, is_turned);
    OutlineAndFill both = {&kOutline.inner, nullptr};
    LcdOptions lcd = {static_cast<SubPixels>(random.below(4)),
                      static_cast<uint8_t>(255 - random.below(2) * 100)};
    CrispOptions crisp = {static_cast<uint8_t>(random.below(2) * 2 + 2), {}};
    if (is_outlined) {
      style.set_effect(outline_and_fill_effect(both));
    } else if (round % 4 == 1) {
      style.set_effect(lcd_effect(lcd));
    } else {
      style.set_effect(crisp_effect(crisp));
    }
    const FinePoint origin = any_origin(random);
    check_windows(field, style, origin, is_outlined ? &both : nullptr);
    if (is_outlined) {
      style.set_effect(outline_effect(kOutline.inner));
      check_windows(field, style, origin, nullptr);
    }
  }
}

// What a stripe covers, `stripe` thirds of a pixel beside the middle of pixel
// (x, y), by the gradient that the 2 most + 1 stripes around it say.
double stripe_coverage(const GlyphField& field,
                       const TextStyle& style,
                       const FinePoint& origin,
                       bool is_down,
                       int32_t most,
                       int32_t x,
                       int32_t y,
                       int32_t stripe) {
  double d[5];
  for (int32_t i = -most; i <= most; ++i) {
    const int32_t way = -341 * i;  // the origin goes the other way
    const FinePoint moved(origin.x_q10 + (is_down ? 0 : way),
                          origin.y_q10 + (is_down ? way : 0));
    d[i + most] = distance_q10(field, style, moved, x, y) / 1024.0;
  }
  double slope = 0;
  for (int32_t i = 1; i <= 2 * most; ++i) {
    const double change =
        3 * (d[i] < d[i - 1] ? d[i - 1] - d[i] : d[i] - d[i - 1]);
    slope = change > slope ? change : slope;
  }
  slope = slope > 1 ? 1 : slope;
  double way = slope / 3 + field_equation::root(1 - slope * slope);
  way = slope >= 1 ? 1 / 3.0 : way;
  const double covered = 0.5 + d[stripe + most] / way;
  return covered < 0 ? 0 : covered > 1 ? 255 : 255 * covered;
}

TEST(channels_are_means_of_three_stripes) {
  int32_t coloured = 0;
  int32_t compared = 0;
  int32_t far = 0;
  for (Rounds rounds(52, kRounds); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const GlyphField field = any_field(random);
    TextStyle style =
        style_of(random.between(8 * 64, 48 * 64), kFilterText, round % 3 == 0);
    const LcdOptions lcd = {static_cast<SubPixels>(round % 4)};
    style.set_effect(lcd_effect(lcd));
    const FinePoint origin = any_origin(random);
    const Rect window = window_in(random, field_box(field, style, origin));
    Canvas canvas(window, picture);
    draw_field(field, style, origin, canvas.rgb_sink());
    const bool is_down = round % 4 >= 2;
    const bool red_first = round % 2 == 0;
    // Turned, those beside a pixel are looked at from there.
    const bool is_alone = is_down && round % 3 == 0;
    for_pixels(window, [&](int32_t x, int32_t y, int32_t i) {
      const auto stripe = [&](int32_t number) {
        if (is_alone) {
          return stripe_coverage(field, style, origin, true, 2, x, y, number);
        }
        const int32_t pixel = number < -1 ? -1 : number > 1 ? 1 : 0;
        return stripe_coverage(field, style, origin, is_down, 1,
                               x + (is_down ? 0 : pixel),
                               y + (is_down ? pixel : 0), number - 3 * pixel);
      };
      for (int32_t number = -1; number <= 1; ++number) {
        const double expected =
            (stripe(number - 1) + stripe(number) + stripe(number + 1)) / 3;
        const int32_t channel = red_first ? 1 + number : 1 - number;
        const double error = picture[i + channel] - expected;
        far += error < -12 || error > 12 ? 1 : 0;
        ++compared;
      }
      coloured += picture[i] != picture[i + 2] ? 1 : 0;
    });
  }
  CHECK(coloured > kSome);
  // Fields of any kind jump from cell to cell: few pixels see that.
  CHECK(far * (INKCELL_BOARD_FIRMWARE ? 25 : 100) < compared);
}

// Fields of a linked record may say so.
TEST(greater_of_a_field_and_itself_is_that_field) {
  namespace linked = format::linked;
  record = FieldRecord();
  record.linked = true;
  record.line_count = 1;
  record.pair_count = 1;
  record.references[0] = record.pair_reference(0);
  record.fields[0] = {16384, 0, -100 * 16, 0, 0};
  const GlyphField field = open();
  for (int32_t round = 0; round < 2; ++round) {
    const LcdOptions lcd = {round == 0 ? SubPixels::rgb
                                       : SubPixels::rgb_vertical};
    TextStyle style = style_of(16 * 64, kFilterText);
    style.set_effect(lcd_effect(lcd));
    const Rect window = {-1, -4, 5, 1};
    Canvas least(window, picture);
    bytes[11] = static_cast<uint8_t>(linked::kMinPair << 5);
    draw_field(field, style, {}, least.rgb_sink());
    Canvas greatest(window, second);
    bytes[11] = static_cast<uint8_t>(linked::kMaxPair << 5);
    draw_field(field, style, {}, greatest.rgb_sink());
    int32_t sum = 0;
    for_pixels(window, [&](int32_t, int32_t, int32_t i) {
      for (int32_t channel = 0; channel < 3; ++channel) {
        CHECK_EQ(second[3 * i + channel], picture[3 * i + channel]);
        sum += picture[3 * i + channel];
      }
    });
    CHECK(sum > 0);
  }
}

TEST(less_colour_leaves_the_mean) {
  for (Rounds rounds(53, kRounds / 4); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const GlyphField field = any_field(random);
    TextStyle style = style_of(random.between(8 * 64, 48 * 64), kFilterText);
    LcdOptions lcd;
    style.set_effect(lcd_effect(lcd));
    const FinePoint origin = any_origin(random);
    const Rect window = window_in(random, field_box(field, style, origin));
    Canvas full(window, picture);
    draw_field(field, style, origin, full.rgb_sink());
    lcd.colour = static_cast<uint8_t>(round % 2 * 128);
    Canvas faded(window, second);
    draw_field(field, style, origin, faded.rgb_sink());
    for_pixels(window, [&](int32_t, int32_t, int32_t i) {
      const int32_t mean = (picture[i] + picture[i + 1] + picture[i + 2]) / 3;
      for (int32_t j = i; j < i + 3; ++j) {
        const int32_t kept =
            mean + (picture[j] - mean) * int32_t{lcd.colour} / 255;
        CHECK(second[j] >= kept - 2 && second[j] <= kept + 2);
      }
    });
    Canvas grey(window, picture);
    lcd.colour = 0;
    draw_field(field, style, origin, grey.grey_sink());
    for_pixels(window, [&](int32_t, int32_t, int32_t i) {
      CHECK(round % 2 != 0 || picture[i] == second[i]);
    });
  }
}

// A black stroke along the stripes gives as much light to red as to green and
// blue, wherever it stands: from some way off it is grey.
TEST(strokes_along_stripes_are_grey_as_a_whole) {
  record = FieldRecord();
  record.line_count = 2;
  record.pair_count = 1;
  record.pairs[0][1] = 1;
  record.references[0] = record.pair_reference(0);
  for (int32_t round = 0; round < 22; ++round) {
    const bool is_down = round % 2 != 0;
    const int32_t width_u = 25 + 5 * (round - (is_down ? 1 : 0));
    const auto nx = static_cast<int16_t>(is_down ? 0 : 16384);
    const auto ny = static_cast<int16_t>(16384 - nx);
    record.fields[0] = {nx, ny, -100 * 16, 0, 0};
    record.fields[1] = {static_cast<int16_t>(-nx), static_cast<int16_t>(-ny),
                        static_cast<int16_t>((100 + width_u) * 16), 0, 0};
    const GlyphField field = open();
    TextStyle style = style_of(16 * 64, kFilterText);
    const LcdOptions lcd = {is_down ? SubPixels::rgb_vertical : SubPixels::rgb};
    style.set_effect(lcd_effect(lcd));
    for (int32_t shift = 0; shift < 1024; shift += 37) {
      Canvas canvas(is_down ? Rect{2, -8, 3, 4} : Rect{-4, -3, 8, -2}, picture);
      draw_field(field, style, {is_down ? 0 : shift, is_down ? shift : 0},
                 canvas.rgb_sink());
      int32_t sums[3] = {};
      for_pixels(canvas.window, [&](int32_t, int32_t, int32_t i) {
        for (int32_t channel = 0; channel < 3; ++channel) {
          sums[channel] += picture[i + channel];
        }
      });
      for (const int32_t sum : sums) {
        const int32_t error = sum - 255 * width_u / 64;
        CHECK(error >= -6 && error <= 6);
        CHECK(sum - sums[0] <= 2 && sums[0] - sum <= 2);
      }
    }
  }
}

// Distances of effects are those of distance_row to half of a 127th of the
// reach, and their ramps are cut to 1/256: up to 2.5 px, which is the most
// here, of slopes up to 1.1 a px.
constexpr int32_t kMostError = 4;

bool is_near(int32_t found, int32_t expected) {
  const int32_t error = found - expected;
  return error <= kMostError && error >= -kMostError;
}

TEST(outlines_are_what_lies_between_two_filters) {
  int32_t grey = 0;
  for (Rounds rounds(54, kRounds); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    const GlyphField field = any_field(random);
    const Outline outline = make_outline(
        kFilterPaperBody,
        Q6_10::from_raw(static_cast<int16_t>(random.between(100, 2048))),
        static_cast<OutlinePlace>(round % 3));
    TextStyle style = style_of(random.between(8 * 64, 48 * 64), outline.outer,
                               round % 4 == 0);
    style.set_effect(outline_effect(outline.inner));
    const FinePoint origin = any_origin(random);
    const Rect window = window_in(random, field_box(field, style, origin));
    Canvas canvas(window, picture);
    draw_field(field, style, origin, canvas.grey_sink());
    OutlineAndFill both = {&outline.inner, nullptr};
    for_pixels(window, [&](int32_t x, int32_t y, int32_t i) {
      const int32_t d = distance_q10(field, style, origin, x, y);
      const int32_t covered =
          outline.outer.coverage(d) - outline.inner.coverage(d);
      CHECK(is_near(picture[i], covered));
      grey += covered > 0 ? 1 : 0;
    });
    style.set_effect(outline_and_fill_effect(both));
    Canvas edges(window, picture);
    Canvas insides(window, second);
    const Sink fill = insides.grey_sink();
    both.fill = &fill;
    draw_field(field, style, origin, edges.grey_sink());
    for_pixels(window, [&](int32_t x, int32_t y, int32_t i) {
      const int32_t d = distance_q10(field, style, origin, x, y);
      const uint8_t filled = outline.inner.coverage(d);
      CHECK(is_near(second[i], filled));
      CHECK(is_near(picture[i],
                    second[i] == 255 ? 0 : outline.outer.coverage(d)));
    });
  }
  CHECK(grey > kSome);
}

// Nothing that the ink's box lets show is left out, and all that is farther is.
TEST(painters_stay_close_to_the_ink) {
  int32_t kept = 0;
  int32_t left_out = 0;
  for (Rounds rounds(55, kRounds); rounds.next();) {
    Random& random = rounds.random;
    GlyphField field = any_field(random);
    const int32_t size_q6 = random.between(8 * 64, 48 * 64);
    TextStyle style = style_of(size_q6, kOutline.outer);
    style.set_effect(outline_effect(kOutline.inner));
    const FinePoint origin = any_origin(random);
    const Rect window = window_in(random, field_box(field, style, origin));
    Canvas all(window, picture);
    draw_field(field, style, origin, all.grey_sink());
    InkBox& ink = field.ink;
    ink.x0_u = static_cast<int16_t>(random.between(-300, 400));
    ink.y0_u = static_cast<int16_t>(random.between(-300, 400));
    ink.x1_u = static_cast<int16_t>(ink.x0_u + random.between(1, 400));
    ink.y1_u = static_cast<int16_t>(ink.y0_u + random.between(1, 400));
    Canvas some(window, second);
    draw_field(field, style, origin, some.grey_sink());
    // From the nearer side of the ink, what lies beyond the filter's reach.
    const auto beyond = [size_q6](int64_t way_q10, int32_t low, int32_t high) {
      const int64_t below = low * int64_t{size_q6} / 64 - way_q10;
      const int64_t above = way_q10 - high * int64_t{size_q6} / 64;
      return (below > above ? below : above) + kOutline.outer.outside_q10;
    };
    for_pixels(window, [&](int32_t x, int32_t y, int32_t i) {
      const int64_t right =
          beyond(x * 1024 + 512 - origin.x_q10, ink.x0_u, ink.x1_u);
      const int64_t up =
          beyond(origin.y_q10 - y * 1024 - 512, ink.y0_u, ink.y1_u);
      const int64_t most = right > up ? right : up;
      if (most < -4) {
        CHECK_EQ(second[i], picture[i]);
        kept += picture[i] != 0 ? 1 : 0;
      } else if (most > 4) {
        CHECK_EQ(second[i], 0);
        left_out += picture[i] != 0 ? 1 : 0;
      }
    });
  }
  CHECK(kept > kSome);
  CHECK(left_out > kSome);
}

TEST(outlines_lie_where_they_are_asked_for) {
  const Q6_10 width = Q6_10::from_int(2);
  const struct {
    OutlinePlace place;
    int32_t from_q10;  // where the outline is full, from half a pixel inwards
    int32_t to_q10;
  } cases[] = {{OutlinePlace::outer, -2048, 0},
               {OutlinePlace::centred, -1024, 1024},
               {OutlinePlace::inner, 0, 2048}};
  for (const auto& c : cases) {
    const Outline outline = make_outline(kFilterText, width, c.place);
    for (int32_t d = -4096; d <= 4096; d += 16) {
      const int32_t covered =
          outline.outer.coverage(d) - outline.inner.coverage(d);
      if (d >= c.from_q10 + 512 && d <= c.to_q10 - 512) {
        CHECK_EQ(covered, 255);
      } else if (d <= c.from_q10 - 512 || d >= c.to_q10 + 512) {
        CHECK_EQ(covered, 0);
      } else {
        CHECK(covered >= 0 && covered <= 255);
      }
    }
  }
}

TEST(shadows_and_glows_fade) {
  const Filter shadow = shadow_filter(Q6_10::from_int(3));
  CHECK_EQ(shadow.outside_q10, -3072);
  CHECK_EQ(shadow.inside_q10, 3072);
  CHECK(shadow.coverage(0) >= 126 && shadow.coverage(0) <= 129);
  const Filter glow = glow_filter(Q6_10::from_int(2));
  CHECK_EQ(glow.outside_q10, -2048);
  CHECK_EQ(glow.coverage(0), 255);
  CHECK(glow.coverage(-1024) >= 62 && glow.coverage(-1024) <= 66);
}

TEST(effects_beyond_the_band_are_refused) {
  FontRange range;
  range.band_u = 128;  // 2 px at 16 px
  const Q26_6 size = Q26_6::from_int(16);
  const auto reach = [](int32_t q10) {
    return shadow_filter(Q6_10::from_raw(static_cast<int16_t>(q10)));
  };
  CHECK_OK(check_reach(range, size, kFilterText));
  CHECK_OK(check_reach(range, size, reach(2048)));
  CHECK_EQ(check_reach(range, size, reach(2080)), Status::beyond_band);
  CHECK_OK(check_reach(range, Q26_6::from_int(32), reach(4096)));
  CHECK_OK(check_reach(range, Q26_6::from_int(1024), reach(4096)));
  CHECK_EQ(check_reach(range, Q26_6::from_int(8),
                       glow_filter(Q6_10::from_raw(1100))),
           Status::beyond_band);
  // A cutoff inside counts like one outside.
  const Filter deep = with_weight(kFilterText, Q6_10::from_raw(-2000));
  CHECK_EQ(check_reach(range, size, deep), Status::beyond_band);
}

#endif
