// Figures against a plain twin: 16 x 16 samples a pixel of what a figure is, by
// distances in integers; strips, RAM, boxes, canvases, and any input at all.
#include "inkcell/figures/figures.hpp"

#include "check.hpp"
#include "ink.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "picture.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::figures;
using motion::Angle;
using motion::from_degrees;

using Paper = Picture<40, 24>;

alignas(8) uint8_t ram[3072];

Q16_16 turns_of(int32_t degrees) {
  return Q16_16::from_raw(degrees * 65536 / 360);
}

// Coordinates of samples. [px, Q8]
struct Spot {
  int64_t x;
  int64_t y;
};
Spot spot(Point at) {
  return {int64_t{at.x.raw} * 4, int64_t{at.y.raw} * 4};
}
int64_t q8(Q26_6 length) {
  return int64_t{length.raw} * 4;
}
int64_t square(const Spot& at) {
  return at.x * at.x + at.y * at.y;
}
Spot apart(const Spot& a, const Spot& b) {
  return {a.x - b.x, a.y - b.y};
}
int64_t cross(const Spot& a, const Spot& b) {
  return a.x * b.y - a.y * b.x;
}
int64_t dot(const Spot& a, const Spot& b) {
  return a.x * b.x + a.y * b.y;
}

bool is_near(const Spot& at, const Spot& centre, int64_t radius) {
  return radius >= 0 && square(apart(at, centre)) <= radius * radius;
}
// The edge without its ends, and farther by `longer` at both.
bool is_beside(const Spot& at,
               const Spot& a,
               const Spot& b,
               int64_t half,
               int64_t longer = 0) {
  const Spot way = apart(b, a);
  const Spot from = apart(at, a);
  const int64_t length = square(way);
  const int64_t along = dot(from, way);
  const int64_t aside = cross(way, from);
  // along / |way| in [-longer, |way| + longer], and aside / |way| within half.
  const auto within = [&](int64_t value, int64_t limit) {
    return value <= 0 || value * value <= limit * limit * length;
  };
  return length != 0 && within(-along, longer) &&
         within(along - length, longer) &&
         aside * aside <= half * half * length;
}

// What `inside(sample)` covers of a pixel.
template <typename Inside>
int32_t truth_of(int32_t x, int32_t y, const Inside& inside) {
  int32_t count = 0;
  for (int32_t i = 0; i != 256; ++i) {
    count += inside(Spot{x * 256 + 7 + i % 16 * 16, y * 256 + 7 + i / 16 * 16})
                 ? 1
                 : 0;
  }
  return count * 255 / 256;
}

// The worst pixel of a figure, which must lie in the picture.
template <typename Inside>
int32_t error_of(const Figure& figure, const Pen* pen, const Inside& inside) {
  Paper paper;
  const auto draw = [&](const Painter& painter) {
    if (pen == nullptr) {
      fill(painter, figure);
    } else {
      stroke(painter, figure, *pen);
    }
  };
  draw(paper.sink());
  int32_t worst = 0;
  for (const auto [x, y] : pixels_of(paper.all())) {
    const int32_t error = magnitude(paper.at(x, y) - truth_of(x, y, inside));
    worst = error > worst ? error : worst;
  }
  // No pixel beyond the box, which is tight.
  const Rect box = pen == nullptr ? fill_box(figure) : stroke_box(figure, *pen);
  CHECK(paper.lies_in(box));
  Ink ink;
  draw(ink.sink());
  if (!is_empty(ink.box)) {
    CHECK(ink.box.x0 - box.x0 <= 2 && box.x1 - ink.box.x1 <= 2);
    CHECK(ink.box.y0 - box.y0 <= 2 && box.y1 - ink.box.y1 <= 2);
  }
  // Strips of any height and RAM of any size.
  constexpr int32_t kRows[] = {1, 5, 8};
  for (const int32_t rows : kRows) {
    Paper strips;
    const size_t size = rows == 1 ? 0 : rows == 5 ? 900 : sizeof ram;
    strips.draw_strips(rows, [&](const Sink& sink) {
      draw(Painter(sink, Workspace(ram, size)));
    });
    CHECK(strips == paper);
  }
  Paper parts;
  parts.draw_parts(7, 13, [&](const Sink& sink) { draw(sink); });
  CHECK(parts == paper);
  return worst;
}

// Of no figure more than the bound, but where its parts share a pixel.
constexpr int32_t kBound = 16;
constexpr int32_t kSharedBound = 128;

constexpr int32_t kRounds = INKCELL_BOARD_FIRMWARE ? 4 : 60;

Point any_point(Random& random) {
  return {Q26_6::from_raw(random.between(6 * 64, 34 * 64)),
          Q26_6::from_raw(random.between(6 * 64, 18 * 64))};
}

// docs/DRAW.md has this.
void draw_level(port::Rgb565Canvas& canvas, int32_t percent) noexcept {
  using namespace figures;
  const Painter painter(canvas);
  stroke(painter, rounded_rectangle({4, 4}, {60, 28}, 5_px), {2_px});
  fill(painter, rectangle({8, 8}, {8 + percent / 2, 24}));
  stroke(painter, circle({90, 16}, 10_px), {4_px});  // a ring
  const Figure part = arc({90, 16}, 10_px, motion::from_degrees(90),
                          Q16_16::from_raw(percent * -65536 / 100));
  canvas.set_colour(port::rgb565(80, 200, 120));
  stroke(painter, part, {4_px, Cap::round});  // clockwise from the top
}

}  // namespace

TEST(figures_of_whole_pixels_are_sharp) {
  Paper paper;
  fill(paper.sink(), rectangle({2, 1}, {6, 3}));
  paper.next_glyph();
  stroke(paper.sink(), rectangle({9, 2}, {15, 6}), {2_px});
  paper.next_glyph();
  stroke(paper.sink(), line({2.5_px, 5_px}, {2.5_px, 8_px}), {1_px});
  paper.next_glyph();
  stroke(paper.sink(), line({4.5_px, 7.5_px}, {6.5_px, 7.5_px}),
         {1_px, Cap::square});
  CHECK_PICTURE(paper,
                "\n"
                "..####..########\n"
                "..####..########\n"
                "........##....##\n"
                "........##....##\n"
                "..#.....########\n"
                "..#.....########\n"
                "..#.###\n");
}

TEST(rectangles_hold_what_they_cover) {
  for (Random& random : Rounds(1, kRounds)) {
    const Point a = any_point(random);
    const Point b = any_point(random);
    const Q26_6 radius = Q26_6::from_raw(random.between(0, 5 * 64));
    const Pen pen = {Q26_6::from_raw(random.between(32, 5 * 64))};
    const Spot low = {
        magnitude(0) + (spot(a).x < spot(b).x ? spot(a).x : spot(b).x),
        spot(a).y < spot(b).y ? spot(a).y : spot(b).y};
    const Spot high = {spot(a).x + spot(b).x - low.x,
                       spot(a).y + spot(b).y - low.y};
    const int64_t least =
        high.x - low.x < high.y - low.y ? high.x - low.x : high.y - low.y;
    // Grown by `by`, with corners of `round`.
    const auto holds = [&](const Spot& at, int64_t by, int64_t round) {
      round = round < 0 ? 0 : round;
      const auto outside = [&](int64_t place, int64_t from, int64_t to) {
        from += round - by;
        to += by - round;
        return place < from ? from - place : place > to ? place - to : 0;
      };
      return least + 2 * by > 0 && is_near({outside(at.x, low.x, high.x),
                                            outside(at.y, low.y, high.y)},
                                           {0, 0}, round);
    };
    CHECK(error_of(rectangle(a, b), nullptr,
                   [&](const Spot& at) { return holds(at, 0, 0); }) <= kBound);
    const int64_t round = q8(radius) < least / 2 ? q8(radius) : least / 2;
    const Figure rounded = rounded_rectangle(a, b, radius);
    CHECK(error_of(rounded, nullptr, [&](const Spot& at) {
            return holds(at, 0, round);
          }) <= kBound);
    const int64_t half = pen.width.raw / 2 * 4;
    CHECK(error_of(rectangle(a, b), &pen, [&](const Spot& at) {
            return holds(at, half, 0) && !holds(at, -half, 0);
          }) <= kBound);
    CHECK(error_of(rounded, &pen, [&](const Spot& at) {
            return holds(at, half, round == 0 ? 0 : round + half) &&
                   !holds(at, -half, round - half);
          }) <= kBound);
  }
}

TEST(circles_and_arcs_hold_what_they_cover) {
  for (Random& random : Rounds(2, kRounds)) {
    const Point centre = any_point(random);
    const Q26_6 radius = Q26_6::from_raw(random.between(0, 14 * 64));
    const auto from = Angle::from_raw(random.any());
    const int32_t sweep = random.between(-65536, 65536);
    const Pen pens[] = {
        {Q26_6::from_raw(random.between(32, 6 * 64))},
        {Q26_6::from_raw(random.between(32, 6 * 64)), Cap::round}};
    const Spot middle = spot(centre);
    const auto holds = [&](const Spot& at, int64_t by) {
      return is_near(at, middle, q8(radius) + by);
    };
    CHECK(error_of(circle(centre, radius), nullptr,
                   [&](const Spot& at) { return holds(at, 0); }) <= kBound);
    // Counter-clockwise from one direction to the other.
    const auto direction = [](int32_t raw) {
      const auto angle = Angle::from_raw(static_cast<uint16_t>(raw));
      return Spot{motion::cosine(angle).raw, -motion::sine(angle).raw};
    };
    const int32_t begin = from.raw + (sweep < 0 ? sweep : 0);
    const Spot first = direction(begin);
    const Spot last = direction(begin + magnitude(sweep));
    const auto is_between = [&](const Spot& at) {
      const Spot way = apart(at, middle);
      const bool after = cross(first, way) <= 0;
      const bool before = cross(last, way) >= 0;
      return magnitude(sweep) <= 32768 ? after && before : after || before;
    };
    const Figure part = arc(centre, radius, from, Q16_16::from_raw(sweep));
    CHECK(error_of(part, nullptr, [&](const Spot& at) {
            return holds(at, 0) && is_between(at);
          }) <= kBound);
    for (const Pen& pen : pens) {
      const int64_t half = pen.width.raw / 2 * 4;
      if (q8(radius) < half) {
        continue;  // ends cross the centre
      }
      const auto in_ring = [&](const Spot& at) {
        return holds(at, half) && !holds(at, -half - 1);
      };
      CHECK(error_of(circle(centre, radius), &pen, in_ring) <= kBound);
      const auto end = [&](const Spot& way) {
        return Spot{middle.x + way.x * q8(radius) / 16384,
                    middle.y + way.y * q8(radius) / 16384};
      };
      const int32_t error = error_of(part, &pen, [&](const Spot& at) {
        return (in_ring(at) && is_between(at)) ||
               (pen.cap == Cap::round && (is_near(at, end(first), half) ||
                                          is_near(at, end(last), half)));
      });
      // Where caps overlap, areas of one pixel add up.
      const bool is_apart = magnitude(sweep) < 49152 && q8(radius) > 2 * half;
      CHECK(error <=
            (is_apart || pen.cap == Cap::butt ? kBound : kSharedBound));
    }
  }
}

TEST(lines_have_caps) {
  constexpr Cap kCaps[] = {Cap::butt, Cap::round, Cap::square};
  for (Random& random : Rounds(3, kRounds)) {
    const Point a = any_point(random);
    const Point b = any_point(random);
    for (const Cap cap : kCaps) {
      const Pen pen = {Q26_6::from_raw(random.between(32, 6 * 64)), cap};
      const int64_t half = pen.width.raw / 2 * 4;
      const int64_t longer = cap == Cap::square ? half : 0;
      const int32_t error = error_of(line(a, b), &pen, [&](const Spot& at) {
        return is_beside(at, spot(a), spot(b), half, longer) ||
               (cap == Cap::round &&
                (is_near(at, spot(a), half) || is_near(at, spot(b), half)));
      });
      CHECK(error <= kBound);
    }
  }
  // A point: a dot, or nothing.
  Paper paper;
  stroke(paper.sink(), line({8, 8}, {8, 8}), {6_px});
  CHECK_EQ(paper.ink(), 0);
  CHECK(is_empty(stroke_box(line({8, 8}, {8, 8}), {6_px})));
  Paper dot;
  stroke(paper.sink(), line({8, 8}, {8, 8}), {6_px, Cap::round});
  fill(dot.sink(), circle({8, 8}, 3_px));
  CHECK(dot.ink() > 0 && paper.difference(dot) <= 2);
}

TEST(polygons_hold_what_they_wind_around) {
  for (Random& random : Rounds(4, kRounds)) {
    Point points[5];
    const size_t count = 3 + random.below(3);
    for (Point& point : points) {
      point = any_point(random);
    }
    const auto winding = [&](const Spot& at) {
      int32_t winds = 0;
      for (size_t i = 0; i != count; ++i) {
        const Spot from = apart(spot(points[i]), at);
        const Spot to = apart(spot(points[(i + 1) % count]), at);
        const bool down = from.y <= 0 && to.y > 0;
        const bool up = to.y <= 0 && from.y > 0;
        const int64_t side = cross(from, to);
        winds += down && side > 0 ? 1 : up && side < 0 ? -1 : 0;
      }
      return winds != 0;
    };
    const int32_t error = error_of(polygon({points, count}), nullptr, winding);
    // Edges that cross share pixels.
    CHECK(error <= (count == 3 ? kBound : kSharedBound));
    Paper closed;
    Paper open;
    fill(closed.sink(), polygon({points, count}));
    fill(open.sink(), polyline({points, count}));
    CHECK(open == closed);
  }
}

TEST(polygons_have_corners) {
  // Convex ones, whose stroke lies between parallels of all edges.
  constexpr Point kShapes[][4] = {
      {{8, 6}, {30.5_px, 7.25_px}, {28, 18}, {9.75_px, 16_px}},
      {{8, 17}, {20.3_px, 5.2_px}, {31_px, 16.5_px}, {31_px, 16.5_px}},
      {{10, 6}, {10, 6}, {26, 6}, {10, 18}}};
  constexpr Q26_6 kWidths[] = {1_px, 2.5_px, 3_px};
  for (const auto& points : kShapes) {
    for (const Q26_6 width : kWidths) {
      const Pen pen = {width};
      const int64_t half = pen.width.raw / 2 * 4;
      const auto reaches = [&](const Spot& at, int64_t by) {
        for (size_t i = 0; i != 4; ++i) {
          const Spot from = spot(points[i]);
          const Spot way = apart(spot(points[(i + 1) % 4]), from);
          const int64_t aside = cross(way, apart(at, from));
          const int64_t limit = by * by * square(way);
          const bool holds = by >= 0 ? aside >= 0 || aside * aside <= limit
                                     : aside >= 0 && aside * aside >= limit;
          if (!holds && square(way) != 0) {
            return false;
          }
        }
        return true;
      };
      Point back[4];
      for (size_t i = 0; i != 4; ++i) {
        back[i] = points[3 - i];
      }
      const Point* const ways[] = {points, back};
      for (const Point* way : ways) {
        CHECK(error_of(polygon({way, 4}), &pen, [&](const Spot& at) {
                return reaches(at, half) && !reaches(at, -half);
              }) <= kBound);
      }
    }
  }
}

TEST(polylines_follow_their_points) {
  for (Random& random : Rounds(5, kRounds)) {
    Point points[6];
    const size_t count = 2 + random.below(5);
    for (Point& point : points) {
      point = any_point(random);
    }
    points[3] = random.below(2) == 0 ? points[2] : points[3];
    const Pen pen = {Q26_6::from_raw(random.between(64, 5 * 64)), Cap::round,
                     Join::round};
    const int64_t half = pen.width.raw / 2 * 4;
    const int32_t error =
        error_of(polyline({points, count}), &pen, [&](const Spot& at) {
          for (size_t i = 0; i != count; ++i) {
            if (is_near(at, spot(points[i]), half) ||
                (i != 0 &&
                 is_beside(at, spot(points[i - 1]), spot(points[i]), half))) {
              return true;
            }
          }
          return false;
        });
    CHECK(error <= kSharedBound);
  }
}

TEST(curves_of_points_are_even) {
  // A plot: edges that are long enough for the inner side of each corner.
  Point points[8];
  for (Random& random : Rounds(7, kRounds)) {
    for (int32_t i = 0; i != 8; ++i) {
      points[i] = {Q26_6::from_raw((4 + 4 * i) * 64 + 10),
                   Q26_6::from_raw(random.between(8 * 64, 15 * 64))};
    }
    const Pen pen = {1.5_px, Cap::butt, Join::round};
    const int32_t error = error_of(polyline(points), &pen, [&](const Spot& at) {
      for (size_t i = 0; i != 8; ++i) {
        if ((i != 0 && i != 7 && is_near(at, spot(points[i]), 192)) ||
            (i != 0 &&
             is_beside(at, spot(points[i - 1]), spot(points[i]), 192))) {
          return true;
        }
      }
      return false;
    });
    CHECK(error <= kBound);
  }
}

TEST(overlaps_saturate) {
  // A line there and back, 40 times: as one.
  Point points[81];
  for (size_t i = 0; i != 81; ++i) {
    points[i] = {i % 2 == 0 ? 6 : 30, 12};
  }
  Paper once;
  Paper often;
  stroke(once.sink(), line(points[0], points[1]), {4_px});
  stroke(often.sink(), polyline(points), {4_px});
  CHECK(once.ink() == 24 * 4 * 255 && once == often);
}

template <typename Canvas, typename... Ink>
int32_t count_bytes(size_t bytes_per_row, int32_t rows_per_stride, Ink... ink) {
  uint8_t whole[32 * 24 * 2] = {};
  uint8_t strips[32 * 24 * 2] = {};
  const auto stride = static_cast<int32_t>(bytes_per_row);
  const auto draw = [](const Painter& painter) {
    stroke(painter, arc({16, 12}, 8_px, from_degrees(200), turns_of(-220)),
           {4_px, Cap::round});
    fill(painter, rectangle({14, 10}, {18, 14}));
  };
  const auto size_of = [&](int32_t rows) {
    return bytes_per_row * static_cast<size_t>(rows / rows_per_stride);
  };
  draw(Canvas(Strip{{whole, size_of(24)}, 0, 0, 32, 24, stride}, ink...));
  for (int32_t y = 0; y != 24; y += 8) {
    draw(Canvas(Strip{{strips + size_of(y), size_of(8)}, 0, y, 32, 8, stride},
                ink...));
  }
  int32_t drawn = 0;
  for (size_t i = 0; i != sizeof whole; ++i) {
    CHECK_EQ(whole[i], strips[i]);
    drawn += whole[i] != 0 ? 1 : 0;
  }
  return drawn;
}

TEST(all_canvases_draw_figures) {
  using namespace port;
  CHECK(count_bytes<MonoPagesCanvas>(32, 8) > 25);
  CHECK(count_bytes<MonoRowsCanvas>(4, 1) > 20);
  CHECK(count_bytes<Grey2Canvas>(8, 1) > 40);
  CHECK(count_bytes<Grey4Canvas>(16, 1) > 80);
  CHECK(count_bytes<Grey8Canvas>(32, 1) > 100);
  CHECK(count_bytes<Rgb565Canvas>(64, 1, rgb565(255, 255, 255)) > 200);
}

TEST(figures_have_the_colour_of_the_canvas) {
  static uint8_t pixels[104 * 32 * 2];
  port::Rgb565Canvas canvas(Strip{pixels, 0, 0, 104, 32, 208});
  draw_level(canvas, 40);
  const auto pixel = [](int32_t x, int32_t y) {
    return pixels[208 * y + 2 * x] | pixels[208 * y + 2 * x + 1] << 8;
  };
  CHECK_EQ(pixel(30, 4), 0xffff);
  CHECK_EQ(pixel(27, 16), 0xffff);
  CHECK_EQ(pixel(28, 16), 0);
  CHECK_EQ(pixel(99, 16), port::rgb565(80, 200, 120));  // a quarter
  CHECK_EQ(pixel(80, 16), 0xffff);                      // three quarters
  CHECK_EQ(pixel(90, 16), 0);
}

TEST(nothing_is_drawn_of_nothing) {
  const Figure figures[] = {{},
                            arc({16, 12}, 8_px, {}, {}),
                            circle({16, 12}, {}),
                            polygon({}),
                            rectangle({3, 3}, {3, 9}),
                            circle({16, 12}, Q26_6::from_raw(-64))};
  for (const Figure& figure : figures) {
    Paper paper;
    fill(paper.sink(), figure);
    stroke(paper.sink(), figure, {});
    stroke(paper.sink(), figure, {Q26_6::from_raw(-64)});
    CHECK_EQ(paper.ink(), 0);
    CHECK(is_empty(fill_box(figure)) && is_empty(stroke_box(figure, {})));
  }
  // No point is no dot.
  constexpr Pen kRound = {4_px, Cap::round, Join::round};
  const Figure pointless[] = {{}, polygon({}), polyline({})};
  for (const Figure& figure : pointless) {
    CHECK(is_empty(stroke_box(figure, kRound)));
  }
}

TEST(any_figure_is_safe) {
  for (Random& random : Rounds(6, 8 * kRounds)) {
    const auto length = [&] {
      const uint32_t kind = random.below(4);
      return Q26_6::from_raw(
          kind == 0   ? random.any()
          : kind == 1 ? random.between(-64, 64)
          : kind == 2 ? random.between(0, 40 * 64)
                      : (random.below(2) == 0 ? INT32_MAX : INT32_MIN));
    };
    Point points[6];
    for (Point& point : points) {
      point = {length(), length()};
    }
    Figure figure;
    switch (random.below(5)) {
      case 0:
        figure = rounded_rectangle(points[0], points[1], length());
        break;
      case 1:
        figure = arc(points[0], length(), Angle::from_raw(random.any()),
                     Q16_16::from_raw(random.any()));
        break;
      case 2:
        figure = line(points[0], points[1]);
        break;
      case 3:
        figure = polygon({points, random.below(7)});
        break;
      default:
        figure = polyline({points, random.below(7)});
    }
    const Pen pen = {length(), static_cast<Cap>(random.below(3)),
                     static_cast<Join>(random.below(2))};
    const int32_t rows = 1 + static_cast<int32_t>(random.below(7));
    const Workspace some(ram, random.below(sizeof ram));
    Paper filled;
    Paper stroked;
    fill(filled.sink(), figure);
    stroke(stroked.sink(), figure, pen);
    Paper strips;
    strips.draw_strips(
        rows, [&](const Sink& sink) { fill(Painter(sink, some), figure); });
    CHECK(strips == filled && filled.lies_in(fill_box(figure)));
    strips.clear();
    strips.draw_strips(rows, [&](const Sink& sink) {
      stroke(Painter(sink, some), figure, pen);
    });
    CHECK(strips == stroked && stroked.lies_in(stroke_box(figure, pen)));
  }
}
