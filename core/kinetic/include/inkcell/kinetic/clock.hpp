// A clock whose digits morph or roll (recipes.hpp).
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/kinetic/digit_roll.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell {
namespace kinetic {

/// A clock of four digits. Where the font holds the pair (inkcell-fontgen
/// --morph) a digit becomes the next one by its outline, if the painter's
/// workspace has OutlineMorph::workspace_bytes(); others roll.
class Clock {
 public:
  static constexpr int32_t kDigits = 4;
  static constexpr int32_t kEndMs = 620;  // of a change

  /// `origin` is the left end of the baseline.
  Clock(const Font& font, const Style& style, Point origin) noexcept;

  /// The change from one minute of the day to another, all digits together,
  /// `since_ms` after it began; beyond kEndMs it rests.
  Rect at(uint32_t from_minute, uint32_t to_minute, int32_t since_ms) noexcept;
  void draw(const Painter& painter) const noexcept;

  /// The same piece by piece, in styles of the clock's size.
  void draw_digit(const Painter& painter,
                  const Style& style,
                  int32_t digit) const noexcept;
  void draw_colon(const Painter& painter) const noexcept;
  /// How far a digit is on its way, 0 to 1; 1 if it rests.
  Q16_16 progress(int32_t digit) const noexcept;

  /// The pixels of all digits.
  Rect box() const noexcept;

 private:
  Rect cell(int32_t digit) const noexcept;
  Q26_6 left_of(int32_t digit) const noexcept;
  uint16_t glyph_of(uint16_t minute, int32_t digit) const noexcept;

  Face face_;
  Point origin_;
  DigitCells cells_;
  Q26_6 colon_;  // width [px]
  uint16_t from_ = 0xffff;
  uint16_t to_ = 0xffff;
  int32_t since_ms_ = 0;
};

}  // namespace kinetic
}  // namespace inkcell
