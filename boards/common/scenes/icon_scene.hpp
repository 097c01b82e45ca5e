// Scene `icons`: pairs of icons become each other, and back.
#pragma once

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/timeline.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class IconScene : public TextScene {
 public:
  // Play and pause, a battery that fills, sun and cloud: icons/*.svg.
  static constexpr const char* kText = "\uE001\uE002\uE004\uE005\uE006\uE007";
  static constexpr const char* kMorphs =
      "\uE001\uE002 \uE004\uE005 \uE006\uE007";

  explicit IconScene(const SceneSetting& setting) noexcept
      : TextScene(setting, setting.text, 420, 128) {}

  /// bad_argument: not one to four pairs. no_glyph: the font has no morphs of
  /// them.
  Status open() noexcept {
    count_ = 0;
    Text rest = text();
    while (rest.size != 0) {
      const uint16_t first = font().glyph_or_notdef(next_code_point(rest));
      if (rest.size == 0 || count_ == 4) {
        return Status::bad_argument;
      }
      INKCELL_TRY(motion::OutlineMorph::open(
          font(), first, font().glyph_or_notdef(next_code_point(rest)),
          pairs_[count_++]));
    }
    if (count_ == 0) {
      return Status::bad_argument;
    }
    // As much room before the first icon as after the last one.
    shift_ = 0;
    GlyphMetrics first;
    GlyphMetrics last;
    INKCELL_TRY(font().glyph_metrics(pairs_[0].from(), first));
    INKCELL_TRY(font().glyph_metrics(pairs_[count_ - 1].from(), last));
    shift_ = (screen().x1 - left_of(0) - units(first.x_min) -
              left_of(count_ - 1) - units(last.x_max)) /
             2;
    return status();
  }

  void set_frame(uint32_t frame) noexcept {
    const uint32_t last = this->frame();
    Rect changed;
    for (int32_t i = 0; i < count_; ++i) {
      if (progress(i, last).raw != progress(i, frame).raw) {
        changed = bounding_box(changed, cell(i));
      }
    }
    next(frame, changed);
  }

  void draw(const Paper& paper) const noexcept {
    paper.fill(0x101820);
    constexpr uint32_t kInks[] = {0x6bd3ff, 0x8ce06b, 0xffd25c, 0xff8a7a};
    for (int32_t i = 0; i < count_; ++i) {
      pairs_[i].draw(painter(paper, kInks[i]), style(),
                     {Q26_6::from_int(left_of(i)), origin().y},
                     progress(i, frame()));
    }
  }

 private:
  Rect cell(int32_t i) const noexcept {
    const int32_t w = screen().x1;
    return {w * i / count_ + shift_, 0, w * (i + 1) / count_ + shift_,
            screen().y1};
  }
  int32_t units(int32_t of_font) const noexcept {  // [px]
    return px(of_font * 256 / font().units_per_em());
  }
  // Where a glyph begins that is centred by its advance. [px]
  int32_t left_of(int32_t i) const noexcept {
    return (cell(i).x0 + cell(i).x1 - units(font().advance(pairs_[i].from()))) /
           2;
  }
  // There, and back after half of the time.
  static Q16_16 progress(int32_t i, uint32_t frame) noexcept {
    using namespace motion;
    const int32_t now = time_of((frame + uint32_t(148 - 12 * i)) % 150);
    return Q16_16::from_raw(ease(kEaseInOut, fraction(0, 600, now)).raw -
                            ease(kEaseInOut, fraction(2500, 3100, now)).raw);
  }

  motion::OutlineMorph pairs_[4];
  int32_t count_ = 0;
  int32_t shift_ = 0;  // of the row [px]
};

}  // namespace inkcell::scenes
