// Scene `typewriter`: a line stands, is erased, and is typed again.
#pragma once

#include "inkcell/motion/recipes.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A frame depends only on its number.
class TypewriterScene : public TextScene {
 public:
  static constexpr const char* kText = "Hello, world.";

  explicit TypewriterScene(const SceneSetting& setting) noexcept
      : TextScene(setting, setting.text, 220, 90),
        line_(font(),
              style(),
              origin(),
              text(),
              text().size == 0
                  ? 1
                  : kTypingMs / static_cast<int32_t>(text().size)) {}

  /// bad_argument: the text has no ink, or would be too small to read.
  Status open() noexcept {
    const int32_t height = screen().y1;
    const int32_t least = height < 4 * kLeastPx ? height / 4 : kLeastPx;
    return style().size().raw < least * 64 ? Status::bad_argument : status();
  }

  void set_frame(uint32_t frame) noexcept {
    const int32_t now = time_of(frame % (kLoopFrames / 2));
    const int32_t end = line_.end_ms();
    // At rest; back in time; at the first letter; typed, and at rest again.
    const int32_t time = now < kRestMs ? kLoopMs - kTypedMs + now
                         : now < kErasedMs
                             ? end * (kErasedMs - now) / (kErasedMs - kRestMs)
                         : now < kTypedMs ? 0
                                          : now - kTypedMs;
    next(frame, line_.at(time, {}));
  }

  void draw(const Paper& paper) const noexcept {
    paper.fill(0xf4f1e8);
    line_.draw(painter(paper, 0x202428));
  }

 private:
  static constexpr int32_t kLeastPx = 8;  // to the em, on tall screens
  static constexpr int32_t kLoopMs = 5000;
  static constexpr int32_t kRestMs = 900;
  static constexpr int32_t kErasedMs = 1500;
  static constexpr int32_t kTypedMs = 1900;
  static constexpr int32_t kTypingMs = 1800;

  motion::Typewriter line_;
};

}  // namespace inkcell::scenes
