// How far pictures of outlines are from the truth: areas against polygons that
// are cut exactly, coverage by distance against the nearest edge of all.
#include "check.hpp"
#include "inkcell/painter.hpp"
#include "outline_record.hpp"
#include "outline_truth.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using outline_record::OutlinePoint;

// [1/255]
constexpr int32_t kWorstArea = 5;
constexpr int32_t kWorstDistance = 16;
constexpr int32_t kWorstWide = 8;

constexpr int32_t kSide = 28;
constexpr int32_t kCorners = 7;

using outline_truth::Place;

alignas(4) uint8_t rom[768];
Picture<kSide, kSide> picture;
OutlinePoint points[kCorners];
Place corners[kCorners];  // on the screen
OutlinePoint rounded[3 * kCorners];
outline_truth::Truth truth;

// A star of seven corners about the middle of the em, none of them sharp.
void make_star(Random& random) {
  constexpr int16_t kWays[kCorners][2] = {{100, 0},  {62, 78},   {-22, 97},
                                          {-90, 43}, {-90, -43}, {-22, -97},
                                          {62, -78}};
  for (int32_t i = 0; i < kCorners; ++i) {
    const int32_t radius = random.between(250, 420);
    points[i] = {i == 0 ? outline_record::start : outline_record::corner,
                 static_cast<int16_t>(512 + kWays[i][0] * radius / 100),
                 static_cast<int16_t>(512 + kWays[i][1] * radius / 100)};
  }
}

// [px, Q6]
struct Setting {
  int32_t size;
  int32_t x;
  int32_t y;
};

template <typename FilterKind>
void draw_outline(Span<const OutlinePoint> outline,
                  const FilterKind& filter,
                  const Setting& at) {
  const outline_record::OutlineSource glyphs[] = {{600}, {600, outline}};
  const size_t size = outline_record::build_outline_font({glyphs, 2}, 0, 'A',
                                                         {rom, sizeof(rom)});
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  Style style(Q26_6::from_raw(at.size), filter);
  picture.clear();
  Painter(picture.sink())
      .glyph(font, style, {Q26_6::from_raw(at.x), Q26_6::from_raw(at.y)}, 1);
}

Setting random_setting(Random& random) {
  const int32_t size = random.between(10 * 64, 24 * 64);
  const int32_t x = random.between(0, 64);
  return {size, x, random.between(24 * 64, 25 * 64)};
}

template <typename FilterKind>
void draw(const FilterKind& filter, Random& random) {
  const Setting at = random_setting(random);
  draw_outline({points, kCorners}, filter, at);
  for (int32_t i = 0; i < kCorners; ++i) {
    corners[i] = {(at.x + points[i].x * at.size / 1024.0) / 64,
                  (at.y - points[i].y * at.size / 1024.0) / 64};
  }
}

double clamped(double value, double low, double high) {
  return value < low ? low : (value > high ? high : value);
}

// What an edge covers of a pixel's column below it, within the pixel.
double area_below(const Place& a, const Place& b, int32_t x, int32_t y) {
  const double x0 = clamped(a.x, x, x + 1);
  const double x1 = clamped(b.x, x, x + 1);
  if (x0 == x1) {
    return 0;
  }
  const double slope = (b.y - a.y) / (b.x - a.x);
  // Where it passes the pixel's upper and lower side.
  double cuts[4] = {x0, x0, x1, x1};
  if (slope != 0) {
    const double top = a.x + (y - a.y) / slope;
    const double bottom = a.x + (y + 1 - a.y) / slope;
    const bool is_forward = (x1 > x0) == (bottom > top);
    const double low = x0 < x1 ? x0 : x1;
    const double high = x0 < x1 ? x1 : x0;
    cuts[1] = clamped(is_forward ? top : bottom, low, high);
    cuts[2] = clamped(is_forward ? bottom : top, low, high);
  }
  double area = 0;
  for (int32_t i = 0; i < 3; ++i) {
    const double middle = a.y + slope * ((cuts[i] + cuts[i + 1]) / 2 - a.x);
    area += (cuts[i + 1] - cuts[i]) * (y + 1 - clamped(middle, y, y + 1));
  }
  return area;
}

double area_of(int32_t x, int32_t y) {
  double area = 0;
  for (int32_t i = 0; i < kCorners; ++i) {
    area += area_below(corners[i], corners[(i + 1) % kCorners], x, y);
  }
  return area < 0 ? -area : area;
}

// The worst pixel of the picture, beside the coverage that it should have, 0 to
// 1.
template <typename Coverage>
int32_t worst_of(const Coverage& coverage) {
  int32_t worst = 0;
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    const double error = picture.at(x, y) - 255 * coverage(x, y);
    const auto rounded_error = static_cast<int32_t>(magnitude(error) + 0.5);
    worst = rounded_error > worst ? rounded_error : worst;
  }
  return worst;
}

// The worst pixel by distance.
int32_t worst_distance(Span<const OutlinePoint> outline, const Setting& at) {
  draw_outline(outline, kFilterText, at);
  truth.set(outline, at.size / 65536.0, at.x / 64.0, at.y / 64.0);
  return worst_of([](int32_t x, int32_t y) {
    return clamped(0.5 + truth.distance(x + 0.5, y + 0.5), 0, 1);
  });
}

// Prints the worst pixel of several pictures, which must not be above `limit`.
struct Worst {
  const char* name;
  int32_t limit;
  int32_t error = 0;

  void add(int32_t each) { error = each > error ? each : error; }
  ~Worst() {
    CHECK(error <= limit);
    check::write(name);
    check::write_number(error);
    check::write("/255\n");
  }
};

// From a corner on the way to another one, `step` grid units along.
OutlinePoint beside(const OutlinePoint& from,
                    const OutlinePoint& to,
                    int32_t step) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double share = step / outline_truth::root(dx * dx + dy * dy);
  return {outline_record::smooth,
          static_cast<int16_t>(from.x + static_cast<int32_t>(dx * share)),
          static_cast<int16_t>(from.y + static_cast<int32_t>(dy * share))};
}

// A star whose corners are rounded off, some of them by less than a pixel.
void round_corners(Random& random) {
  for (int32_t i = 0; i < kCorners; ++i) {
    OutlinePoint* const at = rounded + 3 * i;
    at[0] = beside(points[i], points[(i + kCorners - 1) % kCorners],
                   random.between(2, 90));
    at[1] = {outline_record::off, points[i].x, points[i].y};
    at[2] =
        beside(points[i], points[(i + 1) % kCorners], random.between(2, 90));
  }
  rounded[0].kind = outline_record::start;
}

// A V in any direction, whose tip is the middle of the em.
OutlinePoint letter[4];
void make_letter(Random& random) {
  const int32_t a = random.between(-90, 90);
  const int32_t b = random.between(0, 1) == 0 ? 90 : -90;
  const int32_t opening = random.between(8, 50);
  const int32_t notch = random.between(60, 200);
  const auto set = [](int32_t i, int32_t x, int32_t y) {
    letter[i] = {i == 0 ? outline_record::start : outline_record::corner,
                 static_cast<int16_t>(512 + x), static_cast<int16_t>(512 + y)};
  };
  set(0, 0, 0);
  set(1, 4 * a + b * opening / 25, 4 * b - a * opening / 25);
  set(2, a * notch / 100, b * notch / 100);
  set(3, 4 * a - b * opening / 25, 4 * b + a * opening / 25);
}

// The middle of the em about that of the picture.
Setting setting_of(int32_t size, Random& random) {
  constexpr int32_t kMiddle = kSide * 32;
  return {size, kMiddle - size / 2 + random.between(0, 64),
          kMiddle + size / 2 + random.between(0, 64)};
}

constexpr int32_t kStars = INKCELL_BOARD_FIRMWARE ? 3 : 400;

}  // namespace

TEST(areas_are_exact) {
  Worst worst = {"worst area: ", kWorstArea};
  for (Random& random : Rounds(9, kStars)) {
    make_star(random);
    draw(kFilterArea, random);
    worst.add(worst_of(area_of));
  }
}

TEST(distances_are_those_of_the_nearest_edge) {
  Worst worst = {"worst distance: ", kWorstDistance};
  for (Random& random : Rounds(10, kStars)) {
    make_star(random);
    worst.add(worst_distance({points, kCorners}, random_setting(random)));
  }
}

// Letters like V in a large size: long edges that meet at acute corners, seen
// by a ramp that is wider than a pixel.
TEST(wide_ramps_are_true_at_acute_corners) {
  Worst worst = {"worst wide ramp: ", kWorstWide};
  for (Random& random : Rounds(11, kStars)) {
    make_letter(random);
    const Setting at = setting_of(random.between(30 * 64, 64 * 64), random);
    draw_outline(letter, kFilterPaperBody, at);
    truth.set(letter, at.size / 65536.0, at.x / 64.0, at.y / 64.0);
    worst.add(worst_of([](int32_t x, int32_t y) {
      const double q10 = 1024 * truth.distance(x + 0.5, y + 0.5);
      return kFilterPaperBody.coverage(
                 static_cast<int32_t>(clamped(q10, -4096, 4096))) /
             255.0;
    }));
  }
}

TEST(rounded_corners_are_as_near_as_they_are) {
  Worst worst = {"worst of rounded corners: ", kWorstDistance};
  for (Random& random : Rounds(11, kStars)) {
    make_star(random);
    round_corners(random);
    worst.add(worst_distance({rounded, 3 * kCorners}, random_setting(random)));
  }
}

// Two hairlines of a W: after a corner a curve of half a pixel ends in a line,
// exactly on a row of pixels. At 4 px 256 units are one.
TEST(hairlines_that_meet_on_a_row) {
  constexpr OutlinePoint kHairlines[] = {
      {outline_record::start, -75, 58},
      {outline_record::corner, -62, 123},
      {outline_record::off, -47, 46},
      {outline_record::smooth, -25, 0},
      {outline_record::corner, 1345, -3988},
      {outline_record::corner, -1469, -3988},
  };
  Worst worst = {"worst of hairlines: ", kWorstDistance};
  for (int32_t x = 0; x < 64; x += INKCELL_BOARD_FIRMWARE ? 16 : 1) {
    for (int32_t y = 28; y <= 36; y += 4) {
      worst.add(
          worst_distance({kHairlines, 6}, {4 * 64, 10 * 64 + x, 4 * 64 + y}));
    }
  }
}

// The point of a brace: a curve that turns back within half a pixel. At 4 px
// 256 units are one.
TEST(a_point_that_turns_within_a_pixel) {
  constexpr OutlinePoint kPoint[] = {
      {outline_record::start, -77, 499},
      {outline_record::off, 36, -148},
      {outline_record::corner, -422, -156},
      {outline_record::corner, -1422, -156},
      {outline_record::corner, -1422, 499},
  };
  Worst worst = {"worst of a point: ", kWorstDistance};
  for (int32_t x = 0; x < 64; x += INKCELL_BOARD_FIRMWARE ? 16 : 2) {
    for (int32_t y = 0; y < 64; y += INKCELL_BOARD_FIRMWARE ? 16 : 2) {
      worst.add(worst_distance({kPoint, 5}, {4 * 64, 10 * 64 + x, 4 * 64 + y}));
    }
  }
}
