// Scene `melt`: a word melts into a puddle, which levels; another word freezes
// out of it from below.
#pragma once

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/simulation/melt.hpp"
#include "inkcell/simulation/redistance.hpp"
#include "text_scene.hpp"

namespace inkcell::scenes {

/// A simulation: set_frame() steps as often as needed, from the start if it
/// goes back.
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
    how_.beside = Q26_6::from_raw(2 * screen().x1);  // 1/32 of the width
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
    const int32_t frozen = motion::fraction(kFreezes, kRests, now).raw;
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
  static constexpr int32_t kMelts = 4;
  static constexpr int32_t kLevels = 46;
  static constexpr int32_t kFreezes = 58;
  static constexpr int32_t kRests = 106;

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
    }
    if (now < kLevels) {
      const int32_t since = now - kMelts;
      how_.speed_q8 = since < 20 ? since * 7 : 140;
      simulation::melt(grids_[0], how_, scratch_);
    } else if (now < kFreezes) {
      if (now == kLevels) {
        grids_[2].clear();
        freeze_to(grids_[2], Q16_16());
      }
      simulation::freeze(grids_[0], grids_[2], 18);
    } else {
      if (now == kFreezes) {
        static_cast<void>(paint(1 - index(), grids_[2]));  // open() has tried
      }
      freeze_to(grids_[0],
                motion::ease(motion::kEaseInOut,
                             motion::fraction(kFreezes - 1, kRests, now)));
      return;
    }
    simulation::redistance(grids_[0], grids_[1]);
    const Grid swap = grids_[0];
    grids_[0] = grids_[1];
    grids_[1] = swap;
  }

  // The greater of two, or the smaller of their negatives, rounded where they
  // are nearer than `wide`.
  static int32_t round_max(int32_t a, int32_t b, int32_t wide) noexcept {
    const int32_t apart = a > b ? a - b : b - a;
    const int32_t more =
        apart >= wide ? 0 : (wide - apart) * (wide - apart) / (4 * wide);
    return (a > b ? a : b) + more;
  }
  static int32_t round_min(int32_t a, int32_t b, int32_t wide) noexcept {
    return -round_max(-a, -b, wide);
  }

  // The word of the last grid up to a level that rises, and the puddle that it
  // rises from. [1/32 of a sample]
  void freeze_to(Grid& out, Q16_16 part) const noexcept {
    constexpr int32_t kRound = 96;
    const Grid& word = grids_[2];
    const int32_t width = out.width();
    // The puddle is as wide as what melts may be.
    const int32_t half =
        width * 16 - (how_.beside.raw >> (out.scale_log2() + 1));
    const int32_t deep = how_.area * 8 / (half < 1 ? 1 : half);
    const int32_t depth = motion::lerp(deep, -kRound, part);
    const int32_t shift = out.scale_log2() + 1;
    const auto height_of = [&](int32_t y) {
      return (how_.floor.raw - ((2 * y + 1) << (shift + 4))) >> shift;
    };
    const int32_t level = motion::lerp(
        deep - kRound, height_of(word.known_box().y0) + kRound, part);
    for (int32_t y = 0; y < out.height(); ++y) {
      const int32_t height = height_of(y);
      int8_t* const row = out.row(y);
      for (int32_t x = 0; x < width; ++x) {
        const int32_t across = (2 * x + 1 - width) * 16;
        const int32_t beside = half - (across < 0 ? -across : across);
        const int32_t puddle = round_min(depth - height, beside, kRound);
        const int32_t risen = round_min(word.row(y)[x], level - height, kRound);
        int32_t both = round_max(puddle, risen, motion::lerp(kRound, 1, part));
        both = both < height ? both : height;
        row[x] = static_cast<int8_t>(both < INT8_MIN   ? INT8_MIN
                                     : both > INT8_MAX ? INT8_MAX
                                                       : both);
      }
    }
  }

  Grid grids_[3];  // the shape; scratch; the puddle at rest or the next word
  motion::GridHistogram scratch_;
  simulation::Melting how_;
  uint32_t step_ = 0;
};

}  // namespace inkcell::scenes
