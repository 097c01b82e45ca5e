// What scenes of one line share: the line fits the screen, and frames change a
// rectangle.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "paint_text.hpp"
#include "paper.hpp"

namespace inkcell::scenes {

/// The base of scenes that are functions of their frame's number.
class TextScene {
 public:
  static constexpr SceneNeeds needs(int32_t, int32_t) noexcept { return {}; }
  TextScene(const TextScene&) = delete;
  TextScene& operator=(const TextScene&) = delete;

  void add_changes(DirtyRects& dirty) const noexcept {
    dirty.add(changed_, screen());
  }
  uint32_t next_due() const noexcept { return frame_ + 1; }
  void tell_state(const StateSink& sink) const noexcept {
    sink.tell(static_cast<int32_t>(frame_ % kLoopFrames));
  }

 protected:
  /// The ink of `widest` takes at most these parts of the screen, in 1/256, and
  /// stands in its middle.
  TextScene(const SceneSetting& setting,
            Text widest,
            int32_t width_part_q8,
            int32_t height_part_q8) noexcept;

  /// ok if `widest` has ink.
  Status status() const noexcept {
    return has_ink_ ? Status::ok : Status::bad_argument;
  }
  void next(uint32_t frame, const Rect& changed) noexcept {
    frame_ = frame;
    changed_ = changed;
  }

  const Font& font() const noexcept { return *setting_.font; }
  Text text() const noexcept { return setting_.text; }
  /// Word 0 is the first one, word 1 the rest of the text.
  Text word(size_t index) const noexcept {
    return word_of(setting_.text, index);
  }
  /// The one of both words that takes more room.
  static Text wider_word(const Font& font, Text text) noexcept;
  Rect screen() const noexcept {
    return {0, 0, setting_.width, setting_.height};
  }
  const Style& style() const noexcept { return style_; }
  Point origin() const noexcept { return place_.origin; }
  /// Where a line begins whose ink stands in the middle of the screen.
  Point centred(Text line) const noexcept;
  /// Parts of the size. [px]
  int32_t px(int32_t part_q8) const noexcept {
    return style_.size().raw * part_q8 >> 14;
  }
  /// Whether the text is a number of 1 to `most` and `unit`.
  bool read_number(int32_t most, Text unit, int32_t& number) const noexcept;
  uint32_t frame() const noexcept { return frame_; }
  /// The frame in a scene that repeats after `count` frames, from `first` on.
  int32_t frame_ms(uint32_t first, uint32_t count) const noexcept {
    return time_of((frame_ + first) % count);
  }
  Workspace workspace() const noexcept { return setting_.workspace; }
  /// Draws in one ink until the next call.
  Painter painter(const Paper& paper, uint32_t rgb) const noexcept {
    return {paper.with(rgb), setting_.workspace};
  }

 private:
  SceneSetting setting_;
  TextPlace place_;
  bool has_ink_;
  Style style_;
  Rect changed_;
  uint32_t frame_ = 0;
};

}  // namespace inkcell::scenes
