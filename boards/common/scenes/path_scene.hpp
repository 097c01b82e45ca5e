// Scene `path`: letters fly onto a wave, ride it, and leave.
#pragma once

#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class PathScene : public SceneBase {
 public:
  static constexpr size_t kMaxGlyphs = 24;
  static constexpr const char* kText = "moving type";

  static constexpr SceneNeeds needs(int32_t, int32_t) noexcept { return {}; }

  explicit PathScene(const SceneSetting& setting) noexcept;

  /// buffer_small: the text has more than kMaxGlyphs glyphs.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void add_changes(DirtyRects& dirty) const noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  static constexpr int32_t kPieces = 16;  // of each half of the wave

  void make_wave(int32_t time_ms) noexcept;
  motion::Pose pose_of(size_t index, int32_t time_ms) const noexcept;

  motion::PathPlace on_path_;
  motion::PoseRenderer renderer_;
  motion::RunGlyph glyphs_[kMaxGlyphs];
  motion::Run run_;
  motion::PathPoint points_[2 * kPieces + 1];
  motion::Path path_;
  motion::PosedGlyph posed_[kMaxGlyphs];
  motion::PosedGlyph before_[kMaxGlyphs];
};

}  // namespace inkcell::scenes
