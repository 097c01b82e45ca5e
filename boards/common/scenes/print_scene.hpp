// Scene `print`: light moves round a word that is printed in five styles.
#pragma once

#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "paint_text.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// Relief, engraving, rings, hatching, halftone: each wipes over the one
/// before. A function of time: frames can be drawn in any order.
class PrintScene : public SceneBase {
 public:
  static constexpr const char* kText = "Ag";

  /// Pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 200 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    return {samples_for(width, height, scale_for(width)), 0, 0};
  }

  explicit PrintScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text has no ink. buffer_small: the memory.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept { frame_ = frame; }
  void draw(const Paper& paper) noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  simulation::PrintLook look_of(uint32_t part) const noexcept;
  void draw_part(const Paper& paper,
                 uint32_t part,
                 const Rect& window) const noexcept;

  motion::DistanceGrid grid_;
};

}  // namespace inkcell::scenes
