// Letters that grow bold and light again (recipes.hpp).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// When letters pulse: each a little later than another.
struct PulseMotion {
  int32_t swell_ms = 800;  // of a letter, to its second master and back
  Timing timing;           // repeats 0: for ever
  Stagger stagger;
};

/// A line whose letters morph to their second masters and back: bolder by the
/// font's own design (inkcell-fontgen --axis wght=300..800). Advances grow with
/// them, so letters behind move on. Letters without a second master stay as
/// they are; so do all if the painter's workspace has less than
/// OutlineMorph::workspace_bytes() of the font. For styles without grid
/// fitting, such as those with kFilterMotion.
class WeightPulse {
 public:
  WeightPulse(const Font& font,
              const Style& style,
              Point origin,
              Text text,
              const PulseMotion& motion) noexcept;

  Rect at(int32_t now_ms) noexcept;
  void draw(const Painter& painter) const noexcept;

 private:
  Q16_16 progress(size_t letter, int32_t now_ms) const noexcept;
  Point place(const PositionedGlyph& glyph, int32_t grown_q6) const noexcept;

  Face face_;
  Point origin_;
  Text text_;
  PulseMotion motion_;
  size_t letters_ = 0;
  int32_t now_ms_ = 0;
  bool is_drawn_ = false;
};

}  // namespace inkcell::motion
