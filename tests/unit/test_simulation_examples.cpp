// The code of docs/ANIMATING.md that simulates. build.docs_code looks for it
// here.
#include "animating_input.hpp"
#include "inkcell/dirty_rects.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/bodies.hpp"
#include "inkcell/simulation/body_draw.hpp"
#include "inkcell/simulation/combine.hpp"
#include "inkcell/simulation/dots.hpp"
#include "inkcell/simulation/melt.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "inkcell/simulation/redistance.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using namespace animating_input;

Status draw_particles(const Sink& sink) {
  constexpr int32_t seed = 1;
  int8_t samples[24 * 24];
  Particle particles[20];
  ParticleHome homes[20];
  const uint16_t glyph = 1;
  const Q26_6 radius = Q26_6::from_int(1);
  const Q26_6 offset = Q26_6::from_int(2);
  const Q26_6 most = Q26_6::from_int(1);
  const Q16_16 stiffness = Q16_16::from_raw(2000);
  DistanceGrid grid(samples, 24, 24, 1);  // 2 px a sample
  grid.clear();
  INKCELL_TRY(grid.paint(font, glyph, size, from));
  spread_homes(grid, 0, 0, seed, homes);  // inside the glyph
  ParticleRules rules;
  rules.walls = {0, 0, 48, 48};
  rules.gravity_q10 = 200;
  pull_home(particles, homes, stiffness, most);  // a step
  step(particles, rules, grid, 0, 0);
  draw_offset(grid, offset, 0, 0, kFilterMotion, sink);
  for (const Particle& p : particles) {
    draw_dot(p.x, p.y, radius, sink);
  }
  return Status::ok;
}

Status draw_bodies(const Sink& sink) {
  static int8_t samples[48 * 48];
  const uint16_t glyph = 1;
  BodyPoint points[48];
  DistanceGrid grid(samples, 48, 48, 0);  // a sample a pixel
  grid.clear();
  INKCELL_TRY(grid.paint(font, glyph, size, from));
  BodyShape shape;  // mass, inertia, points on edges
  INKCELL_TRY(shape.make(grid, points));
  Body bodies[2];
  bodies[0].shape = bodies[1].shape = &shape;
  bodies[0].x = bodies[1].x = Q16_16::from_int(24);
  bodies[0].y = Q16_16::from_int(20);
  bodies[1].y = Q16_16::from_int(60);
  BodyContact contacts[16];
  BodyRules rules;
  rules.walls = {0, 0, 80, 120};
  rules.gravity = Q16_16::from_raw(2300);  // 500 px/s^2 at 120 steps a second
  step(bodies, rules, contacts);
  for (size_t i = 0; i < 2; ++i) {
    draw_body(bodies, i, rules, kFilterMotion, sink);  // for each strip
  }
  return Status::ok;
}

Status draw_parts_and_print(const Sink& sink) {
  static int8_t samples[kSide * kSide];
  const Q16_16 x0;
  const Q16_16 y0;
  const Q16_16 x1 = Q16_16::from_int(7);
  const Q16_16 y1 = Q16_16::from_int(3);
  const Q16_16 x2 = Q16_16::from_int(12);
  const Q16_16 y2 = Q16_16::from_int(-9);
  const int32_t x = 0;
  const int32_t y = 0;
  const Rect screen = {0, 0, kSide, kSide};
  Rect room[2];
  DirtyRects dirty(room);
  DistanceGrid grid(samples, kSide, kSide, 0);
  grid.clear();
  INKCELL_TRY(grid.paint(font, 1, Q26_6::from_int(32), from));
  const DistanceGrid& stem = grid;
  const DistanceGrid& bowl = grid;
  const DistanceGrid& hole = grid;
  const GridPart parts[] = {{&stem, x0, y0},
                            {&bowl, x1, y1, Combine::blend, 3_px},
                            {&hole, x2, y2, Combine::subtract}};
  draw_combined(parts, kFilterMotion, sink);  // for each strip
  dirty.add(combined_box(parts, kFilterMotion), screen);
  CHECK_EQ(dirty.rects().size, 1u);
  CHECK(ink.sum > 0);
  ink = Ink();
  PrintLook look;
  look.style = PrintStyle::engraving;  // rings, hatching, halftone, relief
  look.light = from_degrees(135);
  look.pitch = 5_px;
  look.slope = 8_px;                                  // how wide the edge is
  draw_print(grid, look, x, y, kFilterMotion, sink);  // for each strip
  return Status::ok;
}

Status draw_level_set(const Sink& sink) {
  static int8_t samples[2][48 * 48];
  DistanceGrid grid(samples[0], 48, 48, 0);
  DistanceGrid next(samples[1], 48, 48, 0);
  grid.clear();
  INKCELL_TRY(grid.paint(font, 1, Q26_6::from_int(32), from));
  const int32_t area = grid.area();  // once, before the first step
  GridHistogram scratch;
  Vortex vortex;
  vortex.x = vortex.y = Q16_16::from_int(24);  // [samples]
  vortex.core = 6;                             // [samples]
  vortex.strength = 700;                       // [samples^2 / 256 a step]
  Flow flow;
  flow.vortices = {&vortex, 1};
  advect(grid, flow, next);  // a step: from grid to next
  redistance(next, grid);    // back; in 7 steps of 8 swap the grids instead
  GridLook look;
  look.cutoff = cutoff_for(grid, area, scratch);  // keeps the area
  draw_grid(grid, look, 0, 0, kFilterMotion, sink);
  return Status::ok;
}

Status melt_and_freeze(int32_t frame, const Sink& sink) {
  static int8_t samples[3][48 * 48];
  static DistanceGrid grid(samples[0], 48, 48, 0);
  static DistanceGrid next(samples[1], 48, 48, 0);
  static DistanceGrid word(samples[2], 48, 48, 0);
  static GridHistogram scratch;
  static Melting how;
  if (frame == 0) {
    grid.clear();
    INKCELL_TRY(grid.paint(font, 1, Q26_6::from_int(32), from));
    word.clear();
    INKCELL_TRY(word.paint(font, 2, Q26_6::from_int(32), from));
    how.floor = from.y;      // from the grid's upper edge
    how.area = grid.area();  // is kept
  }
  if (frame < 60) {
    how.speed_q8 = frame < 20 ? 10 * frame : 200;  // [samples a step]
    melt(grid, how, scratch);
  } else {
    freeze(grid, word, frame < 100 ? 12 : 24);
  }
  if (frame < 100) {  // after that, parts that were not reached appear
    redistance(grid, next);
    const DistanceGrid swap = grid;
    grid = next;
    next = swap;
  }
  draw_grid(grid, {}, 0, 0, kFilterMotion, sink);
  return Status::ok;
}

}  // namespace

TEST(shapes_melt) {
  for (int32_t frame = 0; frame < 112; ++frame) {
    const Sink sink = counting_sink();
    CHECK_OK(melt_and_freeze(frame, sink));
    CHECK(ink.sum > 255 * 40);
  }
}

TEST(particles_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_particles(sink));
  CHECK(ink.sum > 255 * 50);
}

TEST(parts_and_prints_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_parts_and_print(sink));
  CHECK(ink.sum > 0);
}

TEST(bodies_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_bodies(sink));
  CHECK(ink.sum > 255 * 50);
}

TEST(level_sets_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_level_set(sink));
  CHECK(ink.sum > 255 * 100);
}
