// Scene `figure15`: a vortex winds a letter up until it tears; it grows anew.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// Figure 15 of Perry and Frisken: level sets, and layers or a print drawn by
/// distance. A simulation: set_frame() steps as often as needed, from the start
/// if it goes back.
class VortexScene {
 public:
  static constexpr const char* kText = "&";

  /// 2^scale pixels a sample along each side: the grid knows distances of 4
  /// samples, which the outermost layer needs.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 400 ? 2 : width > 200 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    using motion::DistanceGrid;
    const int32_t scale = scale_for(width);
    const auto grid =
        static_cast<size_t>(DistanceGrid::samples_of(width, scale) *
                            DistanceGrid::samples_of(height, scale));
    return {2 * grid, 0, 0};
  }

  explicit VortexScene(const SceneSetting& setting) noexcept;
  VortexScene(const VortexScene&) = delete;
  VortexScene& operator=(const VortexScene&) = delete;

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
  bool restart() noexcept;
  bool paint(motion::DistanceGrid& grid) noexcept;
  void keep_area() noexcept;
  void step() noexcept;
  bool is_old_shown() const noexcept;
  void draw_shape(const Paper& paper,
                  const motion::DistanceGrid& grid,
                  Q16_16 thinned) const noexcept;
  void draw_print(const Paper& paper,
                  const motion::DistanceGrid& grid,
                  int32_t thinner_q6,
                  uint8_t opacity) const noexcept;
  int32_t cutoff_of(const motion::DistanceGrid& grid,
                    int32_t offset_q6) const noexcept;

  const Font& font_;
  Text text_;
  int32_t width_;
  int32_t height_;
  motion::DistanceGrid grid_;
  motion::DistanceGrid next_;  // or what is left of the letter before
  Workspace workspace_;
  simulation::PrintStyle print_ = simulation::PrintStyle::relief;
  bool is_print_ = false;
  motion::GridHistogram scratch_;
  Fixed<int32_t, 13> cutoff_;  // keeps the area of the wound letter
  int32_t area_ = 0;
  uint32_t frame_ = 0;
  Rect before_;  // drawn by the last two frames
  Rect now_;
  bool has_changed_ = true;
};

}  // namespace inkcell::scenes
