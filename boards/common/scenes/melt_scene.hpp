// Scene `melt`: a word melts into a puddle, out of which another one freezes.
#pragma once

#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/simulation/melt.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A simulation: set_frame() steps as often as needed, from the start if it
/// goes back. Letters grow from their feet; parts without feet, such as dots,
/// appear at last.
class MeltScene : public TextScene {
 public:
  static constexpr const char* kText = "COLD MELT";

  /// 2^scale pixels a sample along each side.
  static constexpr int32_t scale_for(int32_t width) noexcept {
    return width > 400 ? 3 : width > 200 ? 2 : width > 100 ? 1 : 0;
  }
  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    return {3 * samples_for(width, height, scale_for(width)), 0, 0};
  }

  explicit MeltScene(const SceneSetting& setting) noexcept
      : TextScene(setting, wider_word(*setting.font, setting.text), 230, 120) {
    Span<int8_t> memory = setting.memory.grid;
    for (Grid& grid : grids_) {
      grid = take_grid(memory, setting.width, setting.height,
                       scale_for(setting.width));
    }
  }

  /// bad_argument: the text is not two words with ink. buffer_small: the
  /// memory.
  Status open() noexcept {
    step_ = 0;
    const Text widest = wider_word(font(), text());
    how_.floor = origin().y;
    how_.floor.raw += Painter().measure(font(), style(), widest).bottom.raw;
    return grids_[2].width() == 0                       ? Status::buffer_small
           : paint(1, grids_[0]) && paint(0, grids_[0]) ? status()
                                                        : Status::bad_argument;
  }

  void set_frame(uint32_t to) noexcept {
    const Rect before = shown();
    if (to < step_) {
      static_cast<void>(open());  // it has been open
    }
    const bool rests = is_at_rest() && to == step_ + 1;
    while (step_ < to) {
      ++step_;
      step();
    }
    const Rect changed = bounding_box(before, shown());
    next(to, rests && is_at_rest() ? Rect() : changed);
  }

  void draw(const Paper& paper) const noexcept {
    const int32_t now = phase();
    const int32_t melted = motion::fraction(kMelts, kFreezes, now).raw;
    const int32_t frozen = motion::fraction(kFreezes, kSets, now).raw;
    const uint32_t ink = mix_rgb(0xe4f4ff, 0x3d9be0, (melted - frozen) >> 8);
    paper.fill(0x08121e);
    if (is_at_rest()) {
      const Text line = word(index());
      painter(paper, ink).text(font(), style(), place(line), line);
    } else {
      motion::draw_grid(grids_[0], {}, 0, 0, kFilterMotion, paper.with(ink));
    }
  }

 private:
  using Grid = motion::DistanceGrid;
  static constexpr int32_t kHalf = kLoopFrames / 2;
  static constexpr int32_t kMelts = 24;
  static constexpr int32_t kFreezes = 84;
  static constexpr int32_t kSets = 126;  // whatever is missing appears
  static constexpr int32_t kRests = 138;

  int32_t phase() const noexcept {
    return static_cast<int32_t>(step_ % static_cast<uint32_t>(kHalf));
  }
  // The index of the word that is shown, or melts.
  size_t index() const noexcept {
    const uint32_t whole = step_ / static_cast<uint32_t>(kHalf);
    return (whole + (phase() >= kRests ? 1 : 0)) % 2;
  }
  bool is_at_rest() const noexcept {
    return phase() < kMelts || phase() >= kRests;
  }
  Rect shown() const noexcept { return known_pixels(grids_[0]); }

  bool paint(size_t index, Grid& grid) noexcept {
    const Text line = word(index);
    return paint_text(font(), line, {style().size(), place(line)}, workspace(),
                      grid) &&
           grid.area() > 0;
  }

  // Where the ink of a word stands on the floor.
  Point place(Text line) const noexcept {
    const PixelMeasure ink = Painter().measure(font(), style(), line);
    return {centred(line).x, Q26_6::from_raw(how_.floor.raw - ink.bottom.raw)};
  }

  void step() noexcept {
    const int32_t now = phase();
    if (now < kMelts || now >= kRests) {
      return;
    }
    if (now == kMelts) {
      how_.area = grids_[0].area();
      static_cast<void>(paint(1 - index(), grids_[2]));  // open() has tried
    }
    if (now < kFreezes) {
      const int32_t since = now - kMelts;
      how_.speed_q8 = since < 20 ? since * 7 : 140;
      simulation::melt(grids_[0], how_, scratch_);
    } else {
      simulation::freeze(grids_[0], grids_[2], now < kSets ? 12 : 24);
    }
    if (now < kSets) {
      simulation::redistance(grids_[0], grids_[1]);
      const Grid swap = grids_[0];
      grids_[0] = grids_[1];
      grids_[1] = swap;
    }
  }

  Grid grids_[3];  // the shape; scratch; the next word
  motion::GridHistogram scratch_;
  simulation::Melting how_;
  uint32_t step_ = 0;
};

}  // namespace inkcell::scenes
