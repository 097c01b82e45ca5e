// Scenes that simulate have one hash each, on every machine.
#include "body_scene.hpp"
#include "melt_scene.hpp"
#include "offset_scene.hpp"
#include "particle_scene.hpp"
#include "print_scene.hpp"
#include "scene_hash.hpp"
#include "vortex_scene.hpp"

namespace {

using namespace golden;

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

scenes::SceneSetting setting_of(Text text) {
  return {&golden_font(), text, kWidth, kHeight, {grid, particles, homes}};
}

}  // namespace

#ifndef INKCELL_SMALL_RAM
TEST(figure13_has_one_hash) {
  static scenes::BodyScene scene(setting_of("Inkcel"));
  check_played("figure13", scene, kFigure13Hash);
  check_sought(scene);
}

TEST(figure14_has_one_hash) {
  static scenes::OffsetScene scene(setting_of("Ink"));
  check_played("figure14", scene, kFigure14Hash);
  check_sought(scene);
}

TEST(melt_has_one_hash) {
  static scenes::MeltScene scene(setting_of("Ink cel"));
  check_played("melt", scene, kMeltHash);
  check_sought(scene);
}

TEST(figure15_has_one_hash) {
  static scenes::VortexScene scene(setting_of("e"));
  check_played("figure15", scene, kFigure15Hash);
  check_sought(scene);
}
#endif

TEST(print_has_one_hash) {
  static scenes::PrintScene scene(setting_of("Ie"));
  check_played("print", scene, kPrintHash);
  check_sought(scene);
}

TEST(particles_have_one_hash) {
  static scenes::ParticleScene scene(setting_of("Ink cel"));
  check_played("particles", scene, kParticlesHash);
  check_sought(scene);
}
