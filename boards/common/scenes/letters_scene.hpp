// Scenes `bounce`, `pulse` and `splash`: letters move one after the other.
#pragma once

#include "inkcell/motion/recipes.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

enum class Letters { bounce, pulse, splash };

/// A frame depends only on its number.
template <Letters kLetters>
class LettersScene : public TextScene {
 public:
  static constexpr const char* kText = kLetters == Letters::bounce ? "bounce"
                                       : kLetters == Letters::pulse
                                           ? "heartbeat"
                                           : "Inkcell";

  explicit LettersScene(const SceneSetting& setting) noexcept
      : TextScene(
            setting, setting.text, kLetters == Letters::pulse ? 190 : 210, 90),
        renderer_(font(), style().size()),
        letters_(renderer_, font(), run_, where_, motion_) {}

  /// bad_argument: no ink. buffer_small: over 24 letters.
  Status open() noexcept {
    using namespace motion;
    const Q26_6 size = style().size();
    constexpr StaggerOrder kOrder = kLetters == Letters::splash
                                        ? StaggerOrder::from_centre
                                        : StaggerOrder::forward;
    if (kLetters == Letters::bounce) {
      take(hop(Q26_6::from_raw(size.raw / 2), 760).keys);
      where_.pivot_height = 0;
    } else if (kLetters == Letters::pulse) {
      take(swell(Q26_6::from_raw(size.raw / 52), 800).keys);
    } else {
      // Gone: small, low and clear.
      Pose gone;
      gone.opacity = 0;
      gone.offset.y = Q26_6::from_raw(size.raw / 3);
      gone.scale_x = gone.scale_y = Scale::from_raw(2600);
      const PoseKey keys[] = {{0, Pose(), kLeave},
                              {400, gone, {}},
                              {600, gone, kOvershoot},
                              {1200, Pose(), {}}};
      take(keys);
    }
    motion_.timing = {0, time_of(kFrames), 0};
    motion_.stagger = {kLetters == Letters::splash ? 45 : 90, kOrder, 0};
    where_.size = size;
    where_.origin = origin();
    INKCELL_TRY(lay_out(font(), text(), Anchor::left, glyphs_, run_));
    if (kLetters == Letters::pulse) {  // room for bold letters
      where_.tracking.raw = size.raw / 16;
      where_.origin.x.raw -= where_.tracking.raw *
                             (static_cast<int32_t>(run_.glyphs.size) - 1) / 2;
    }
    return status();
  }

  void set_frame(uint32_t frame) noexcept {
    next(frame, letters_.at(kStartMs + time_of(frame % kFrames)));
  }

  void draw(const Paper& paper) noexcept {
    paper.fill(paper_rgb());
    letters_.draw(painter(paper, ink_rgb()));
  }

 protected:
  static constexpr uint32_t paper_rgb() noexcept {
    constexpr uint32_t kPaper[] = {0x1c1030, 0x200c10, 0x08121c};
    return kPaper[static_cast<int>(kLetters)];
  }
  static constexpr uint32_t ink_rgb() noexcept {
    constexpr uint32_t kInk[] = {0xd0a8ff, 0xff6a5c, 0xe8f4ff};
    return kInk[static_cast<int>(kLetters)];
  }

  static constexpr uint32_t kFrames = kLoopFrames / 4;
  // All letters are in a later round: some at rest; of splash, on their way in.
  static constexpr int32_t kStartMs =
      kLetters == Letters::splash ? 4 * time_of(kFrames) + 900 : 5000;

 private:
  void take(Span<const motion::PoseKey> keys) noexcept {
    for (size_t i = 0; i < keys.size; ++i) {
      keys_[i] = keys.data[i];
    }
    motion_.keys = {keys_, keys.size};
  }

  motion::RunGlyph glyphs_[24];
  motion::Run run_;
  motion::RunPlace where_;
  motion::PoseKey keys_[8];
  motion::LetterMotion motion_;
  motion::PoseRenderer renderer_;
  motion::MovingLetters letters_;
};

}  // namespace inkcell::scenes
