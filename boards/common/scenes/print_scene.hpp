// Scene `print`: light moves round a word that is printed in five styles.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/simulation/print_draw.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// Relief, engraving, rings, hatching, halftone: each wipes over the one
/// before. A function of time: frames can be drawn in any order.
class PrintScene {
 public:
  static constexpr const char* kText = "Ag";

  /// Pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 200 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    using motion::DistanceGrid;
    const int32_t scale = scale_for(width);
    return {static_cast<size_t>(DistanceGrid::samples_of(width, scale) *
                                DistanceGrid::samples_of(height, scale)),
            0, 0};
  }

  explicit PrintScene(const SceneSetting& setting) noexcept;
  PrintScene(const PrintScene&) = delete;
  PrintScene& operator=(const PrintScene&) = delete;

  /// bad_argument: the text has no ink. buffer_small: the memory.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept { frame_ = frame; }
  void draw(const Paper& paper) noexcept;
  void add_changes(DirtyRects& dirty) const noexcept;
  uint32_t next_due() const noexcept { return frame_ + 1; }
  void tell_state(const StateSink& sink) const noexcept;

 private:
  simulation::PrintLook look_of(uint32_t part) const noexcept;
  void draw_part(const Paper& paper,
                 uint32_t part,
                 const Rect& window) const noexcept;

  const Font& font_;
  Text text_;
  int32_t width_;
  int32_t height_;
  motion::DistanceGrid grid_;
  Workspace workspace_;
  Rect box_;
  uint32_t frame_ = 0;
};

}  // namespace inkcell::scenes
