// Small animations of text that products need, ready-made.
//
//   Counter counter(font, style, {8, 60}, 4);
//   counter.roll(0, 1250, timing);
//   for (;;) {
//     const Rect changed = counter.at(now_ms());
//     INKCELL_TRY(port::run_strips(loop, changed));  // counter.draw(painter)
//   }
//
// All are functions of time: at() takes any time, in any order, and returns the
// pixels that differ from those of the last call, all of them at first, none if
// nothing changed. draw() draws into any strip, over the caller's background,
// and changes nothing. Fonts, styles and texts must outlive a recipe; styles
// must be upright. No heap, no grids; what a program does not use is not
// linked.
//
// Text that scrolls by, a ticker, is ScrollingLabel (inkcell/layout/label.hpp)
// in a SoftWindow (fade.hpp).
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/kinetic/easing.hpp"
#include "inkcell/kinetic/pose_renderer.hpp"
#include "inkcell/kinetic/run.hpp"
#include "inkcell/kinetic/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell {
namespace kinetic {

/// Cells of digits, one beside the other. Made by measure_digits().
struct DigitCells {
  Q26_6 width;         // of the widest digit's advance [px]
  int32_t top = 0;     // of a cell, from the baseline [px, y down]
  int32_t bottom = 0;  // exclusive; digits roll by bottom - top
};
DigitCells measure_digits(const Font& font, const Style& style) noexcept;

/// A number whose wheels roll, as those of an odometer do: a wheel turns while
/// the one to its right goes from 9 to 0. Leading zeros are blank.
class Counter {
 public:
  /// `digits` wheels, 1 to 9; `origin` is the left end of their baseline.
  Counter(const Font& font,
          const Style& style,
          Point origin,
          int32_t digits) noexcept;

  /// Counts from one number to another, up or down, by timing and easing.
  void roll(uint32_t from,
            uint32_t to,
            const Timing& timing,
            const Easing& easing = kEaseOut) noexcept;

  Rect at(int32_t now_ms) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept {
    return kinetic::next_due(timing_, now_ms);
  }

  uint32_t value() const noexcept {
    return static_cast<uint32_t>(value_q16_ >> 16);
  }
  /// The pixels of all wheels.
  Rect box() const noexcept { return box_of(digits_); }

 private:
  struct Wheel;

  Wheel wheel(int64_t value_q16, int32_t place) const noexcept;
  Rect box_of(int32_t wheels) const noexcept;

  Face face_;
  Point origin_;
  DigitCells cells_;
  int32_t digits_;
  uint32_t from_ = 0;
  uint32_t to_ = 0;
  Timing timing_;
  Easing easing_;
  int64_t value_q16_ = -1;  // -1: at() was not called
};

/// A clock of four digits. Where the font holds the pair (inkcell-fontgen
/// --morph) a digit becomes the next one by its outline, if the painter's
/// workspace has OutlineMorph::workspace_bytes(); others roll.
class Clock {
 public:
  static constexpr int32_t kDigits = 4;
  static constexpr int32_t kStepMs = 110;    // from digit to digit
  static constexpr int32_t kChangeMs = 620;  // of a digit
  static constexpr int32_t kEndMs = kChangeMs + (kDigits - 1) * kStepMs;

  /// `origin` is the left end of the baseline.
  Clock(const Font& font, const Style& style, Point origin) noexcept;

  /// The change from one minute of the day to another, the last digit first,
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

/// Text that is typed letter by letter, with a caret that blinks at rest. For
/// canvases of 1 and 2 bits give at() the painter that draws.
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

  /// No letter before 0 ms. To erase, go back in time.
  Rect at(int32_t now_ms, const Painter& painter = {}) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept;

  /// The time of the last letter. [ms]
  int32_t end_ms() const noexcept;
  Rect caret() const noexcept;

 private:
  static constexpr int32_t kBlinkMs = 530;

  Face face_;
  Point origin_;
  Text text_;
  int32_t letter_ms_;
  size_t shown_ = 0;             // [bytes]
  int32_t caret_x_ = INT32_MIN;  // INT32_MIN: at() was not called
  bool is_caret_on_ = false;
};

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

  Rect at(int32_t now_ms, const Painter& painter = {}) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept {
    return kinetic::next_due(timing_, now_ms);
  }

 private:
  Face face_;
  Point origin_;
  Text text_;
  Timing timing_;
  Kind kind_;
  uint8_t soft_ = 0;  // [px]
  int32_t edge_ = INT32_MIN;
  Rect box_;
};

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
  void draw(const Sink& sink) noexcept;

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

}  // namespace kinetic
}  // namespace inkcell
