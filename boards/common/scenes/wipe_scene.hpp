// Scene `wipe`: an edge wipes one word off and reveals another.
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
    // Slow at its ends, the edge would show slivers of letters there.
    const int32_t beside = px(128);
    for (size_t i = 0; i < 2; ++i) {
      hides_[i].set_edge(box.x0 - beside, box.x1 + beside, kSoft);
      shows_[i].set_edge(box.x0 - beside, box.x1 + beside, kSoft);
    }
  }

  /// bad_argument: the text is not two words with ink.
  Status open() noexcept {
    return word(1).size == 0 ? Status::bad_argument : status();
  }

  void set_frame(uint32_t frame) noexcept {
    const int32_t now = time_of(frame % (2 * kHalf));
    half_ = frame / kHalf % 2;
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
  static constexpr uint8_t kSoft = 2;    // [px] Both words are never seen.

  Wipe wipe(size_t index, uint32_t frame, Wipe::Kind kind) const noexcept {
    return {font(),
            style(),
            centred(word(index)),
            word(index),
            {time_of(frame) + 1000, 900},
            kind};
  }

  Wipe hides_[2];
  Wipe shows_[2];
  uint32_t half_ = 0;
};

}  // namespace inkcell::scenes
