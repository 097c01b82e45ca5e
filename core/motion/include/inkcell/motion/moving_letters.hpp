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

/// A letter hops: up and down in `duration_ms`.
constexpr PoseThere hop(Q26_6 height, int32_t duration_ms) noexcept {
  PoseThere there;
  there.keys[0].easing = cubic_bezier(0, 0, 550, 1000);
  there.keys[1].at_ms = duration_ms / 2;
  there.keys[1].pose.offset.y = Q26_6::from_raw(-height.raw);
  there.keys[1].easing = cubic_bezier(450, 0, 1000, 1000);
  there.keys[2].at_ms = duration_ms;
  return there;
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
  Span<const PoseKey> keys;  // such as hop().keys
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
