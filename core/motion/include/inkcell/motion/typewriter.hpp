// Text that is typed (recipes.hpp).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// Text that is typed letter by letter, with a caret that blinks at rest. It
/// stands from the start where it stands in the end: with a LineShaper of the
/// painter (inkcell/layout/line_shaper.hpp) letters have the forms of the whole
/// text, and come with their marks. At most kMaxLineBytes.
class Typewriter {
 public:
  Typewriter(const Font& font,
             const Style& style,
             Point origin,
             Text text,
             int32_t letter_ms = 90) noexcept
      : face_{&font, &style},
        origin_(origin),
        text_(text),
        letter_ms_(letter_ms < 1 ? 1 : letter_ms) {}

  /// No letter before 0 ms. To erase, go back in time. The painter is like the
  /// one that draws: as in ValueLabel::set().
  Rect at(int32_t now_ms, const Painter& painter) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept;

  /// The time of the last letter. [ms]
  int32_t end_ms() const noexcept;
  Rect caret() const noexcept;

 private:
  static constexpr int32_t kBlinkMs = 530;

  template <typename Take>
  void walk(const Painter& painter,
            const Style& style,
            const Take& take) const noexcept;
  template <typename Take>
  void for_each(const Painter& painter, const Take& take) const noexcept;
  int32_t caret_width() const noexcept;

  Face face_;
  Point origin_;
  Text text_;
  int32_t letter_ms_;
  size_t shown_ = 0;             // [bytes]
  int32_t caret_x_ = INT32_MIN;  // INT32_MIN: at() was not called
  bool is_caret_on_ = false;
};

}  // namespace inkcell::motion
