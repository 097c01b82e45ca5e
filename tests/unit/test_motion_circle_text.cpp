// Text on a circle: glyphs where plain text has them at the top and the bottom,
// and evenly spaced all around.
#include "check.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/stroke.hpp"
#include "outline_font.hpp"
#include "picture.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;

const Font& font = outline_record::sample_font();

constexpr int32_t kSide = 160;
using Page = Picture<kSide, kSide, Overlap::greatest>;
Page drawn;
Page expected;
Sink sink_of(Page& page) {
  page.clear();
  return page.sink();
}

void draw(const Style& style, const TextCircle& circle, Text text) {
  draw_on_circle(sink_of(drawn), font, style, circle, text);
}

// The middle of the ink. [px, Q6]
Point middle_of(const Page& page) {
  int64_t x_sum = 0;
  int64_t y_sum = 0;
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    x_sum += int64_t{page.at(x, y)} * (64 * x + 32);
    y_sum += int64_t{page.at(x, y)} * (64 * y + 32);
  }
  const int32_t ink = page.ink();
  CHECK(ink > 0);
  return {Q26_6::from_raw(static_cast<int32_t>(x_sum / ink)),
          Q26_6::from_raw(static_cast<int32_t>(y_sum / ink))};
}

// Within 1/8 px.
bool is_near(Point a, Point b) {
  const int32_t dx = a.x.raw - b.x.raw;
  const int32_t dy = a.y.raw - b.y.raw;
  return dx * dx + dy * dy <= 64;
}

Angle turned(Angle angle, int32_t raw) {
  return Angle::from_raw(static_cast<uint16_t>(angle.raw + raw));
}

const Angle kTop = from_degrees(90);
const Angle kBottom = from_degrees(270);

TEST(glyphs_at_the_top_and_the_bottom_are_upright) {
  const Style style(24_px);
  const int32_t half = to_px(font, style, measure(font, "D").advance).raw / 2;
  const struct {
    Angle at;
    CircleSide side;
    int32_t baseline;
  } places[] = {{kTop, CircleSide::outside, 80 - 50},
                {kBottom, CircleSide::inside, 80 + 50}};
  for (const auto& place : places) {
    draw(style, {{80, 80}, 50_px, place.at, place.side}, "D");
    Painter(sink_of(expected))
        .text(
            font, style,
            {Q26_6::from_raw(80 * 64 - half), Q26_6::from_int(place.baseline)},
            "D");
    CHECK(expected.ink() > 0);
    CHECK(drawn == expected);
  }
}

// The example of docs/DRAW.md.
TEST(a_line_on_a_circle_is_one_call) {
  const Style style(16_px);
  const Sink sink = sink_of(drawn);
  const Painter painter(sink);
  const TextCircle rim = {{120, 120}, 100_px, from_degrees(90)};  // at the top
  draw_on_circle(painter, font, style, rim, "BAROMETER");
  CHECK(drawn.ink() > 0);
  const Rect box = draw_on_circle({}, font, style, rim, "BAROMETER");
  CHECK(box.y0 >= 120 - 100 - 16 && box.y1 < 120 && box.x0 < 120);
}

// All around: a quarter of a turn turns the ink about the centre.
TEST(lines_turn_about_the_centre) {
  const Style style(18_px);
  for (const CircleSide side :
       each_of({CircleSide::outside, CircleSide::inside})) {
    TextCircle circle = {{80, 80}, 50_px, from_degrees(20), side};
    draw(style, circle, "AFD");
    const Point first = middle_of(drawn);
    const int32_t ink = drawn.ink();
    circle.at = turned(circle.at, 1 << 14);
    draw(style, circle, "AFD");
    CHECK(is_near(middle_of(drawn),
                  Point(Q26_6::from_raw(first.y.raw),
                        Q26_6::from_raw(160 * 64 - first.x.raw))));
    CHECK(drawn.ink() > ink * 99 / 100 && drawn.ink() < ink * 101 / 100);
  }
}

// The anchors of a line are where its glyphs begin and end: on the circle that
// is a quarter of the em from the baseline, towards the heads.
TEST(lines_run_from_their_anchor) {
  const Style style(16_px);
  const int32_t units = measure(font, "AAA").advance;
  const int64_t px_q16 = to_px(font, style, units).raw << 10;
  for (const CircleSide side :
       each_of({CircleSide::outside, CircleSide::inside})) {
    const int32_t spaced = side == CircleSide::outside ? 54 : 46;
    // Clockwise outside.
    const auto turn =
        static_cast<int32_t>(px_q16 * 10000 / (62832 * spaced) *
                             (side == CircleSide::outside ? -1 : 1));
    TextCircle circle = {{80, 80}, 50_px, kTop, side, Anchor::left};
    draw(style, circle, "AAA");
    const Point by_start = middle_of(drawn);
    circle.anchor = Anchor::centre;
    circle.at = turned(kTop, turn / 2);
    draw(style, circle, "AAA");
    CHECK(is_near(middle_of(drawn), by_start));
    circle.anchor = Anchor::right;
    circle.at = turned(kTop, turn);
    draw(style, circle, "AAA");
    CHECK(is_near(middle_of(drawn), by_start));
    // The last of three letters alone.
    circle.anchor = Anchor::centre;
    circle.at = turned(kTop, turn * 5 / 6);
    draw(style, circle, "A");
    const Point last = middle_of(drawn);
    circle.anchor = Anchor::left;
    circle.at = turned(kTop, turn * 2 / 3);
    draw(style, circle, "A");
    CHECK(is_near(middle_of(drawn), last));
  }
}

TEST(boxes_hold_what_is_drawn) {
  Style style(16_px);
  const Stroke stroke(kFilterText, Q6_10::from_int(2));
  for (int32_t round = 0; round < 2; ++round) {
    for (int32_t degrees = 0; degrees < 360; degrees += 24) {
      const TextCircle circle = {{80, 80}, 50_px, from_degrees(degrees)};
      draw(style, circle, "ADEF");
      const Rect box = draw_on_circle({}, font, style, circle, "ADEF");
      CHECK(drawn.lies_in(box));
      CHECK(box.x1 - box.x0 < 70 && box.y1 - box.y0 < 70);
    }
    style.set_effect(stroke);
  }
}

TEST(any_circle_is_safe) {
  const Style style(kMaxSize);
  constexpr int32_t kRadii[] = {INT32_MIN, -64, 0, 1, 64, INT32_MAX};
  constexpr int32_t kCentres[] = {INT32_MIN, 0, INT32_MAX};
  for (const int32_t radius : kRadii) {
    for (const int32_t centre : kCentres) {
      for (uint8_t side = 0; side < 2; ++side) {
        const TextCircle circle = {
            {Q26_6::from_raw(centre), Q26_6::from_raw(centre)},
            Q26_6::from_raw(radius),
            Angle::from_raw(65535),
            static_cast<CircleSide>(side),
            Anchor::right};
        draw(style, circle, "ADEF");
        draw(style, circle, "");
      }
    }
  }
}

}  // namespace
