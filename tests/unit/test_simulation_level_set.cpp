// Grids that flow: areas and shapes after a flow and its reverse, and distances
// that are made anew.
#include "check.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/melt.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "outline_font.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using outline_record::sample_font;

constexpr int32_t kSide = 96;
constexpr int32_t kOne = 1 << 16;
constexpr uint16_t kDiscGlyph = 1;
constexpr uint16_t kEllGlyph = 3;

int8_t first[kSide * kSide];
int8_t second[kSide * kSide];
int8_t original[kSide * kSide];
GridHistogram scratch;

void paint(uint16_t glyph, DistanceGrid& grid) {
  grid.clear();
  CHECK_OK(grid.paint(sample_font(), glyph, 72_px, {20, 76}));
}

// Difference of coverage, where a sample covers its square by a ramp.
int32_t difference(const DistanceGrid& a, const DistanceGrid& b) {
  int32_t sum = 0;
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    const auto covered = [](int32_t value) {
      const int32_t part = 2 * value + 33;
      return part < 0 ? 0 : part > 64 ? 64 : part;
    };
    sum += magnitude(covered(a.at(x, y)) - covered(b.at(x, y)));
  }
  return sum;
}

void exchange(DistanceGrid& grid, DistanceGrid& next) {
  const DistanceGrid swap = grid;
  grid = next;
  next = swap;
}

// Steps a grid by a flow, in turns from one buffer to the other.
void flow_for(DistanceGrid& grid,
              DistanceGrid& next,
              const Flow& flow,
              int32_t steps) {
  for (int32_t i = 0; i < steps; ++i) {
    advect(grid, flow, next);
    if (i % 16 == 15) {
      redistance(next, grid);
      continue;
    }
    exchange(grid, next);
  }
}

constexpr int32_t kSteps = INKCELL_BOARD_FIRMWARE ? 8 : 48;

}  // namespace

TEST(drifting_there_and_back_changes_little) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid next(second, kSide, kSide, 0);
  DistanceGrid before(original, kSide, kSide, 0);
  paint(kEllGlyph, grid);
  paint(kEllGlyph, before);
  Flow flow;
  flow.x_drift.raw = kOne * 3 / 10;
  flow.y_drift.raw = -kOne / 5;
  flow_for(grid, next, flow, kSteps);
  CHECK(difference(grid, before) > before.area() / 20);
  CHECK(magnitude(grid.area() - before.area()) <= before.area() * 2 / 100);
  flow.x_drift.raw = -flow.x_drift.raw;
  flow.y_drift.raw = -flow.y_drift.raw;
  flow_for(grid, next, flow, kSteps);
  CHECK(difference(grid, before) <= before.area() * 5 / 100);
}

TEST(a_reversed_vortex_leaves_the_shape) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid next(second, kSide, kSide, 0);
  DistanceGrid before(original, kSide, kSide, 0);
  paint(kDiscGlyph, grid);
  paint(kDiscGlyph, before);
  Vortex vortex;
  vortex.x = Q16_16::from_int(40);
  vortex.y = Q16_16::from_int(36);
  vortex.strength = 20 * 256;
  vortex.core = 10;
  Flow flow;
  flow.vortices = {&vortex, 1};
  flow_for(grid, next, flow, kSteps);
  CHECK(INKCELL_BOARD_FIRMWARE ||
        difference(grid, before) > before.area() / 10);
  CHECK(magnitude(grid.area() - before.area()) <= before.area() * 2 / 100);
  vortex.strength = -vortex.strength;
  flow_for(grid, next, flow, kSteps);
  CHECK(magnitude(grid.area() - before.area()) <= before.area() * 3 / 100);
  CHECK(difference(grid, before) <= before.area() * 4 / 100);
  // A cutoff brings back what is left of the area.
  const int32_t cutoff = cutoff_for(grid, before.area(), scratch).raw;
  int64_t area = 0;
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    // A ramp of one sample, 2^13.
    const int32_t covered = grid.at(x, y) * 256 + 128 - cutoff + 4096;
    area += covered < 0 ? 0 : covered > 8192 ? 8192 : covered;
  }
  CHECK(magnitude(static_cast<int32_t>(area >> 7) - before.area()) <=
        before.area() / 200);
}

// By as many steps as a flow, and back: only interpolation wears.
TEST(a_vortex_winds_and_unwinds) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid next(second, kSide, kSide, 0);
  DistanceGrid before(original, kSide, kSide, 0);
  paint(kEllGlyph, grid);
  paint(kEllGlyph, before);
  Vortex vortex;
  vortex.x = Q16_16::from_int(40);
  vortex.y = Q16_16::from_int(44);
  vortex.core = 10;
  wind(grid, 0, 0, vortex, next);
  CHECK_EQ(difference(next, before), 0);
  // A turn and a half of the centre.
  vortex.strength = 100 * 1608 * 3 / 2;
  wind(grid, 0, 0, vortex, next);
  CHECK(difference(next, before) > before.area() / 2);
  CHECK(magnitude(next.area() - before.area()) <= before.area() * 5 / 100);
  vortex.strength = -vortex.strength;
  wind(next, 0, 0, vortex, grid);
  CHECK(difference(grid, before) <= before.area() * 15 / 100);
  // A step is one of a flow.
  paint(kEllGlyph, grid);
  vortex.strength = 20 * 256;
  Flow flow;
  flow.vortices = {&vortex, 1};
  advect(grid, flow, next);
  DistanceGrid wound(original, kSide, kSide, 0);
  wind(grid, 0, 0, vortex, wound);
  CHECK(difference(next, wound) <= grid.area() / 100);
  // The shape's part of a grid is enough.
  const Rect box = grid.known_box();
  const int32_t width = box.x1 - box.x0;
  DistanceGrid part(second, width, box.y1 - box.y0, 0);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    for (int32_t x = box.x0; x < box.x1; ++x) {
      part.row(y - box.y0)[x - box.x0] = grid.at(x, y);
    }
  }
  wind(part, box.x0, box.y0, vortex, grid);
  CHECK_EQ(difference(grid, wound), 0);
}

TEST(vortices_turn_counter_clockwise) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid next(second, kSide, kSide, 0);
  grid.clear();
  // A spot to the right of the centre goes up.
  for (int32_t y = -3; y <= 3; ++y) {
    for (int32_t x = -3; x <= 3; ++x) {
      grid.row(48 + y)[68 + x] = 60;
    }
  }
  redistance(grid, next);
  grid = next;
  next = DistanceGrid(first, kSide, kSide, 0);
  Vortex vortex;
  vortex.x = vortex.y = Q16_16::from_int(48);
  vortex.strength = 40 * 256;
  vortex.core = 4;
  Flow flow;
  flow.vortices = {&vortex, 1};
  flow_for(grid, next, flow, 8);
  // By 40 / (20^2 + 4^2) of the radius a step: 0.77 rad.
  CHECK(grid.at(48 + 14, 48 - 14) > 0);
  CHECK(grid.at(48 + 14, 48 + 14) < 0);
}

TEST(distances_are_made_anew) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid before(original, kSide, kSide, 0);
  DistanceGrid anew(second, kSide, kSide, 0);
  const uint16_t kGlyphs[] = {kDiscGlyph, kEllGlyph};
  for (const uint16_t glyph : kGlyphs) {
    paint(glyph, grid);
    paint(glyph, before);
    // Twice as steep, and then as they were.
    for (int8_t& sample : first) {
      const int32_t steep = sample * 2;
      sample = static_cast<int8_t>(steep > 127    ? 127
                                   : steep < -128 ? -128
                                                  : steep);
    }
    redistance(grid, anew);
    int64_t squares = 0;
    int32_t count = 0;
    int32_t worst = 0;
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      if (original[i] > -96 && original[i] < 96) {
        const int32_t off = magnitude(second[i] - original[i]);
        squares += off * off;
        worst = off > worst ? off : worst;
        ++count;
      }
    }
    // RMS 0.15 and worst 1.1 of a sample.
    CHECK(squares <= int64_t{count} * 5 * 5);
    CHECK(worst <= 35);
    const int32_t area = before.area();
    CHECK(magnitude(anew.area() - area) <= area / 100);
    for (int32_t i = 0; i < 25; ++i) {
      redistance(anew, grid);
      redistance(grid, anew);
    }
    CHECK(magnitude(anew.area() - area) <= area * 2 / 100);
  }
}

// The shape sinks to the floor as a puddle of the same area; another one
// freezes out of it, from below, and is exact at last.
TEST(shapes_melt_and_others_freeze) {
  DistanceGrid grid(first, kSide, kSide, 0);
  DistanceGrid next(second, kSide, kSide, 0);
  const DistanceGrid target(original, kSide, kSide, 0);
  DistanceGrid whole = target;
  paint(kDiscGlyph, grid);
  paint(kEllGlyph, whole);
  Melting how;
  how.floor = 80_px;
  how.beside = 8_px;
  how.area = grid.area();
  how.speed_q8 = 220;
  const int32_t top = grid.known_box().y0;
  for (int32_t i = 0; i < 160; ++i) {
    melt(grid, how, scratch);
    redistance(grid, next);
    exchange(grid, next);
    CHECK(magnitude(grid.area() - how.area) <= how.area / 5);
  }
  CHECK(magnitude(grid.area() - how.area) <= how.area / 25);
  CHECK(grid.known_box().y0 > top + 24);
  for (int32_t x = 0; x < kSide; ++x) {
    CHECK(grid.at(x, 81) < 0);
    CHECK(grid.at(7, x) < 0 && grid.at(kSide - 8, x) < 0);
  }
  CHECK(grid.at(8, 79) >= 0 && grid.at(kSide - 9, 79) >= 0);
  // It is filled where the puddle is, and above only later.
  const auto missing = [&](int32_t from, int32_t to) {
    int32_t count = 0;
    for (const auto [x, y] : pixels_of({0, from, kSide, to})) {
      count += target.at(x, y) > 0 && grid.at(x, y) < 0 ? 1 : 0;
    }
    return count;
  };
  for (int32_t i = 0; i < 24; ++i) {
    freeze(grid, target, 16);
    redistance(grid, next);
    exchange(grid, next);
  }
  CHECK_EQ(missing(68, kSide), 0);
  CHECK(missing(0, 50) > 0);
  for (int32_t i = 0; i < 16; ++i) {
    freeze(grid, target, 16);
  }
  CHECK_EQ(difference(grid, target), 0);
}

TEST(hostile_flows_do_no_harm) {
  for (Random& random : Rounds(41, 60)) {
    for (int32_t i = 0; i < 900; ++i) {
      first[i] = random.byte();
    }
    const auto width = static_cast<int32_t>(random.below(30));
    const auto height = static_cast<int32_t>(random.below(30));
    DistanceGrid grid(first, width, height, 0);
    DistanceGrid next(second, width, random.below(9) == 0 ? 3 : height, 0);
    Vortex vortices[5];
    for (Vortex& vortex : vortices) {
      vortex.x.raw = random.any();
      vortex.y.raw = random.any();
      vortex.strength = random.any();
      vortex.core = random.any();
    }
    Flow flow;
    flow.vortices = {vortices, random.below(6)};
    flow.x_drift.raw = random.any();
    flow.y_drift.raw = random.any();
    advect(grid, flow, next);
    wind(grid, random.any(), random.any(), vortices[0], next);
    redistance(grid, next);
    redistance(next, grid);
    Melting how;
    how.floor.raw = random.any();
    how.speed_q8 = random.any();
    how.drip.raw = random.any();
    how.area = random.any();
    melt(grid, how, scratch);
    freeze(grid, next, random.any());
  }
}
