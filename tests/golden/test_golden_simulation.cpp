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

}  // namespace

#ifndef INKCELL_SMALL_RAM
TEST(figure13_has_one_hash) {
  check_scene<scenes::BodyScene>("figure13", "Inkcel", kFigure13Hash,
                                 {grid, particles, homes});
}

TEST(figure14_has_one_hash) {
  check_scene<scenes::OffsetScene>("figure14", "Ink", kFigure14Hash,
                                   {grid, particles, homes});
}

TEST(melt_has_one_hash) {
  check_scene<scenes::MeltScene>("melt", "Ink cel", kMeltHash,
                                 {grid, particles, homes});
}

TEST(figure15_has_one_hash) {
  check_scene<scenes::VortexScene>("figure15", "e", kFigure15Hash,
                                   {grid, particles, homes});
}
#endif

TEST(print_has_one_hash) {
  check_scene<scenes::PrintScene>("print", "Ie", kPrintHash,
                                  {grid, particles, homes});
}

TEST(particles_have_one_hash) {
  check_scene<scenes::ParticleScene>("particles", "Ink cel", kParticlesHash,
                                     {grid, particles, homes});
}
