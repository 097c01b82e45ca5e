// Scene `count`: a number rolls up, rests, and rolls back.
#pragma once

#include "inkcell/motion/recipes.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class CountScene : public TextScene {
 public:
  static constexpr const char* kText = "1250";

  explicit CountScene(const SceneSetting& setting) noexcept
      : TextScene(setting, zeros(setting.text.size), 200, 120),
        counter_(font(), style(), origin(), static_cast<int32_t>(text().size)) {
  }

  /// bad_argument: the text is not a number of up to 9 digits.
  Status open() noexcept {
    return read_number(999999999, "", most_) ? status() : Status::bad_argument;
  }

  void set_frame(uint32_t frame) noexcept {
    const int32_t now = time_of(frame % kFrames);
    const bool is_up = now < kBackMs;
    counter_.roll(is_up ? 0 : most_, is_up ? most_ : 0,
                  {is_up ? 0 : kBackMs, is_up ? 2600 : 800},
                  is_up ? motion::kArrive : motion::kEaseInOut);
    const Rect rolls = counter_.at(now);
    next(frame, is_empty(rolls) ? rolls : bounding_box(counter_.box(), bar()));
  }

  void draw(const Paper& paper) const noexcept {
    paper.fill(0x10141c);
    counter_.draw(painter(paper, 0x7fe0b0));
    Rect part = bar();
    paper.fill(0x2a3444, part);
    const int64_t width = part.x1 - part.x0;
    part.x1 = part.x0 + static_cast<int32_t>(width * counter_.value() / most_);
    paper.fill(0x3fa878, part);
  }

 private:
  static constexpr uint32_t kFrames = 150;
  static constexpr int32_t kBackMs = 4100;

  // As wide as the wheels.
  static Text zeros(size_t digits) noexcept {
    return {"000000000", digits < 9 ? digits : 9};
  }

  // Below the number.
  Rect bar() const noexcept {
    Rect bar = counter_.box();
    bar.y0 = bar.y1 + px(16);
    bar.y1 = bar.y0 + px(20);
    return bar;
  }

  motion::Counter counter_;
  int32_t most_ = 0;
};

}  // namespace inkcell::scenes
