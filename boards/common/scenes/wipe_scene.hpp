// Scene `wipe`: a soft edge wipes one word off and reveals another behind it.
#pragma once

#include "inkcell/motion/recipes.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class WipeScene : public TextScene {
 public:
  static constexpr const char* kText = "MORNING EVENING";

  explicit WipeScene(const SceneSetting& setting) noexcept
      : TextScene(setting, setting.text, 430, 110),
        hides_{wipe(0, 0, Wipe::Kind::hide), wipe(1, kHalf, Wipe::Kind::hide)},
        shows_{wipe(1, 0, Wipe::Kind::reveal),
               wipe(0, kHalf, Wipe::Kind::reveal)} {
    const Rect box =
        bounding_box(Painter().box(font(), style(), centred(word(0)), word(0)),
                     Painter().box(font(), style(), centred(word(1)), word(1)));
    // Slow at its ends, the edge would show slivers of letters there; so would
    // an edge that hides as softly as the other one reveals.
    const int32_t x0 = box.x0 - px(256);
    const int32_t x1 = box.x1 + px(256);
    const uint8_t ahead = soft(40);
    const uint8_t behind = soft(128);
    for (size_t i = 0; i < 2; ++i) {
      // One edge ends where the other begins: both words are never seen.
      hides_[i].set_edge(x0 + ahead, x1 + behind, ahead);
      shows_[i].set_edge(x0, x1, behind);
    }
  }

  /// bad_argument: the text is not two words with ink.
  Status open() noexcept {
    return word(1).size == 0 ? Status::bad_argument : status();
  }

  void set_frame(uint32_t frame) noexcept {
    // It begins when the edge is near the word.
    const uint32_t at = (frame + 8) % (2 * kHalf);
    const int32_t now = time_of(at);
    half_ = at / kHalf;
    next(frame,
         bounding_box(hides_[half_].at(now, {}), shows_[half_].at(now, {})));
  }

  void draw(const Paper& paper) const noexcept {
    paper.fill(0x0c1622);
    constexpr uint32_t kInks[] = {0xffb35c, 0x8fb7ff};
    hides_[half_].draw(painter(paper, kInks[half_]));
    shows_[half_].draw(painter(paper, kInks[1 - half_]));
  }

 private:
  using Wipe = motion::Wipe;
  static constexpr uint32_t kHalf = 75;  // [frames]

  // A softness: a part of the size, at most what fits. [px]
  uint8_t soft(int32_t part_q8) const noexcept {
    const int32_t wide = px(part_q8);
    return static_cast<uint8_t>(wide < UINT8_MAX ? wide : UINT8_MAX);
  }
  Wipe wipe(size_t index, uint32_t frame, Wipe::Kind kind) const noexcept {
    return {font(),
            style(),
            centred(word(index)),
            word(index),
            {time_of(frame), 1600},
            kind};
  }

  Wipe hides_[2];
  Wipe shows_[2];
  uint32_t half_ = 0;
};

}  // namespace inkcell::scenes
