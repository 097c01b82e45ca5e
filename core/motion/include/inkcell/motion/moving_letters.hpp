// Letters that move one after the other (recipes.hpp).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/span.hpp"

namespace inkcell::motion {

/// Three keys: from rest to a pose and back. For LetterMotion.
struct PoseThere {
  PoseKey keys[3];
};

/// The keys of a letter that hops. For LetterMotion.
struct Hop {
  PoseKey keys[8];
};

/// A letter hops: it crouches, flies up and down, lands, and springs back, all
/// in `duration_ms`. For letters that stand on their pivots: with
/// RunPlace::pivot_height 0.
constexpr Hop hop(Q26_6 height, int32_t duration_ms) noexcept {
  struct Moment {
    int16_t at;  // [1/1000 of the duration]
    int16_t scale_x_q12;
    int16_t scale_y_q12;
    Easing easing;
  };
  // Crouched, off the ground, at the top, on the ground, squashed, up again.
  constexpr Moment kMoments[8] = {
      {0, 4096, 4096, kEaseInOut},
      {110, 4260, 3560, kEaseOut},
      {190, 3930, 4350, cubic_bezier(0, 0, 550, 1000)},
      {440, 4096, 4096, cubic_bezier(450, 0, 1000, 1000)},
      {690, 3930, 4350, kEaseOut},
      {770, 4340, 3400, kEaseInOut},
      {880, 4010, 4230, kEaseInOut},
      {1000, 4096, 4096, kLinear}};
  Hop result;
  for (int32_t i = 0; i < 8; ++i) {
    PoseKey& key = result.keys[i];
    key.at_ms =
        static_cast<int32_t>(int64_t{duration_ms} * kMoments[i].at / 1000);
    key.pose.scale_x = Scale::from_raw(kMoments[i].scale_x_q12);
    key.pose.scale_y = Scale::from_raw(kMoments[i].scale_y_q12);
    key.easing = kMoments[i].easing;
  }
  result.keys[3].pose.offset.y = Q26_6::from_raw(-height.raw);
  return result;
}

/// A letter grows bold and light again: edges move outwards by `weight`, at
/// most 4 px.
constexpr PoseThere swell(Q26_6 weight, int32_t duration_ms) noexcept {
  PoseThere there;
  there.keys[0].easing = kEaseInOut;
  there.keys[1].at_ms = duration_ms / 2;
  constexpr int32_t kMost = 4 * 64;
  const int32_t least = weight.raw < kMost ? weight.raw : kMost;
  there.keys[1].pose.weight = Q6_10::from_raw(
      static_cast<int16_t>((least < -kMost ? -kMost : least) * 16));
  there.keys[1].easing = kEaseInOut;
  there.keys[2].at_ms = duration_ms;
  return there;
}

/// One motion for each letter of a run, each a little later than another.
struct LetterMotion {
  Span<const PoseKey> keys;  // such as swell().keys
  Timing timing;             // repeats 0: for ever
  Stagger stagger;
};

/// Letters that move, by a renderer. All arguments must outlive it.
class MovingLetters {
 public:
  MovingLetters(PoseRenderer& renderer,
                const Font& font,
                const Run& run,
                const RunPlace& where,
                const LetterMotion& motion) noexcept
      : renderer_(renderer),
        font_(font),
        run_(run),
        where_(where),
        motion_(motion) {}

  Rect at(int32_t now_ms) noexcept;
  void draw(const Painter& painter) noexcept;

 private:
  PosedGlyph posed(size_t index, int32_t now_ms) const noexcept;

  PoseRenderer& renderer_;
  const Font& font_;
  const Run& run_;
  const RunPlace& where_;
  const LetterMotion& motion_;
  int32_t now_ms_ = 0;
  bool is_drawn_ = false;
};

}  // namespace inkcell::motion
