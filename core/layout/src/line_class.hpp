// Classes of code points for line breaking: UAX #14, section 5.
#pragma once

#include <stdint.h>

#include "inkcell/layout/line_break.hpp"
#include "line_tables.hpp"

namespace inkcell::detail {

// As rule LB1 leaves them: ambiguous, complex-context and unknown ones are
// alphabetic, or marks, and small kana are non-starters. The first 31 have rows
// in the table of pairs.
enum class LineClass : uint8_t {
  al,  // alphabetic
  ba,  // break after
  bb,  // break before
  b2,  // break before and after
  cb,  // contingent break
  cl,  // closing punctuation
  cp,  // closing parenthesis
  eb,  // emoji base, also code points kept for pictographs
  em,  // emoji modifier
  ex,  // exclamation
  gl,  // no-break
  h2,  // Hangul LV syllable
  h3,  // Hangul LVT syllable
  hl,  // Hebrew letter
  hy,  // hyphen-minus
  id,  // ideographic
  in,  // inseparable
  is,  // infix separator
  jl,  // Hangul L, T and V jamo
  jt,
  jv,
  ns,   // non-starter
  nu,   // digit
  op,   // opening punctuation
  opw,  // the same, wide in East Asia
  po,   // postfix
  pr,   // prefix
  qu,   // quotation
  ri,   // regional indicator
  sy,   // slash
  wj,   // word joiner
  sp,   // space
  zw,   // zero width space
  cm,   // combining mark
  zwj,  // zero width joiner
  bk,   // mandatory break
  cr,
  lf,
  nl,
  h,           // Hangul syllables, in the table only
  none = 255,  // start of the text
};

inline constexpr uint8_t kPairClasses = 31;

constexpr bool is_pair_class(LineClass c) noexcept {
  return static_cast<uint8_t>(c) < kPairClasses;
}

// bk, cr, lf, nl.
constexpr bool ends_line(LineClass c) noexcept {
  return c >= LineClass::bk && c <= LineClass::nl;
}

// cm, zwj.
constexpr bool is_mark(LineClass c) noexcept {
  return c == LineClass::cm || c == LineClass::zwj;
}

inline LineClass line_class(uint32_t code_point) noexcept {
  if (code_point < 128) {
    return static_cast<LineClass>(kAsciiLineClasses[code_point]);
  }
  const auto found = static_cast<LineClass>(class_of(kLineClasses, code_point));
  if (found != LineClass::h) {
    return found;
  }
  // Each syllable without a final consonant is followed by 27 that have one.
  constexpr uint32_t kFirst = 0xac00;
  return (code_point - kFirst) % 28 == 0 ? LineClass::h2 : LineClass::h3;
}

}  // namespace inkcell::detail
