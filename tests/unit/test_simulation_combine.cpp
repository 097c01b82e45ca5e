// Shapes combined while they are drawn, against the exact area that they cover
// of each pixel.
#include "check.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/simulation/combine.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;

constexpr int32_t kSide = 40;
constexpr int32_t kFine = 16;  // points of a pixel's side in the oracle
constexpr double kMiddle = kSide / 2.0;

int8_t first_samples[kSide * kSide];
int8_t second_samples[kSide * kSide];

// What lies between two parallel lines; one may be far away.
struct Strip {
  double nx = 1;  // points inwards
  double ny = 0;
  double low = 0;  // from the middle of the picture
  double high = 100;

  double distance(double x, double y) const {
    const double along = (x - kMiddle) * nx + (y - kMiddle) * ny;
    return along - low < high - along ? along - low : high - along;
  }
};

Strip strip(int32_t angle, double low, double high) {
  const Angle turn = Angle::from_raw(static_cast<uint16_t>(angle));
  Strip result;
  result.nx = cosine(turn).raw / 16384.0;
  result.ny = sine(turn).raw / 16384.0;
  result.low = low;
  result.high = high;
  return result;
}

DistanceGrid fill(const Strip& shape, int8_t (&samples)[kSide * kSide]) {
  const DistanceGrid grid(samples, kSide, kSide, 0);
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    // Sample s holds distances of s / 32 to (s + 1) / 32.
    const double fine = 32 * shape.distance(x + 0.5, y + 0.5) + 1024;
    const auto whole = static_cast<int32_t>(fine < 0 ? 0 : fine) - 1024;
    samples[y * kSide + x] = static_cast<int8_t>(whole < -128  ? -128
                                                 : whole > 127 ? 127
                                                               : whole);
  }
  return grid;
}

bool holds(Combine how, bool a, bool b) {
  return how == Combine::intersect  ? a && b
         : how == Combine::subtract ? a && !b
                                    : a || b;
}

// What is covered of a pixel. [1/255]
double exact(
    Combine how, const Strip& a, const Strip& b, int32_t x, int32_t y) {
  // Half a diagonal and more from all lines, every point is like the middle.
  const double first = a.distance(x + 0.5, y + 0.5);
  const double second = b.distance(x + 0.5, y + 0.5);
  if (magnitude(first) > 0.75 && magnitude(second) > 0.75) {
    return holds(how, first > 0, second > 0) ? 255 : 0;
  }
  int32_t inside = 0;
  for (int32_t i = 0; i < kFine * kFine; ++i) {
    const double px = x + (i % kFine + 0.5) / kFine;
    const double py = y + (i / kFine + 0.5) / kFine;
    inside +=
        holds(how, a.distance(px, py) > 0, b.distance(px, py) > 0) ? 1 : 0;
  }
  return 255.0 * inside / (kFine * kFine);
}

struct Worst {
  double combined = 0;  // of draw_combined
  double plain = 0;     // of the least or greatest coverage
};

// Away from the grids' borders.
Worst compare(Combine how, const Strip& a, const Strip& b) {
  const DistanceGrid first = fill(a, first_samples);
  const DistanceGrid second = fill(b, second_samples);
  const GridPart parts[] = {{&first, {}, {}}, {&second, {}, {}, how}};
  Picture<kSide, kSide> picture;
  draw_combined(parts, kFilterText, picture.sink());
  Worst worst;
  for (const auto [x, y] : pixels_of({6, 6, kSide - 6, kSide - 6})) {
    const double truth = exact(how, a, b, x, y);
    const double error = magnitude(picture.at(x, y) - truth);
    worst.combined = error > worst.combined ? error : worst.combined;
    const int32_t one = first.at(x, y);
    const int32_t other =
        how == Combine::subtract ? -second.at(x, y) : second.at(x, y);
    const int32_t most = one > other ? one : other;
    const int32_t least = one > other ? other : one;
    const int32_t chosen = how == Combine::unite ? most : least;
    const double plain =
        magnitude(kFilterText.coverage(chosen * 32 + 16) - truth);
    worst.plain = plain > worst.plain ? plain : worst.plain;
  }
  return worst;
}

// Two strips side by side that overlap by up to 1.25 px are one.
TEST(seams_are_not_pale) {
  double combined = 0;
  double plain = 0;
  const int32_t angles = INKCELL_BOARD_FIRMWARE ? 2 : 9;
  for (int32_t i = 0; i < angles; ++i) {
    for (int32_t overlap = 0; overlap <= 10; ++overlap) {
      const double seam = 0.37;
      const Worst worst =
          compare(Combine::unite, strip(i * 1820, seam - overlap / 8.0, 9),
                  strip(i * 1820, -9, seam));
      combined = worst.combined > combined ? worst.combined : combined;
      plain = worst.plain > plain ? worst.plain : plain;
    }
  }
  check::write("seams, worst pixel of 255: ");
  check::write_number(static_cast<int64_t>(combined));
  check::write(", by maxima ");
  check::write_number(static_cast<int64_t>(plain));
  check::write("\n");
  CHECK(combined <= 16);
  CHECK(plain > 100);  // else there would be nothing to mend
}

// What is left between two cuts as thin as that.
TEST(slits_are_not_dark) {
  double combined = 0;
  for (int32_t i = 0; i < 4; ++i) {
    for (int32_t width = 0; width <= 8; ++width) {
      // All but a strip, and all but the one beside it.
      const Worst worst =
          compare(Combine::subtract, strip(i * 2730, 0.21 - width / 8.0, 100),
                  strip(i * 2730, 0.21, 100));
      combined = worst.combined > combined ? worst.combined : combined;
    }
  }
  CHECK(combined <= 32);
}

TEST(edges_at_any_angle_cover_their_area) {
  constexpr Combine kAll[] = {Combine::unite, Combine::intersect,
                              Combine::subtract};
  Random random(9);
  const int32_t rounds = INKCELL_BOARD_FIRMWARE ? 3 : 150;
  for (const Combine how : kAll) {
    double combined = 0;
    double plain = 0;
    for (int32_t i = 0; i < rounds; ++i) {
      const Worst worst = compare(
          how,
          strip(random.between(0, 65535), random.between(-64, 64) / 8.0, 99),
          strip(random.between(0, 65535), random.between(-64, 64) / 8.0, 99));
      combined = worst.combined > combined ? worst.combined : combined;
      plain = worst.plain > plain ? worst.plain : plain;
    }
    check::write("corners, worst pixel of 255: ");
    check::write_number(static_cast<int64_t>(combined));
    check::write(", by extremes ");
    check::write_number(static_cast<int64_t>(plain));
    check::write("\n");
    CHECK(combined <= 32);
  }
}

// Beyond its reach a blend is the union, bit by bit; where edges meet it adds a
// fillet, and its slope at the edge is that of a distance.
TEST(blends_are_distances_at_the_edge) {
  const Strip a = strip(0, 3, 99);
  const Strip b = strip(0x4000, 2, 99);
  const DistanceGrid first = fill(a, first_samples);
  const DistanceGrid second = fill(b, second_samples);
  GridPart parts[] = {{&first, {}, {}}, {&second, {}, {}, Combine::blend}};
  const auto at = [&parts](int32_t x_q8, int32_t y_q8) {
    return combined_at(parts, Q16_16::from_raw(x_q8 * 256),
                       Q16_16::from_raw(y_q8 * 256), kFilterText);
  };
  int32_t edges = 0;
  for (int32_t x_q8 = 8 * 256; x_q8 < 32 * 256; x_q8 += 96) {
    for (int32_t y_q8 = 8 * 256; y_q8 < 32 * 256; y_q8 += 96) {
      parts[1].how = Combine::unite;
      const GridPoint united = at(x_q8, y_q8);
      parts[1].how = Combine::blend;
      const GridPoint here = at(x_q8, y_q8);
      const double apart = a.distance(x_q8 / 256.0, y_q8 / 256.0) -
                           b.distance(x_q8 / 256.0, y_q8 / 256.0);
      if (magnitude(apart) > 3.1 && magnitude(united.distance_q10) < 700) {
        CHECK_EQ(here.distance_q10, united.distance_q10);
      }
      if (magnitude(here.distance_q10) > 300) {
        continue;
      }
      ++edges;
      // Over 1/2 px along the gradient.
      const double dx = here.x_slope_q13 / 8192.0;
      const double dy = here.y_slope_q13 / 8192.0;
      const GridPoint ahead = at(x_q8 + static_cast<int32_t>(64 * dx),
                                 y_q8 + static_cast<int32_t>(64 * dy));
      const GridPoint back = at(x_q8 - static_cast<int32_t>(64 * dx),
                                y_q8 - static_cast<int32_t>(64 * dy));
      const double slope = (ahead.distance_q10 - back.distance_q10) / 512.0;
      CHECK(slope > 0.85 && slope < 1.15);
    }
  }
  CHECK(edges > 50);
}

TEST(strips_and_places_make_no_difference) {
  const DistanceGrid first = fill(strip(9000, -4, 3), first_samples);
  const DistanceGrid second = fill(strip(20000, -3, 5), second_samples);
  const GridPart parts[] = {
      {&first, Q16_16::from_raw(-70000), Q16_16::from_raw(90000)},
      {&second, Q16_16::from_raw(50000), {}, Combine::blend},
      {&first, {}, Q16_16::from_raw(-333333), Combine::subtract}};
  Picture<kSide, kSide> whole;
  draw_combined(parts, kFilterMotion, whole.sink());
  int32_t inked = 0;
  for (int32_t y = 0; y < kSide; ++y) {
    Picture<kSide, 1> row(0, y);
    draw_combined(parts, kFilterMotion, row.sink());
    for (int32_t x = 0; x < kSide; ++x) {
      CHECK_EQ(row.at(x, y), whole.at(x, y));
      inked += whole.at(x, y) != 0 ? 1 : 0;
    }
  }
  CHECK(inked > 300);
}

TEST(any_parts_are_safe) {
  Random random(11);
  const DistanceGrid empty;
  for (int32_t round = 0; round < 300; ++round) {
    random.fill(first_samples);
    const int32_t scale = random.between(0, 3);
    const DistanceGrid any(first_samples, random.between(1, kSide),
                           random.between(1, kSide), scale);
    const DistanceGrid* const grids[] = {&any, &empty, nullptr};
    GridPart parts[4];
    for (GridPart& part : parts) {
      const bool is_wild = random.below(4) == 0;
      part.grid = grids[random.below(8) < 6 ? 0 : random.below(3)];
      part.x.raw = is_wild ? random.between(INT32_MIN, INT32_MAX)
                           : random.between(-600000, 600000);
      part.y.raw = is_wild ? random.between(INT32_MIN, INT32_MAX)
                           : random.between(-600000, 600000);
      part.how = static_cast<Combine>(random.below(6));
      part.reach.raw = random.any();
    }
    Picture<8, 8> picture(random.between(-20, 20), random.between(-20, 20));
    draw_combined({parts, random.below(5)}, kFilterMotion, picture.sink());
    static_cast<void>(combined_at(parts, Q16_16::from_raw(random.any()),
                                  Q16_16::from_raw(random.any()), kFilterText));
  }
}

}  // namespace
