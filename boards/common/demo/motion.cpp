#include "motion.hpp"

#include <fonts/motion.hpp>

#include INKCELL_MOTION_HEADER
#include "inkcell/font.hpp"
#include "motion_paper.hpp"
#include "show.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {
namespace {

using Scene = scenes::INKCELL_MOTION_SCENE;

constexpr scenes::SceneNeeds kNeeds = Scene::needs(kWidth, kHeight);

// Arrays have at least one element.
constexpr size_t some(size_t count) noexcept {
  return count == 0 ? 1 : count;
}

// Speeds up large glyphs; small displays have little RAM.
constexpr size_t kLentBytes = kHeight < 100 ? 0 : 2560;

// Open from the start: scenes may measure their text as they are made.
struct OpenFont {
  OpenFont() noexcept : status(Font::open(fonts::motion, font)) {}

  Font font;
  Status status;
};

OpenFont motion;
int8_t grid[some(kNeeds.grid)];
simulation::Particle particles[some(kNeeds.particles)];
simulation::ParticleHome homes[some(kNeeds.homes)];
alignas(4) uint8_t ram[some(kLentBytes)];

Scene scene({&motion.font,
             Scene::kText,
             kWidth,
             kHeight,
             {{grid, kNeeds.grid},
              {particles, kNeeds.particles},
              {homes, kNeeds.homes}},
             {ram, kLentBytes}});

}  // namespace

Status open_motion() noexcept {
  INKCELL_TRY(motion.status);
  return scene.open();
}

void show_motion(uint32_t frame) noexcept {
  scene.set_frame(frame);
  show([](void*, const Strip& strip) {
    MotionPaper paper(strip);
    scene.draw(paper.paper());
    return Status::ok;
  });
}

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
