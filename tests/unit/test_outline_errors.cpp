// How far pictures of outlines are from the truth: areas against polygons that
// are cut exactly, coverage by distance against the nearest edge of all.
#include "check.hpp"
#include "inkcell/text.hpp"
#include "outline_record.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using outline_record::OutlinePoint;

// Of 255.
constexpr int32_t kWorstArea = 5;
constexpr int32_t kWorstDistance = 16;

constexpr int32_t kSide = 28;
constexpr int32_t kCorners = 7;

struct Place {
  double x;
  double y;
};

alignas(4) uint8_t rom[768];
uint8_t picture[kSide][kSide];
OutlinePoint points[kCorners];
Place corners[kCorners];  // on the screen

void put(void* /*context*/,
         int32_t x,
         int32_t y,
         const uint8_t* coverage,
         int32_t count) {
  for (int32_t i = 0; i < count; ++i) {
    picture[y][x + i] = coverage[i];
  }
}
void fill(void* /*context*/, int32_t x, int32_t y, int32_t count) {
  for (int32_t i = 0; i < count; ++i) {
    picture[y][x + i] = 255;
  }
}

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

template <typename FilterKind>
void draw(const FilterKind& filter, Random& random) {
  const outline_record::OutlineSource glyphs[] = {{600},
                                                  {600, {points, kCorners}}};
  const size_t size = outline_record::build_outline_font({glyphs, 2}, 0, 'A',
                                                         {rom, sizeof(rom)});
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  TextStyle style;
  const int32_t size_q6 = random.between(10 * 64, 24 * 64);
  CHECK_OK(TextStyle::make(Q26_6::from_raw(size_q6), filter, style));
  const int32_t x_q6 = random.between(0, 64);
  const int32_t y_q6 = random.between(24 * 64, 25 * 64);
  for (auto& row : picture) {
    for (uint8_t& pixel : row) {
      pixel = 0;
    }
  }
  draw_glyph(font, 1, style, {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)},
             {{0, 0, kSide, kSide}, nullptr, put, fill});
  for (int32_t i = 0; i < kCorners; ++i) {
    corners[i] = {(x_q6 + points[i].x * size_q6 / 1024.0) / 64,
                  (y_q6 - points[i].y * size_q6 / 1024.0) / 64};
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

double root_of(double value) {
  double root = value > 1 ? value : 1;
  for (int32_t i = 0; i < 40; ++i) {
    root = (root + value / root) / 2;
  }
  return root;
}

// Signed, from the middle of a pixel. [px]
double distance_of(int32_t x, int32_t y) {
  const Place p = {x + 0.5, y + 0.5};
  double least = 1e9;
  bool is_inside = false;
  for (int32_t i = 0; i < kCorners; ++i) {
    const Place& a = corners[i];
    const Place& b = corners[(i + 1) % kCorners];
    const Place way = {b.x - a.x, b.y - a.y};
    const double t = clamped(((p.x - a.x) * way.x + (p.y - a.y) * way.y) /
                                 (way.x * way.x + way.y * way.y),
                             0, 1);
    const Place off = {p.x - a.x - t * way.x, p.y - a.y - t * way.y};
    const double square = off.x * off.x + off.y * off.y;
    least = square < least ? square : least;
    if ((a.y > p.y) != (b.y > p.y) &&
        p.x < a.x + (p.y - a.y) / (b.y - a.y) * way.x) {
      is_inside = !is_inside;
    }
  }
  return is_inside ? root_of(least) : -root_of(least);
}

int32_t error_of(int32_t x, int32_t y, double coverage) {
  const double error = picture[y][x] - 255 * coverage;
  return static_cast<int32_t>((error < 0 ? -error : error) + 0.5);
}

constexpr int32_t kStars = INKCELL_BOARD_FIRMWARE ? 3 : 400;

}  // namespace

TEST(areas_are_exact) {
  int32_t worst = 0;
  for (Rounds rounds(9, kStars); rounds.next();) {
    Random& random = rounds.random;
    make_star(random);
    draw(kFilterArea, random);
    for (int32_t y = 0; y < kSide; ++y) {
      for (int32_t x = 0; x < kSide; ++x) {
        const int32_t error = error_of(x, y, area_of(x, y));
        worst = error > worst ? error : worst;
      }
    }
  }
  CHECK(worst <= kWorstArea);
  check::write("worst area: ");
  check::write_number(worst);
  check::write("/255\n");
}

TEST(distances_are_those_of_the_nearest_edge) {
  int32_t worst = 0;
  for (Rounds rounds(10, kStars); rounds.next();) {
    Random& random = rounds.random;
    make_star(random);
    draw(kFilterText, random);
    for (int32_t y = 0; y < kSide; ++y) {
      for (int32_t x = 0; x < kSide; ++x) {
        const double coverage = clamped(0.5 + distance_of(x, y), 0, 1);
        const int32_t error = error_of(x, y, coverage);
        worst = error > worst ? error : worst;
      }
    }
  }
  CHECK(worst <= kWorstDistance);
  check::write("worst distance: ");
  check::write_number(worst);
  check::write("/255\n");
}
