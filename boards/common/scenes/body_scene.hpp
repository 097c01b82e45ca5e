// Scene `figure13`: letters fall, bounce, deform each other, and come to rest.
#pragma once

#include "inkcell/simulation/bodies.hpp"
#include "inkcell/simulation/body_shape.hpp"
#include "scene_base.hpp"

namespace inkcell::scenes {

/// Figure 13 of Perry and Frisken: soft bodies. A simulation: set_frame() steps
/// as often as needed, from the start if it goes back.
class BodyScene : public SceneBase {
 public:
  static constexpr const char* kText = "soft type";
  static constexpr int32_t kMostLetters = 8;
  /// Around a letter: as far as the distances of a grid reach.
  static constexpr int32_t kMarginSamples = 4;

  /// [px to the em]
  static constexpr int32_t size_for(int32_t height) noexcept {
    return height < 32    ? height * 5 / 8
           : height < 120 ? height * 2 / 5
                          : height / 4;
  }
  /// Pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t height) noexcept {
    return height < 120 ? 0 : 1;
  }
  /// Enough for kText.
  static constexpr SceneNeeds needs(int32_t, int32_t height) noexcept {
    const int32_t scale = scale_for(height);
    const int32_t side =
        (size_for(height) * 5 / 8 >> scale) + 2 * kMarginSamples + 2;
    return {static_cast<size_t>(kMostLetters * side * side), 0, 0};
  }
  /// Enough for a text: tall and wide letters need more.
  static SceneNeeds needs(const Font& font, Text text, int32_t height) noexcept;

  explicit BodyScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text has no ink. buffer_small: more than kMostLetters
  /// letters, or the memory is too small.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void add_changes(DirtyRects& dirty) const noexcept;
  uint32_t next_due() const noexcept;
  void tell_state(const StateSink& sink) const noexcept;

  /// For tests: the letters on the screen, and the rules of their motion.
  Span<const simulation::Body> bodies() const noexcept {
    return {bodies_, static_cast<size_t>(count_)};
  }
  simulation::BodyRules rules() const noexcept;

 private:
  static constexpr size_t kPoints = 60;
  // Contacts: each letter touches two others, and walls.
  static constexpr size_t kContacts = simulation::kContactsOfPair * 20;

  // The floor is seen: a part of the height.
  int32_t floor_top() const noexcept { return height_ - height_ / 16; }
  Status add_shape(uint16_t glyph,
                   const Rect& box,
                   Span<int8_t>& memory) noexcept;
  void restart() noexcept;
  void let_fall(int32_t index) noexcept;
  void wake(bool is_kick) noexcept;
  void step() noexcept;
  bool has_changed(int32_t index) const noexcept;
  Rect swept_box(int32_t index) const noexcept;

  Span<int8_t> memory_;
  simulation::BodyShape shapes_[kMostLetters];
  simulation::BodyPoint points_[kMostLetters][kPoints];
  uint16_t glyphs_[kMostLetters] = {};  // of the shapes
  uint8_t shape_of_[kMostLetters] = {};
  int32_t shape_count_ = 0;
  int32_t count_ = 0;
  simulation::Body bodies_[kMostLetters];
  simulation::BodyContact contacts_[kContacts];
  simulation::Body before_[kMostLetters];  // as they were drawn before
  bool has_moved_[kMostLetters] = {};
  uint32_t frame_before_ = 0;
};

}  // namespace inkcell::scenes
