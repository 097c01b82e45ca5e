// Scene `path`: letters fly onto a wave, ride it, and leave.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/text.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class PathScene {
 public:
  static constexpr size_t kMaxGlyphs = 24;
  static constexpr const char* kText = "moving type";

  static constexpr SceneNeeds needs(int32_t, int32_t) noexcept { return {}; }

  explicit PathScene(const SceneSetting& setting) noexcept;
  PathScene(const PathScene&) = delete;
  PathScene& operator=(const PathScene&) = delete;

  /// buffer_small: the text has more than kMaxGlyphs glyphs.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;

  /// Adds the areas in which the frame differs from the one before.
  void add_changes(DirtyRects& dirty) const noexcept;
  /// The next frame that looks different.
  uint32_t next_due() const noexcept { return frame_ + 1; }
  void tell_state(const StateSink& sink) const noexcept;

 private:
  static constexpr int32_t kPieces = 16;  // of each half of the wave

  void make_wave(int32_t time_ms) noexcept;
  motion::Pose pose_of(size_t index, int32_t time_ms) const noexcept;

  const Font& font_;
  Text text_;
  int32_t width_;
  int32_t height_;
  motion::PathPlace on_path_;
  motion::PoseRenderer renderer_;
  Workspace workspace_;
  motion::RunGlyph glyphs_[kMaxGlyphs];
  motion::Run run_;
  motion::PathPoint points_[2 * kPieces + 1];
  motion::Path path_;
  motion::PosedGlyph posed_[kMaxGlyphs];
  motion::PosedGlyph before_[kMaxGlyphs];
  uint32_t frame_ = 0;
};

}  // namespace inkcell::scenes
