// Classes of code points for the order of mixed text: UAX #9, table 4.
#pragma once

#include <stdint.h>

#include "bidi_tables.hpp"

namespace inkcell::detail {

enum class BidiClass : uint8_t {
  l,    // left to right
  r,    // right to left
  al,   // right to left, Arabic
  en,   // European number
  an,   // Arabic number
  es,   // European separator
  et,   // European terminator
  cs,   // common separator
  nsm,  // mark
  bn,   // boundary neutral
  b,    // paragraph separator
  s,    // segment separator
  ws,   // white space
  on,   // other neutral
  lre,  // embeddings and overrides
  rle,
  lro,
  rlo,
  pdf,
  lri,  // isolates
  rli,
  fsi,
  pdi,
};

inline BidiClass bidi_class(uint32_t code_point) noexcept {
  return static_cast<BidiClass>(class_of(kBidiClasses, code_point));
}

// The mirror image of a code point.
struct Mirror {
  enum Kind : uint8_t { none, plain, opens, closes };  // brackets open or close

  uint32_t image = 0;
  Kind kind = none;
};

Mirror mirror_of(uint32_t code_point) noexcept;

}  // namespace inkcell::detail
