// Scene `melt`: a word melts into a puddle, which levels; another word freezes
// out of it from below.
#pragma once

#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/simulation/melt.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A simulation: set_frame() steps as often as needed, from the start if it
/// goes back.
class MeltScene : public TextScene {
 public:
  static constexpr const char* kText = "COLD MELT";

  /// 2^scale pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 400 ? 2 : width > 200 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    const int32_t scale = scale_for(width);
    return {2 * samples_for(width, rows_for(width, height), scale) +
                samples_for(width, 1, scale),
            0, 0};
  }

  explicit MeltScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text is not two words with ink. buffer_small: the
  /// memory.
  Status open() noexcept;
  void set_frame(uint32_t to) noexcept;
  void draw(const Paper& paper) const noexcept;

 private:
  using Grid = motion::DistanceGrid;

  // The ink of a word takes at most this part of the height. [of 256]
  static constexpr int32_t kHeightPart = 120;
  static constexpr int32_t kMargin = 2;  // above and below it [samples]
  // The height of the grids. [px]
  static constexpr int32_t rows_for(int32_t width, int32_t height) noexcept {
    return (height * kHeightPart >> 8) +
           ((2 * kMargin + 1) << scale_for(width));
  }
  // So that either word fits, whichever is taller.
  static int32_t height_part(const SceneSetting& setting) noexcept;

  int32_t phase() const noexcept;
  size_t index() const noexcept;
  bool is_whole() const noexcept;
  bool is_at_rest() const noexcept;
  Rect shown() const noexcept;
  bool paint(size_t index, Grid& grid) noexcept;
  Point place(Text line) const noexcept;
  void step() noexcept;
  void swap() noexcept;

  // Parts of freeze_to().
  int32_t height_of(int32_t y) const noexcept;
  int32_t row_at(int32_t height) const noexcept;
  int32_t beside_of(int32_t x) const noexcept;
  void reveal(int32_t level) noexcept;
  int32_t deepest() const noexcept;
  int32_t depth_of(int32_t area) const noexcept;
  static int32_t apart_of(int32_t sample,
                          int32_t away,
                          int32_t height) noexcept;
  int32_t find_reach(int32_t depth, int32_t area) noexcept;
  void add_puddle(int32_t depth, int32_t reach, int32_t round) noexcept;
  void freeze_to(Q16_16 part) noexcept;

  Grid grids_[2];  // the shape; the word that is whole or freezes, or scratch
  Grid away_;      // a row: how far columns are from feet [samples]
  motion::GridHistogram scratch_;
  simulation::Melting how_;
  int32_t top_ = 0;  // the grids' upper edge [px from the screen's]
  uint32_t step_ = 0;
};

}  // namespace inkcell::scenes
