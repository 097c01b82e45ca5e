// Animates, and counts.
//
//   FIRMWARE FONT
//
// FONT has digits and letters. Prints instructions (mean, most), the stack of
// the deepest call, and RAM beside strips and 2,560 bytes that are lent:
//
//   morph PX SCALE MEAN MOST SET STACK RAM    digits 0 to 9, a frame in strips
//                                             of 16 rows; SET: the most that
//                                             the distances of a digit take
//   outline_morph PX MEAN MOST PLAIN STACK    the same by outlines, if the font
//                                             holds the pairs, beside the mean
//                                             of the plain digits
//   particles COUNT MEAN PULL                 a step; and the way home
//   dot MEAN                                  of 1.3 px
//   level_set SIDE ADVECT REDISTANCE STACK    a sample, in 1/10
//   path, clock, count, ticker, typewriter, wipe, bounce, pulse, splash,
//   charge, particle_text, figure13, figure14, figure15,
//   print, melt
//       WIDTH HEIGHT MEAN MOST WHOLE STACK RAM
//       a frame of RGB565 in strips of 16 rows: what changed (mean, most), or
//       all of the screen (mean)
#include "board.hpp"
#include "body_scene.hpp"
#include "charge_scene.hpp"
#include "clock_scene.hpp"
#include "console.hpp"
#include "count_scene.hpp"
#include "counter.hpp"
#include "inkcell/motion/morph.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/simulation/advect.hpp"
#include "inkcell/simulation/dots.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "letters_scene.hpp"
#include "melt_scene.hpp"
#include "offset_scene.hpp"
#include "particle_scene.hpp"
#include "path_scene.hpp"
#include "print_scene.hpp"
#include "rom_file.hpp"
#include "stack.hpp"
#include "ticker_scene.hpp"
#include "typewriter_scene.hpp"
#include "vortex_scene.hpp"
#include "wipe_scene.hpp"

namespace {

using namespace inkcell;
using bench::open_font;
using bench::Total;

constexpr int32_t kMostWidth = 320;
constexpr int32_t kMostHeight = 240;
constexpr int32_t kRows = 16;

alignas(4) uint8_t font_bytes[1 << 17];
alignas(4) uint8_t pixels[kMostWidth * kRows * 2];
int8_t grid[48000];
simulation::Particle particles[600];
simulation::ParticleHome homes[600];
alignas(4) uint8_t ram[2560];
const Workspace lent(ram, sizeof ram);
motion::GridHistogram scratch;
Rect dirty_room[8];
Font font;

template <typename Work>
void count(const Work& work, Total& instructions, uint32_t& stack) {
  const auto used = static_cast<uint32_t>(board::count_stack(work));
  stack = used > stack ? used : stack;
  instructions.add(board::count_instructions(work));
}

bool measure_morph(int32_t px, int32_t scale_log2) {
  motion::MorphBox box;
  box.width = px * 70 / 100;
  box.height = px * 88 / 100;
  box.baseline = px * 81 / 100;
  box.scale_log2 = scale_log2;
  motion::GlyphMorph morph(font, Q26_6::from_int(px), kFilterMotion, box, grid);
  Total frames;
  Total sets;
  uint32_t stack = 0;
  Status status = Status::ok;
  for (uint32_t digit = 0; digit < 10; ++digit) {
    const uint16_t from = font.glyph_or_notdef('0' + digit);
    const uint16_t to = font.glyph_or_notdef('0' + (digit + 1) % 10);
    // The first knows neither.
    Total first;
    count([&] { status = morph.set(from, to, lent); },
          digit == 0 ? first : sets, stack);
    if (status != Status::ok) {
      return false;
    }
    for (int32_t part = 1; part < 16; ++part) {
      count(
          [&] {
            morph.step(Q16_16::from_raw(part << 12), scratch);
            for (int32_t y = 0; y < box.height; y += kRows) {
              morph.draw(
                  0, 0,
                  {port::A8Canvas({pixels, 0, y, box.width, kRows, box.width}),
                   lent});
            }
          },
          frames, stack);
    }
  }
  bench::print_row("morph", px, scale_log2, frames.mean(), frames.most,
                   sets.most, stack,
                   sizeof morph + sizeof scratch + motion::morph_bytes(box));
  return true;
}

bool measure_outline_morph(int32_t px) {
  const Style style(Q26_6::from_int(px), kFilterMotion);
  const int32_t width = px * 70 / 100;
  const int32_t height = px * 88 / 100;
  const Point origin(0, px * 81 / 100);
  Total frames;
  Total plain;
  uint32_t stack = 0;
  alignas(4) static uint8_t points[2048];
  const auto draw = [&](const motion::OutlineMorph& morph, int32_t part) {
    motion::MorphFrame frame(morph, style, origin, Q16_16::from_raw(part << 12),
                             Workspace(points, sizeof points));
    for (int32_t y = 0; y < height; y += kRows) {
      const port::A8Canvas canvas({pixels, 0, y, width, kRows, width});
      frame.draw(Painter(canvas, lent));
    }
  };
  for (uint32_t digit = 0; digit < 10; ++digit) {
    const uint16_t from = font.glyph_or_notdef('0' + digit);
    const uint16_t to = font.glyph_or_notdef('0' + (digit + 1) % 10);
    motion::OutlineMorph morph;
    if (motion::OutlineMorph::open(font, from, to, morph) != Status::ok) {
      continue;
    }
    for (int32_t part = 0; part < 16; ++part) {
      count([&] { draw(morph, part); }, part == 0 ? plain : frames, stack);
    }
  }
  if (frames.count != 0) {
    bench::print_row("outline_morph", px, frames.mean(), frames.most,
                     plain.mean(), stack);
  }
  return true;
}

// They fly inside walls and bounce off a letter of 96 px.
bool measure_particles() {
  constexpr uint32_t kCount = 400;
  constexpr int32_t kSide = 96;
  motion::DistanceGrid field(grid, kSide, kSide, 0);
  field.clear();
  if (field.paint(font, font.glyph_or_notdef('e'), Q26_6::from_int(kSide),
                  {Q26_6::from_int(18), Q26_6::from_int(74)},
                  lent) != Status::ok ||
      !simulation::spread_homes(field, 0, 0, 1, {homes, kCount})) {
    return false;
  }
  motion::RandomNumbers random(1);
  for (simulation::Particle& p : particles) {
    if (!simulation::find_edge(field, 0, 0, random, p)) {
      return false;
    }
    p.x_speed_q10 = static_cast<int16_t>(random.below(4096) - 2048);
    p.y_speed_q10 = static_cast<int16_t>(random.below(4096) - 2048);
  }
  simulation::ParticleRules rules;
  rules.walls = {0, 0, kSide, kSide};
  rules.gravity_q10 = 40;
  rules.attraction_q10 = 40;
  rules.bounce_q8 = 230;
  rules.side = simulation::ParticleSide::outside;
  Total steps;
  Total pulls;
  Total dots;
  uint32_t stack = 0;
  for (int32_t i = 0; i < 60; ++i) {
    count(
        [&] {
          simulation::step({particles, kCount}, rules, field, 0, 0);
        },
        steps, stack);
  }
  for (int32_t i = 0; i < 10; ++i) {
    count(
        [&] {
          simulation::pull_home({particles, kCount}, {homes, kCount},
                                Q16_16::from_raw(1000), Q26_6::from_int(2));
        },
        pulls, stack);
  }
  const port::A8Canvas canvas({pixels, 0, 0, kSide, kSide, kSide});
  if (canvas.status() != Status::ok) {
    return false;
  }
  for (size_t i = 0; i < 100; ++i) {
    count(
        [&] {
          simulation::draw_dot(particles[i].x, particles[i].y,
                               Q26_6::from_raw(83), canvas);
        },
        dots, stack);
  }
  bench::print_row("particles", kCount, (steps.mean() + kCount / 2) / kCount,
                   (pulls.mean() + kCount / 2) / kCount);
  bench::print_row("dot", dots.mean());
  return true;
}

// A letter of 96 px in a vortex.
bool measure_level_set() {
  constexpr int32_t kSide = 96;
  constexpr uint32_t kSamples = kSide * kSide;
  motion::DistanceGrid field(grid, kSide, kSide, 0);
  motion::DistanceGrid next({grid + kSamples, kSamples}, kSide, kSide, 0);
  field.clear();
  if (field.paint(font, font.glyph_or_notdef('e'), Q26_6::from_int(kSide),
                  {Q26_6::from_int(18), Q26_6::from_int(74)},
                  lent) != Status::ok) {
    return false;
  }
  simulation::Vortex vortex;
  vortex.x = vortex.y = Q16_16::from_int(kSide / 2);
  vortex.strength = 5120;
  vortex.core = 10;
  simulation::Flow flow;
  flow.vortices = {&vortex, 1};
  Total flows;
  Total sweeps;
  uint32_t stack = 0;
  for (int32_t i = 0; i < 8; ++i) {
    count([&] { simulation::advect(field, flow, next); }, flows, stack);
    count([&] { simulation::redistance(next, field); }, sweeps, stack);
  }
  // [1/10 of an instruction a sample]
  bench::print_row("level_set", kSide,
                   (flows.mean() * 10 + kSamples / 2) / kSamples,
                   (sweeps.mean() * 10 + kSamples / 2) / kSamples, stack);
  return true;
}

// A strip of RGB565 and its ink.
struct Sheet {
  port::Rgb565Canvas canvas;

  scenes::Paper paper(const Rect& part) {
    const int32_t width = part.x1 - part.x0;
    const int32_t height = part.y1 - part.y0;
    // Strips are as large as the pixels at most.
    canvas.set_strip({pixels, part.x0, part.y0, width, height, width * 2});
    return {part, this, [](void* context, uint32_t rgb) -> const Sink& {
              Sheet& sheet = *static_cast<Sheet*>(context);
              sheet.canvas.set_colour(port::rgb565(
                  static_cast<uint8_t>(rgb >> 16),
                  static_cast<uint8_t>(rgb >> 8), static_cast<uint8_t>(rgb)));
              return sheet.canvas;
            }};
  }
};

template <typename Scene>
void draw(Scene& scene, const Rect& part) {
  Sheet sheet;
  for (int32_t y = part.y0; y < part.y1; y += kRows) {
    const int32_t end = y + kRows < part.y1 ? y + kRows : part.y1;
    scene.draw(sheet.paper({part.x0, y, part.x1, end}));
  }
}

template <typename Scene, int32_t width, int32_t height>
bool measure_scene(const char* name, const char* text = Scene::kText) {
  constexpr uint32_t kEach = 7;  // frames are counted
  constexpr scenes::SceneNeeds needs = Scene::needs(width, height);
  static_assert(needs.grid <= sizeof grid &&
                    needs.particles <= sizeof particles / sizeof *particles &&
                    needs.homes <= sizeof homes / sizeof *homes,
                "there is room");
  static Scene scene(
      {&font,
       text,
       width,
       height,
       {{grid, needs.grid}, {particles, needs.particles}, {homes, needs.homes}},
       lent});
  if (scene.open() != Status::ok) {
    return false;
  }
  Total changed;
  Total whole;
  uint32_t stack = 0;
  const Rect screen = {0, 0, width, height};
  for (uint32_t i = 1; i < scenes::kLoopFrames; ++i) {
    if (i % kEach != 0) {
      scene.set_frame(i);
      continue;
    }
    // Stepped twice, and drawn: what the first counts is the second's stack.
    changed.add(board::count_instructions([&] {
      scene.set_frame(i);
      DirtyRects dirty(dirty_room);
      scene.add_changes(dirty);
      for (const Rect& part : dirty.rects()) {
        draw(scene, part);
      }
    }));
    count([&] { draw(scene, screen); }, whole, stack);
  }
  bench::print_row(
      name, width, height, changed.mean(), changed.most, whole.mean(), stack,
      sizeof(Scene) + needs.grid + needs.particles * sizeof *particles +
          needs.homes * sizeof *homes);
  return true;
}

template <scenes::Letters kLetters>
using Letters = scenes::LettersScene<kLetters>;

template <typename Scene>
bool measure_recipe(const char* name) {
  return measure_scene<Scene, 320, 240>(name) &&
         measure_scene<Scene, 128, 64>(name);
}

// Of the reel of inkcell-animate: its word, on its watch.
template <typename Scene>
bool measure_reel(const char* name, const char* text = "Inkcell") {
  return measure_scene<Scene, 240, 240>(name, text);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || !open_font(argv[1], font_bytes, font)) {
    return bench::fail("usage: FONT");
  }
  const bool is_measured =
      measure_recipe<scenes::CountScene>("count") &&
      measure_recipe<scenes::TickerScene>("ticker") &&
      measure_recipe<scenes::TypewriterScene>("typewriter") &&
      measure_recipe<scenes::WipeScene>("wipe") &&
      measure_recipe<Letters<scenes::Letters::bounce>>("bounce") &&
      measure_recipe<Letters<scenes::Letters::pulse>>("pulse") &&
      measure_recipe<Letters<scenes::Letters::splash>>("splash") &&
      measure_recipe<scenes::ChargeScene>("charge") && measure_morph(48, 0) &&
      measure_morph(96, 0) && measure_morph(96, 1) &&
      measure_outline_morph(48) && measure_outline_morph(96) &&
      measure_particles() && measure_level_set() &&
      measure_scene<scenes::BodyScene, 320, 240>("figure13") &&
      measure_scene<scenes::BodyScene, 128, 64>("figure13") &&
      measure_scene<scenes::OffsetScene, 320, 240>("figure14") &&
      measure_scene<scenes::OffsetScene, 128, 64>("figure14") &&
      measure_scene<scenes::PrintScene, 320, 240>("print") &&
      measure_scene<scenes::PrintScene, 128, 64>("print") &&
      measure_scene<scenes::VortexScene, 320, 240>("figure15") &&
      measure_scene<scenes::VortexScene, 128, 64>("figure15") &&
      measure_recipe<scenes::MeltScene>("melt") &&
      measure_scene<scenes::PathScene, 320, 240>("path") &&
      measure_scene<scenes::ClockScene, 320, 240>("clock") &&
      measure_scene<scenes::ClockScene, 128, 64>("clock") &&
      measure_scene<scenes::ClockScene, 96, 16>("clock") &&
      measure_scene<scenes::ParticleScene, 320, 240>("particle_text") &&
      measure_scene<scenes::ParticleScene, 128, 64>("particle_text") &&
      measure_reel<scenes::OffsetScene>("figure14") &&
      measure_reel<Letters<scenes::Letters::bounce>>("bounce") &&
      measure_reel<scenes::ParticleScene>("particle_text", "Inkcell Inkcell") &&
      measure_reel<scenes::PathScene>("path") &&
      measure_reel<scenes::WipeScene>("wipe", "Inkcell Inkcell") &&
      measure_reel<scenes::VortexScene>("figure15") &&
      measure_reel<Letters<scenes::Letters::pulse>>("pulse") &&
      measure_reel<scenes::PrintScene>("print") &&
      measure_reel<Letters<scenes::Letters::splash>>("splash") &&
      measure_reel<scenes::MeltScene>("melt", "Inkcell Inkcell") &&
      measure_reel<scenes::BodyScene>("figure13");
  if (!is_measured) {
    return bench::fail("a scene does not open, or the RAM is too small");
  }
  return 0;
}
