// Scene `ticker`: a line runs by without end, and fades at both ends.
#pragma once

#include "inkcell/layout/label.hpp"
#include "inkcell/motion/fade.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class TickerScene : public TextScene {
 public:
  static constexpr const char* kText =
      "Oslo 4   Rome 18   Quito 11   Perth 24  ";

  explicit TickerScene(const SceneSetting& setting) noexcept
      : TextScene(setting, "Oslo 4", 190, 64) {}

  /// bad_argument: no ink. buffer_small: over 64 letters.
  Status open() noexcept {
    window_ = screen();
    window_.y0 = window_.y1 / 2 - px(160);
    window_.y1 -= window_.y0;
    const Status made = ScrollingLabel::make(LayoutOptions(font(), style()), {},
                                             text(), window_, glyphs_, label_);
    return made == Status::ok && label_.width().raw == 0 ? Status::bad_argument
                                                         : made;
  }

  void set_frame(uint32_t frame) noexcept { next(frame, window_); }

  void draw(const Paper& paper) const noexcept {
    paper.fill(0x141018);
    paper.fill(0x241c2c, window_);
    motion::SoftWindow soft;
    soft.target = &paper.with(0xffc46b);
    soft.window = window_;
    soft.soft.left = soft.soft.right = static_cast<uint8_t>(px(80) & 255);
    const Q26_6 gap = Q26_6::from_int(px(80));
    // All of the line in a loop.
    const int64_t whole = label_.width().raw + gap.raw;
    label_.draw_endless(Q26_6::from_raw(static_cast<int32_t>(
                            whole * (frame() % kLoopFrames) / kLoopFrames)),
                        gap, {make_sink(soft), workspace()});
  }

 private:
  PositionedGlyph glyphs_[64];
  ScrollingLabel label_;
  Rect window_;
};

}  // namespace inkcell::scenes
