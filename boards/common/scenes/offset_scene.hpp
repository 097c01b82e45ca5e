// Scene `figure14`: offset curves of letters push particles away and attract
// them.
#pragma once

#include "inkcell/filter.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/simulation/particles.hpp"
#include "paint_text.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// Figure 14 of Perry and Frisken: attraction, repulsion and collision by one
/// field, and offset curves that merge and split. A simulation: set_frame()
/// steps as often as needed, from the start if it goes back.
class OffsetScene : public SceneBase {
 public:
  static constexpr const char* kText = "Ink";

  /// Pixels a sample along each side; twice as many in a second grid, whose
  /// distances reach twice as far.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 200 ? 2 : width > 100 ? 1 : 0;
  }
  /// The screen in a third grid, whose distances reach 2/5 of the height.
  static constexpr int32_t kGuideRows = 10;
  static constexpr int32_t guide_columns(int32_t width,
                                         int32_t height) noexcept {
    return (width * kGuideRows + height - 1) / height;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    const int32_t scale = scale_for(width);
    const auto area = static_cast<size_t>(width * height);
    return {samples_for(width, height, scale) +
                samples_for(width, height, scale + 1) +
                samples_for(guide_columns(width, height), kGuideRows, 0),
            area > 400 * 80 ? 400 : area / 80, 0};
  }

  explicit OffsetScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text has no ink. buffer_small: the memory.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  void place_particles() noexcept;
  void step() noexcept;
  void scatter(int32_t most_q10) noexcept;
  void pull_from_afar(int32_t strength_q10) noexcept;
  int32_t offset_q6() const noexcept;
  const motion::DistanceGrid& grid_for(int32_t offset_q6) const noexcept;
  void prepare() noexcept;

  motion::DistanceGrid grid_;
  motion::DistanceGrid far_grid_;
  motion::DistanceGrid guide_;  // the whole screen, for far particles
  TextPlace place_;
  Span<simulation::Particle> particles_;
  Filter soft_;  // between bands
};

}  // namespace inkcell::scenes
