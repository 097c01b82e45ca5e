// Scenes have one SHA-256 of states and frames, on every machine: played, and
// sought to, and in strips of any height.
#include "body_scene.hpp"
#include "check.hpp"
#include "clock_scene.hpp"
#include "count_scene.hpp"
#include "expected_motion.hpp"
#include "fonts.hpp"
#include "inkcell/font.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "letters_scene.hpp"
#include "melt_scene.hpp"
#include "offset_scene.hpp"
#include "paper.hpp"
#include "particle_scene.hpp"
#include "path_scene.hpp"
#include "print_scene.hpp"
#include "sha256.hpp"
#include "ticker_scene.hpp"
#include "typewriter_scene.hpp"
#include "vortex_scene.hpp"
#include "wipe_scene.hpp"

namespace {

using namespace inkcell;
using golden::Sha256;

constexpr int32_t kWidth = 80;
constexpr int32_t kHeight = 40;
constexpr int32_t kRows = 4;
constexpr uint32_t kFrames = scenes::kLoopFrames;

constexpr size_t most(size_t a, size_t b) {
  return a > b ? a : b;
}
constexpr scenes::SceneNeeds kParticles =
    scenes::ParticleScene::needs(kWidth, kHeight);

constexpr scenes::SceneNeeds kBodies =
    scenes::BodyScene::needs(kWidth, kHeight);
constexpr scenes::SceneNeeds kOffsets =
    scenes::OffsetScene::needs(kWidth, kHeight);
constexpr scenes::SceneNeeds kPrint =
    scenes::PrintScene::needs(kWidth, kHeight);
constexpr scenes::SceneNeeds kMelt = scenes::MeltScene::needs(kWidth, kHeight);
constexpr scenes::SceneNeeds kVortex =
    scenes::VortexScene::needs(kWidth, kHeight);

// Two whole screens of samples, beside all others, are too much for 16 KB.
#ifdef INKCELL_SMALL_RAM
int8_t grid[most(kParticles.grid, kPrint.grid)];
#else
int8_t grid[most(
    most(most(kBodies.grid, kVortex.grid), most(kOffsets.grid, kMelt.grid)),
    most(kParticles.grid, kPrint.grid))];
#endif
static_assert(kOffsets.particles <= kParticles.particles, "there is room");
simulation::Particle particles[kParticles.particles];
simulation::ParticleHome homes[kParticles.homes];
alignas(4) uint8_t buffer[kWidth * kRows * 4];

Font& golden_font() {
  static Font font;
  CHECK_OK(Font::open(golden::font_bytes(golden::FontId::dejavu_sans_outline),
                      font));
  return font;
}

scenes::SceneSetting setting_of(Text text) {
  return {&golden_font(), text, kWidth, kHeight, {grid, particles, homes}};
}

// A strip and its ink.
struct Sheet {
  port::Xrgb8888Canvas canvas;

  scenes::Paper paper(int32_t y, int32_t rows) {
    const size_t bytes = static_cast<size_t>(kWidth * rows) * 4;
    canvas.set_strip({{buffer, bytes}, 0, y, kWidth, rows, kWidth * 4});
    CHECK_OK(canvas.status());
    return {canvas.window, this,
            [](void* context, uint32_t rgb) -> const Sink& {
              Sheet& sheet = *static_cast<Sheet*>(context);
              sheet.canvas.set_colour(0xff000000 | rgb);
              return sheet.canvas;
            }};
  }
};

template <typename Scene>
void add_frame(Scene& scene, int32_t rows, Sha256& sha) {
  const scenes::StateSink state = {
      &sha, [](void* context, int32_t value) {
        const auto bits = static_cast<uint32_t>(value);
        const uint8_t bytes[] = {
            static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
            static_cast<uint8_t>(bits >> 16), static_cast<uint8_t>(bits >> 24)};
        static_cast<Sha256*>(context)->add(bytes);
      }};
  scene.tell_state(state);
  Sheet sheet;
  for (int32_t y = 0; y < kHeight; y += rows) {
    scene.draw(sheet.paper(y, rows));
    sha.add(sheet.canvas.strip().pixels);
  }
}

bool equal(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

template <typename Scene>
void check_played(const char* name, Scene& scene, const char* expected) {
  CHECK_OK(scene.open());
  Sha256 sha;
  for (uint32_t i = 0; i < kFrames; ++i) {
    scene.set_frame(i);
    add_frame(scene, kRows, sha);
  }
  char hex[65];
  sha.finish().to_hex(hex);
  check::write(hex);
  check::write("  ");
  check::write(name);
  check::write("\n");
  CHECK(equal(hex, expected));
}

// Some frames on the way, and the same ones in another order, from a scene that
// has been elsewhere, in other strips.
template <typename Scene>
void check_sought(Scene& scene) {
  const uint32_t kSome[] = {60, 170, 90, 25};
  char first[4][65];
  CHECK_OK(scene.open());
  uint32_t frame = 0;
  const uint32_t kAscending[] = {kSome[3], kSome[0], kSome[2], kSome[1]};
  for (const uint32_t target : kAscending) {
    while (frame <= target) {
      scene.set_frame(frame++);
    }
    Sha256 sha;
    add_frame(scene, kRows, sha);
    for (int i = 0; i < 4; ++i) {
      if (kSome[i] == target) {
        sha.finish().to_hex(first[i]);
        break;
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    scene.set_frame(kSome[i]);
    Sha256 sha;
    add_frame(scene, 1, sha);
    char hex[65];
    sha.finish().to_hex(hex);
    CHECK(equal(hex, first[i]));
  }
}

}  // namespace

TEST(path_has_one_hash) {
  static scenes::PathScene scene(setting_of("Inkcel Inkcel"));
  check_played("path", scene, golden::kPathHash);
  check_sought(scene);
}

TEST(clock_has_one_hash) {
  // The font has two digits; others are .notdef.
  static scenes::ClockScene scene(setting_of("22:39"));
  check_played("clock", scene, golden::kClockHash);
  check_sought(scene);
}

TEST(recipes_have_one_hash_each) {
  static scenes::CountScene count(setting_of("4224"));
  check_played("count", count, golden::kCountHash);
  check_sought(count);
  static scenes::TickerScene ticker(setting_of("Inkcel 42"));
  check_played("ticker", ticker, golden::kTickerHash);
  static scenes::TypewriterScene line(setting_of("Inkcel"));
  check_played("typewriter", line, golden::kTypewriterHash);
  check_sought(line);
  static scenes::WipeScene wipe(setting_of("Ink cell"));
  check_played("wipe", wipe, golden::kWipeHash);
  check_sought(wipe);
#ifndef INKCELL_SMALL_RAM
  static scenes::LettersScene<scenes::Letters::bounce> bounce(
      setting_of("Inkcel"));
  check_played("bounce", bounce, golden::kBounceHash);
  static scenes::LettersScene<scenes::Letters::splash> splash(
      setting_of("Inkcel"));
  check_played("splash", splash, golden::kSplashHash);
#endif
}

#ifndef INKCELL_SMALL_RAM
TEST(figure13_has_one_hash) {
  static scenes::BodyScene scene(setting_of("Inkcel"));
  check_played("figure13", scene, golden::kFigure13Hash);
  check_sought(scene);
}

TEST(figure14_has_one_hash) {
  static scenes::OffsetScene scene(setting_of("Ink"));
  check_played("figure14", scene, golden::kFigure14Hash);
  check_sought(scene);
}

TEST(melt_has_one_hash) {
  static scenes::MeltScene scene(setting_of("Ink cel"));
  check_played("melt", scene, golden::kMeltHash);
  check_sought(scene);
}

TEST(figure15_has_one_hash) {
  static scenes::VortexScene scene(setting_of("e"));
  check_played("figure15", scene, golden::kFigure15Hash);
  check_sought(scene);
}
#endif

TEST(print_has_one_hash) {
  static scenes::PrintScene scene(setting_of("Ie"));
  check_played("print", scene, golden::kPrintHash);
  check_sought(scene);
}

TEST(particles_have_one_hash) {
  static scenes::ParticleScene scene(setting_of("Ink cel"));
  check_played("particles", scene, golden::kParticlesHash);
  check_sought(scene);
}
