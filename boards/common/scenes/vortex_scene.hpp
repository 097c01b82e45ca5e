// Scene `figure15`: a vortex winds a letter up, and runs back.
#pragma once

#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "paint_text.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// Figure 15 of Perry and Frisken: level sets, and layers or a print drawn by
/// distance. A function of its frame's number.
class VortexScene : public SceneBase {
 public:
  static constexpr const char* kText = "&";

  /// 2^scale pixels a sample along each side: the grid knows distances of 4
  /// samples, which the outermost layer needs.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 400 ? 2 : width > 200 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    const int32_t scale = scale_for(width);
    return {2 * samples_for(width, height, scale) +
                samples_for(letter_side(width, width * 5 / 8),
                            letter_side(width, height / 2), scale),
            0, 0};
  }

  explicit VortexScene(const SceneSetting& setting) noexcept;

  /// Prints the letter, instead of drawing it in layers.
  void print_as(simulation::PrintStyle style) noexcept {
    print_ = style;
    is_print_ = true;
  }

  /// bad_argument: the text has no ink. buffer_small: the memory.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void add_changes(DirtyRects& dirty) const noexcept;
  uint32_t next_due() const noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  // The pixels of the letter's grid: those of its ink, and of 5 samples around.
  static constexpr int32_t letter_side(int32_t width, int32_t ink) noexcept {
    return ink + (10 << scale_for(width));
  }

  bool paint_letter() noexcept;
  void draw_layers(const Paper& paper) const noexcept;
  void draw_print(const Paper& paper) const noexcept;

  motion::DistanceGrid grid_;  // what is drawn
  motion::DistanceGrid next_;
  motion::DistanceGrid letter_;
  int32_t left_ = 0;  // of the letter's grid, in the others
  int32_t top_ = 0;
  simulation::PrintStyle print_ = simulation::PrintStyle::relief;
  bool is_print_ = false;
  motion::GridHistogram scratch_;
  Fixed<int32_t, 13> cutoff_;  // of the wound letter, by its area
  int32_t area_ = 0;           // of the letter
  int32_t most_turn_ = 0;
  int32_t turn_ = 0;  // of the vortex's centre [turns, Q16]
  bool has_changed_ = true;
};

}  // namespace inkcell::scenes
