// A clock whose digits morph or roll (recipes.hpp).
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/digit_roll.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// What a clock counts, and shows last: HH:MM or HH:MM:SS.
enum class ClockUnit : uint8_t { minutes, seconds };

/// A clock of four or six digits. Where the font holds the pairs of all digits
/// that change (inkcell-fontgen --morph) each becomes the next one by its
/// outline, if the painter's workspace has OutlineMorph::workspace_bytes();
/// otherwise all of them roll.
class Clock {
 public:
  static constexpr int32_t kEndMs = 620;  // of a change

  /// `origin` is the left end of the baseline.
  Clock(const Font& font,
        const Style& style,
        Point origin,
        ClockUnit unit = ClockUnit::minutes) noexcept;

  /// The change from one minute or second of the day to another, all digits
  /// together, `since_ms` after it began; beyond kEndMs it rests.
  Rect at(uint32_t from, uint32_t to, int32_t since_ms) noexcept;
  void draw(const Painter& painter) const noexcept;

  /// The same piece by piece, in styles of the clock's size.
  int32_t digits() const noexcept {
    return unit_ == ClockUnit::seconds ? 6 : 4;
  }
  void draw_digit(const Painter& painter,
                  const Style& style,
                  int32_t digit) const noexcept;
  void draw_colons(const Painter& painter) const noexcept;
  /// How far a digit is on its way, 0 to 1; 1 if it rests.
  Q16_16 progress(int32_t digit) const noexcept;

  /// The pixels of all digits.
  Rect box() const noexcept;

 private:
  Rect cell(int32_t digit) const noexcept;
  Q26_6 left_of(int32_t digit) const noexcept;

  Face face_;
  Point origin_;
  DigitCells cells_;
  Q26_6 colon_;                 // width [px]
  uint32_t from_ = UINT32_MAX;  // seconds of the day; here at() was not called
  uint32_t to_ = UINT32_MAX;
  int32_t since_ms_ = 0;
  ClockUnit unit_;
  bool can_morph_ = false;  // all digits that change
};

}  // namespace inkcell::motion
