// The code of docs/ANIMATING.md, which build.porting looks for here.
#include "check.hpp"
#include "inkcell/dirty_rects.hpp"
#include "inkcell/field/generate.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/morph.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/motion/timeline.hpp"
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
#include "outline_record.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;

constexpr int32_t kSide = 48;

alignas(4) uint8_t font_bytes[outline_record::kSampleFontBytes];
int32_t ink = 0;  // of what was drawn last

const Font& sample_font() {
  static Font sample;
  if (sample.glyph_count() == 0) {
    const size_t bytes = outline_record::build_sample_font(font_bytes);
    CHECK_OK(Font::open({font_bytes, bytes}, sample));
  }
  return sample;
}

Sink counting_sink() {
  ink = 0;
  Sink sink;
  sink.window = {0, 0, kSide, kSide};
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t* coverage,
                     int32_t count) {
    for (int32_t i = 0; i < count; ++i) {
      ink += coverage[i];
    }
  };
  sink.solid = [](void*, int32_t, int32_t, int32_t count) {
    ink += 255 * count;
  };
  return sink;
}

const Font& font = sample_font();
constexpr Q26_6 size = Q26_6::from_int(16);
constexpr Point from = {Q26_6::from_int(4), Q26_6::from_int(30)};
constexpr Point to = {Q26_6::from_int(44), Q26_6::from_int(30)};

Status draw_poses(int32_t now_ms, const Painter& painter) {
  constexpr PoseKey keys[] = {{0, {}, kOvershoot}, {500, {}, kLinear}};
  const RunPlace where = {from, size, {}, 250};
  RunGlyph glyphs[16];
  PosedGlyph posed[16];
  Run run;
  INKCELL_TRY(lay_out(font, "ABCD", Anchor::left, glyphs, run));
  PoseRenderer renderer(font, size);
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    const int32_t delay =
        delay_of({40, StaggerOrder::from_centre, 0}, i, run.glyphs.size);
    posed[i] = place(font, run, i, where, pose_at(keys, now_ms - delay));
  }
  renderer.draw({posed, run.glyphs.size}, painter);  // for each strip
  constexpr Point control1 = {Q26_6::from_int(14), Q26_6::from_int(10)};
  constexpr Point control2 = {Q26_6::from_int(34), Q26_6::from_int(50)};
  PathPoint points[40];
  Path path(points);
  INKCELL_TRY(path.move_to(from));
  INKCELL_TRY(path.cubic_to(control1, control2, to, 32));
  PathPlace along;
  along.size = size;
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    posed[i] = place(font, run, i, path, along, Pose());
  }
  renderer.draw({posed, run.glyphs.size}, painter);
  return Status::ok;
}

Status draw_morph(int32_t now_ms, const Painter& painter) {
  const int32_t x = 4;
  const int32_t y = 4;
  constexpr MorphBox box = {24, 24, 20, 0};  // width, height, baseline [px]
  static int8_t grids[morph_bytes(box)];
  GridHistogram scratch;
  GlyphMorph digit(font, size, kFilterMotion, box, grids);
  INKCELL_TRY(digit.set(font.glyph_or_notdef('A'), font.glyph_or_notdef('C')));
  digit.step(ease(kEaseInOut, fraction(0, 600, now_ms)), scratch);
  digit.draw(x, y, painter);  // for each strip
  return Status::ok;
}

Status draw_outlines(const Painter& painter, Q16_16 progress) {
  const uint16_t four = font.glyph_or_notdef('A');
  const uint16_t five = font.glyph_or_notdef('C');
  const Style style(size);
  const Point origin = from;
  OutlineMorph digit;
  INKCELL_TRY(OutlineMorph::open(font, four, five, digit));
  digit.draw(painter, style, origin, progress);  // for each strip
  return Status::ok;
}

Status draw_bolder(const Painter& painter, Point& origin, Q16_16 weight) {
  const uint16_t glyph = font.glyph_or_notdef('A');
  const Style style(size);
  OutlineMorph letter;  // of a glyph
  INKCELL_TRY(OutlineMorph::open_master(font, glyph, letter));
  letter.draw(painter, style, origin, weight);  // 0: light, 1: bold
  origin.x.raw += letter.advance(style, weight).raw;
  return Status::ok;
}

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

Status ask_field(uint16_t glyph, Q16_16 x, Q16_16 y, FieldPoint& out) {
  alignas(4) static uint8_t ram[16384];
  FieldLimits limits;
  limits.fills_em = true;
  GlyphField field;
  INKCELL_TRY(open_field(font, glyph, limits, ram, field));
  const FieldPoint at = point_at(field, x, y);  // u, y up
  out = at;
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
  CHECK(ink > 0);
  ink = 0;
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
    CHECK(ink > 255 * 40);
  }
}

TEST(poses_and_paths_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_poses(300, sink));
  CHECK(ink > 255 * 100);
}

TEST(morphs_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_morph(300, sink));
  CHECK(ink > 255 * 20);
}

TEST(outlines_morph_if_the_font_holds_the_pair) {
  const Sink sink = counting_sink();
  CHECK(draw_outlines(Painter(sink), Q16_16::from_int(0)) == Status::no_glyph);
  Point at;
  CHECK(draw_bolder(Painter(sink), at, Q16_16::from_int(0)) ==
        Status::no_glyph);
  CHECK_EQ(at.x.raw, 0);
  CHECK_EQ(ink, 0);
}

TEST(particles_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_particles(sink));
  CHECK(ink > 255 * 50);
}

TEST(fields_answer) {
  // Left of the disc about (384, 384).
  FieldPoint at;
  CHECK_OK(ask_field(1, Q16_16::from_int(20), Q16_16::from_int(384), at));
  CHECK(!at.is_bound);
  CHECK(at.distance.raw < -40 * 1024);
  CHECK(at.gradient.x.raw > 16000);
}

TEST(parts_and_prints_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_parts_and_print(sink));
  CHECK(ink > 0);
}

TEST(bodies_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_bodies(sink));
  CHECK(ink > 255 * 50);
}

TEST(level_sets_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_level_set(sink));
  CHECK(ink > 255 * 100);
}
