// Scene `pulse`: weight runs along a line, by the second masters of the font,
// or by edges that move outwards where it has none.
#pragma once

#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/recipes.hpp"
#include "letters_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class PulseScene : public LettersScene<Letters::pulse> {
 public:
  explicit PulseScene(const SceneSetting& setting) noexcept
      : LettersScene(setting),
        line_(font(),
              style(),
              origin(),
              setting.text,
              {800, {0, time_of(kFrames), 0}, {90}}) {}

  /// As the scene without masters; of these, any text that has ink.
  Status open() noexcept {
    Text letters = text();
    has_masters_ = false;
    while (letters.size != 0 && !has_masters_) {
      motion::OutlineMorph morph;
      has_masters_ =
          motion::OutlineMorph::open_master(
              font(), font().glyph_or_notdef(next_code_point(letters)),
              morph) == Status::ok;
    }
    return has_masters_ ? status() : LettersScene::open();
  }

  void set_frame(uint32_t frame) noexcept {
    if (has_masters_) {
      next(frame, line_.at(kStartMs + time_of(frame % kFrames)));
    } else {
      LettersScene::set_frame(frame);
    }
  }

  void draw(const Paper& paper) noexcept {
    if (has_masters_) {
      paper.fill(paper_rgb());
      line_.draw(painter(paper, ink_rgb()));
    } else {
      LettersScene::draw(paper);
    }
  }

 private:
  motion::WeightPulse line_;
  bool has_masters_ = false;
};

}  // namespace inkcell::scenes
