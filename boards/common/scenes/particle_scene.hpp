// Scene `particles`: a word bursts, its pieces fall and gather as another word;
// some orbit the letters all the time.
#pragma once

#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "paint_text.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// A simulation: each frame follows from the one before. set_frame() steps as
/// often as needed, from the start if it goes back.
class ParticleScene : public SceneBase {
 public:
  /// Two words.
  static constexpr const char* kText = "Ink cell";

  /// Pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 200 ? 2 : width > 100 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    const auto area = static_cast<size_t>(width * height);
    const size_t pieces = area > 520 * 64 ? 520 : area / 64;
    return {samples_for(width, height, scale_for(width)), pieces + pieces / 10,
            pieces};
  }

  explicit ParticleScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text is not two words with ink. buffer_small: the memory
  /// is too small.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  void restart() noexcept;
  void place_particles() noexcept;
  void step() noexcept;
  void burst() noexcept;
  bool show_word(size_t word) noexcept;
  void begin_word(size_t word) noexcept;
  bool paint_letters(uint32_t part, uint32_t parts) noexcept;
  int32_t px_q6(int32_t units) const noexcept;
  void draw_rings(const Paper& paper) const noexcept;
  void draw_word(const Paper& paper) const noexcept;
  void draw_particles(const Paper& paper) const noexcept;

  Q26_6 size_;
  motion::DistanceGrid grid_;
  Point origin_;  // of the word
  Rect word_box_;
  Span<simulation::ParticleHome> homes_;
  Span<simulation::Particle> pieces_;  // one for each home
  Span<simulation::Particle> flies_;
  motion::RandomNumbers random_;
  size_t word_ = 0;  // of the distances in the grid
};

}  // namespace inkcell::scenes
