// Scene `clock`: four minutes in ten seconds, round and round; digits morph by
// their outlines if the font holds the pair, else they roll.
#pragma once

#include "inkcell/motion/recipes.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class ClockScene : public TextScene {
 public:
  static constexpr const char* kText = "12:58";

  /// The changes of its digits, as inkcell-fontgen --morph takes them.
  static constexpr const char* kMorphs =
      "01 12 23 34 45 56 67 78 89 90 50 20 30 18";

  /// The text is the first time, H:MM or HH:MM.
  explicit ClockScene(const SceneSetting& setting) noexcept;

  /// bad_argument: the text is not a time.
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  uint32_t next_due() const noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  motion::Clock clock_;
  uint32_t first_minute_ = 0;
};

}  // namespace inkcell::scenes
