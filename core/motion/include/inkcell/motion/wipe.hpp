// Text that a soft edge reveals or hides (recipes.hpp).
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// A line that a soft edge reveals, or hides, from left to right.
class Wipe {
 public:
  enum class Kind : uint8_t { reveal, hide };

  Wipe(const Font& font,
       const Style& style,
       Point origin,
       Text text,
       const Timing& timing,
       Kind kind = Kind::reveal) noexcept
      : face_{&font, &style},
        origin_(origin),
        text_(text),
        timing_(timing),
        kind_(kind) {}

  /// The edge moves from x0 to x1, and fades over `soft`, instead of over the
  /// text and half an em: two wipes share an edge. Before the first at().
  /// [px; x0 and x1 are clamped to +-16384]
  void set_edge(int32_t x0, int32_t x1, uint8_t soft) noexcept;

  /// The painter is like the one that draws: as in ValueLabel::set().
  Rect at(int32_t now_ms, const Painter& painter) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept {
    return motion::next_due(timing_, now_ms);
  }

 private:
  Face face_;
  Point origin_;
  Text text_;
  Timing timing_;
  Kind kind_;
  uint8_t soft_ = 0;  // [px]
  int16_t x0_ = 0;    // where the edge begins and ends; equal: with the text
  int16_t x1_ = 0;
  int16_t edge_ = INT16_MIN;  // before the first at()
  Rect box_;
};

}  // namespace inkcell::motion
