// Type that moves, from a fuzzer: times, poses, paths, grids, particles and
// bodies of any bytes, with a font of any bytes. Every call must end soon, stay
// inside its memory and its window, and keep what its header promises.
//
// An input: u16, the bytes of choices; those; the font. Unless the first choice
// is odd, the font is repaired (repair_font.hpp). Choices are taken in order,
// the same with every compiler: never two in the arguments of one call. Beyond
// their end they are 0.
#include <algorithm>
#include <memory>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "front_ends.hpp"
#include "inkcell/dirty_rects.hpp"
#include "inkcell/motion/fade.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/morph.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/recipes.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/motion/spring.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/bodies.hpp"
#include "inkcell/simulation/body_draw.hpp"
#include "inkcell/simulation/dots.hpp"
#include "inkcell/simulation/melt.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "moving_input.hpp"
#include "repair_font.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using hostile::require;
using moving_input::Canvas;
using moving_input::Choices;
using moving_input::easing_of;
using moving_input::kSide;
using moving_input::kWindow;
using moving_input::pose_of;

constexpr int32_t kOne = 1 << 16;

bool is_fraction(Q16_16 value) {
  return value.raw >= 0 && value.raw <= kOne;
}

void use_time(Choices& choices) {
  Timing timing;
  timing.delay_ms = choices.number();
  timing.duration_ms = choices.number();
  timing.repeats = choices.u16();
  timing.playback = static_cast<Playback>(choices.byte());
  const int32_t now = choices.number();
  const Q16_16 progress = progress_at(timing, now);
  require(is_fraction(progress), "progress is 0 to 1");
  require(next_due(timing, now) >= now, "what is due is not past");
  require(local_time(timing, now) >= 0, "local time is not negative");
  static_cast<void>(ease(easing_of(choices), choices.q16()));
  const Spring spring = {choices.number(), choices.number()};
  const Q16_16 swing = spring_at(spring, choices.number());
  require(swing.raw >= 0 && swing.raw <= 2 * kOne, "springs are 0 to 2");
  Keyframe keys[3];
  for (Keyframe& key : keys) {
    key = {choices.number(), choices.number(), easing_of(choices)};
  }
  const size_t count = choices.byte() % 4;
  static_cast<void>(value_at({keys, count}, now));
  require(next_due(Span<const Keyframe>(keys, count), now) >= now,
          "keys that are due are not past");
  const Stagger stagger = {choices.number(),
                           static_cast<StaggerOrder>(choices.byte()),
                           static_cast<uint32_t>(choices.number())};
  const size_t index = choices.byte();
  static_cast<void>(delay_of(stagger, index, choices.byte()));
  static_cast<void>(longest_delay(stagger, choices.byte()));
  const int32_t from = choices.number();
  const Q16_16 part = fraction(from, choices.number(), now);
  require(is_fraction(part), "fractions are 0 to 1");
}

void add_piece(Choices& choices, Path& path) {
  const Point to = choices.point();
  Status status = Status::ok;
  switch (choices.byte() % 4) {
    case 0:
      status = path.move_to(to);
      break;
    case 1:
      status = path.line_to(to);
      break;
    case 2: {
      const Point control = choices.point();
      status = path.cubic_to(control, choices.point(), to, choices.i16());
      break;
    }
    default:
      status = path.arc_to(to, choices.q16(), choices.i16());
  }
  require(status == Status::ok || status == Status::buffer_small ||
              status == Status::bad_argument,
          "paths report");
}

// Letters in poses, on lines and on a path, and what changed between the two.
void use_poses(const Font& font, Choices& choices) {
  char text[8];
  for (char& c : text) {
    c = static_cast<char>(choices.byte());
  }
  RunGlyph laid[8];
  Run run;
  const auto anchor = static_cast<Anchor>(choices.byte() % 3);
  require(lay_out(font, {text, sizeof text}, anchor, laid, run) == Status::ok,
          "8 bytes are 8 glyphs at most");
  PathPoint room[40];
  Path path(room);
  for (int i = 0; i < 4; ++i) {
    add_piece(choices, path);
  }
  PathPlace along;
  along.start = choices.q16();
  along.size = choices.q6();
  along.tracking = choices.q6();
  along.lift = choices.q6();
  along.overflow = static_cast<PathOverflow>(choices.byte() % 4);
  along.pivot_height = choices.i16();
  const RunPlace where = {choices.point(), along.size, along.tracking,
                          along.pivot_height};
  const PoseKey keys[] = {
      {choices.number(), pose_of(choices), easing_of(choices)},
      {choices.number(), pose_of(choices), easing_of(choices)}};
  PosedGlyph before[8];
  PosedGlyph now[8];
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    const int32_t time = choices.number();
    before[i] = place(font, run, i, where, pose_at(keys, time));
    const Pose both =
        combine(mix(keys[0].pose, keys[1].pose, choices.q16()), keys[1].pose);
    now[i] = place(font, run, i, path, along, both);
  }
  PoseRenderer renderer(font, choices.q6());
  Canvas canvas;
  const Sink target = canvas.sink();
  const Fade fade = {&target, choices.byte()};
  renderer.draw({before, run.glyphs.size}, target);
  renderer.draw({now, run.glyphs.size}, make_sink(fade));
  Rect rects[3];
  DirtyRects dirty(rects);
  renderer.add_changes({before, run.glyphs.size}, {now, run.glyphs.size},
                       kWindow, dirty);
  dirty.add(choices.rect(), kWindow);
  for (const Rect& rect : dirty.rects()) {
    require(rect.x0 >= kWindow.x0 && rect.y0 >= kWindow.y0 &&
                rect.x1 <= kWindow.x1 && rect.y1 <= kWindow.y1,
            "changes are on the screen");
  }
}

// Samples in a block of exactly their size.
struct Samples {
  std::unique_ptr<int8_t[]> block;
  DistanceGrid grid;

  Samples(Choices& choices, int32_t width, int32_t height, int32_t scale)
      : block(std::make_unique<int8_t[]>(static_cast<size_t>(width * height))),
        grid({block.get(), static_cast<size_t>(width * height)},
             width,
             height,
             scale) {
    for (int32_t i = 0; i < width * height; ++i) {
      block[static_cast<size_t>(i)] = static_cast<int8_t>(choices.byte());
    }
  }
};

void use_grids(const Font& font, Choices& choices) {
  const int32_t width = choices.byte() % kSide + 1;
  const int32_t height = choices.byte() % kSide + 1;
  const int32_t scale = choices.byte() % 4;
  Samples first(choices, width, height, scale);
  Samples next(choices, width, height, scale);
  const auto glyph = choices.u16();
  const Q26_6 size = choices.q6();
  static_cast<void>(first.grid.paint(font, glyph, size, choices.point()));
  static GridHistogram scratch;
  GridBlend how;
  how.part_q8 = choices.number();
  how.depth_a = choices.number();
  how.depth_b = choices.number();
  how.area_a = choices.number();
  how.area_b = choices.number();
  GridLook look;
  look.cutoff = blend(first.grid, next.grid, how, next.grid, scratch);
  static_cast<void>(cutoff_for(first.grid, choices.number(), scratch));
  Vortex vortices[2];
  for (Vortex& vortex : vortices) {
    vortex.x = choices.q16();
    vortex.y = choices.q16();
    vortex.strength = choices.number();
    vortex.core = choices.number();
  }
  Flow flow;
  flow.vortices = vortices;
  flow.x_drift = choices.q16();
  flow.y_drift = choices.q16();
  advect(first.grid, flow, next.grid);
  redistance(next.grid, first.grid);
  const int32_t left = choices.number();
  wind(first.grid, left, choices.number(), vortices[0], next.grid);
  Melting melting;
  melting.floor = choices.q6();
  melting.drip = choices.q6();
  melting.speed_q8 = choices.number();
  melting.area = choices.number();
  melt(first.grid, melting, scratch);
  freeze(first.grid, next.grid, choices.number());
  look.slope_q8 = choices.number();
  Canvas canvas;
  const int32_t far_x = choices.number();
  const int32_t far_y = choices.number();
  draw_grid(first.grid, look, far_x, far_y, kFilterMotion, canvas.sink());
  look.cutoff.raw = choices.number();
  const int32_t x = choices.i16() >> 8;
  const int32_t y = choices.i16() >> 8;
  draw_grid(first.grid, look, x, y, kFilterText, canvas.sink());
  draw_offset(next.grid, choices.q6(), far_x, y, kFilterMotion, canvas.sink());
  const Q16_16 probed_x = choices.q16();
  static_cast<void>(probe(first.grid, probed_x, choices.q16()));

  constexpr MorphBox box = {12, 12, 10, 0};
  int8_t room[morph_bytes(box)];
  GlyphMorph morph(font, choices.q6(), kFilterMotion, box, room);
  if (morph.set(glyph, choices.u16()) == Status::ok) {
    morph.step(choices.q16(), scratch);
    morph.draw(x, y, canvas.sink());
  }
  OutlineMorph outlines;
  const uint16_t from = choices.byte() % 4;
  const uint16_t to = choices.byte() % 4;
  const Status opened[] = {OutlineMorph::open(font, from, to, outlines),
                           OutlineMorph::open_master(font, from, outlines)};
  if (opened[0] == Status::ok || opened[1] == Status::ok) {
    alignas(4) uint8_t ram[2048];
    const Style style(choices.q6(), kFilterMotion);
    const Q16_16 progress = choices.q16();
    static_cast<void>(outlines.advance(style, progress));
    outlines.draw(Painter(canvas.sink(), Span<uint8_t>(ram)), style, {x, y},
                  progress);
  }
}

void use_particles(Choices& choices) {
  const int32_t width = choices.byte() % kSide + 1;
  const int32_t height = choices.byte() % kSide + 1;
  const Samples field(choices, width, height, choices.byte() % 4);
  Particle particles[4];
  ParticleHome homes[4];
  const int32_t x = choices.number();
  const int32_t y = choices.number();
  RandomNumbers random(choices.u16());
  static_cast<void>(spread_homes(field.grid, x, y, choices.u16(), homes));
  static_cast<void>(find_edge(field.grid, x, y, random, particles[0]));
  for (size_t i = 1; i < 4; ++i) {
    particles[i] = {choices.q16(), choices.q16(), choices.i16(), choices.i16()};
    homes[i] = {choices.i16(), choices.i16()};
  }
  ParticleRules rules;
  rules.walls = choices.rect();
  rules.gravity_q10 = choices.i16();
  rules.kept_q16 = choices.u16();
  rules.bounce_q8 = choices.u16();
  rules.side = static_cast<ParticleSide>(choices.byte());
  rules.attraction_q10 = choices.i16();
  rules.orbit_q10 = choices.i16();
  rules.radius = choices.q6();
  Canvas canvas;
  const Q26_6 radius = choices.q6();
  for (int i = 0; i < 3; ++i) {
    const Q16_16 stiffness = choices.q16();
    pull_home(particles, homes, stiffness, choices.q6());
    step(particles, rules, field.grid, x, y);
    for (const Particle& p : particles) {
      require(abs(p.x_speed_q10) <= kMostSpeedQ10 || is_empty(rules.walls),
              "speeds are limited");
      draw_dot(p.x, p.y, radius, canvas.sink());
    }
  }
}

void use_bodies(Choices& choices) {
  const int32_t width = choices.byte() % kSide + 1;
  const int32_t height = choices.byte() % kSide + 1;
  const Samples field(choices, width, height, choices.byte() % 4);
  BodyPoint points[24];
  BodyShape shape;
  const bool is_made = shape.make(field.grid, points) == Status::ok;
  Body bodies[4];
  for (Body& body : bodies) {
    body.shape = is_made ? &shape : nullptr;
    body.x = choices.q16();
    body.y = choices.q16();
    body.x_speed = choices.q16();
    body.y_speed = choices.q16();
    body.turn_q32 = static_cast<uint32_t>(choices.number());
    body.spin_q20 = choices.number();
    body.is_fixed = choices.byte() % 8 == 1;
    body.still_steps = choices.byte();
    for (BodyTouch& touch : body.touches) {
      touch = {choices.byte(), choices.byte(), choices.byte()};
    }
  }
  BodyRules rules;
  rules.walls = choices.rect();
  rules.gravity = choices.q16();
  rules.bounce_q8 = choices.u16();
  rules.friction_q8 = choices.u16();
  rules.overlap.raw = choices.i16();
  rules.stiffness_q16 = choices.u16();
  rules.damping_q16 = choices.u16();
  BodyContact room[20];
  const size_t count = choices.byte() % 21;
  Canvas canvas;
  for (int i = 0; i < 3; ++i) {
    step(bodies, rules, {room, count});
    for (size_t k = 0; k < 4; ++k) {
      draw_body(bodies, k, rules, kFilterMotion, canvas.sink());
    }
    for (const Body& body : bodies) {
      require(!is_made || is_empty(rules.walls) ||
                  (body.x.raw >= -8191 * kOne && body.x.raw <= 8191 * kOne),
              "bodies stay within 8191 px");
    }
  }
}

// Recipes at any times, with text of any bytes.
void use_recipes(const Font& font, Choices& choices) {
  char text[6];
  for (char& c : text) {
    c = static_cast<char>(choices.byte());
  }
  // Origins are within 8191 px.
  const Q26_6 x = Q26_6::from_raw(choices.i16() * 16);
  const Point origin = {x, Q26_6::from_raw(choices.i16() * 16)};
  const Style style(choices.q6(), kFilterMotion);
  Timing timing;
  timing.delay_ms = choices.number() >> 1;
  timing.duration_ms = choices.number();
  Counter counter(font, style, origin, choices.byte());
  const auto counted = static_cast<uint32_t>(choices.number());
  counter.roll(static_cast<int32_t>(counted), choices.number(), timing,
               easing_of(choices));
  Clock clock(font, style, origin);
  Typewriter line(font, style, origin, {text, sizeof text}, choices.number());
  Wipe wipe(font, style, origin, {text, sizeof text}, timing);
  Canvas canvas;
  const Sink sink = canvas.sink();
  const Painter painter(sink);
  for (int i = 0; i < 2; ++i) {
    const int32_t now = choices.number();
    static_cast<void>(counter.at(now));
    static_cast<void>(clock.at(counted, choices.u16(), now));
    static_cast<void>(line.at(now, painter));
    static_cast<void>(wipe.at(now, painter));
    require(counter.next_due(now) >= now && line.next_due(now) >= now,
            "what is due is not past");
    counter.draw(painter);
    clock.draw(painter);
    line.draw(painter);
    wipe.draw(painter);
  }
  Clock seconds(font, style, origin, ClockUnit::seconds);
  static_cast<void>(seconds.at(counted, counted + 1, choices.number()));
  seconds.draw(painter);
  const TextCircle circle = {
      {x, Q26_6::from_raw(choices.number())},
      Q26_6::from_raw(choices.number()),
      Angle::from_raw(choices.u16()),
      choices.byte() % 2 == 0 ? CircleSide::outside : CircleSide::inside,
      static_cast<Anchor>(choices.byte() % 3)};
  draw_on_circle(painter, font, style, circle, {text, sizeof text});
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size < 2) {
    return;
  }
  const size_t told = font_builder::get_u16(data);
  const size_t count = std::min(told, size - 2);
  Choices choices({data + 2, count});
  // A block of exactly this size: the sanitizer sees one byte too much.
  const size_t font_bytes = size - 2 - count;
  const auto block = std::make_unique<uint8_t[]>(font_bytes);
  std::copy(data + 2 + count, data + size, block.get());
  if (choices.byte() % 2 == 0) {
    repair_font({block.get(), font_bytes});
  }
  Font font;
  if (Font::open({block.get(), font_bytes}, font) != Status::ok) {
    font = Font();
  }
  use_time(choices);
  use_poses(font, choices);
  use_particles(choices);
  use_bodies(choices);
  use_grids(font, choices);
  use_recipes(font, choices);
}
