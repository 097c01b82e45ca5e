// Scene `path`: letters fly onto a wave, ride it, and leave.
#pragma once

#include "inkcell/motion/outline_morph.hpp"
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
  struct Letter {
    motion::OutlineMorph morph;  // to its second master, or to itself
    motion::PosedGlyph posed;
    Q16_16 bold;  // the part of the way to the second master
  };

  static constexpr int32_t kPieces = 16;  // of each half of the wave

  void make_wave(int32_t time_ms) noexcept;
  motion::Pose pose_of(size_t index, int32_t time_ms) const noexcept;
  int32_t half_growth(const motion::OutlineMorph& morph,
                      Q16_16 bold) const noexcept;

  motion::PathPlace on_path_;
  motion::PoseRenderer renderer_;
  motion::RunGlyph glyphs_[kMaxGlyphs];
  motion::Run run_;
  motion::PathPoint points_[2 * kPieces + 1];
  motion::Path path_;
  Letter letters_[kMaxGlyphs];
  Rect changed_[kMaxGlyphs];
};

}  // namespace inkcell::scenes
