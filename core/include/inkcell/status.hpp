// The one error type, and the two macros that go with it.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

/// Why a call did nothing. Values never change: they end up in field logs.
// clang-format off
enum class [[nodiscard]] Status : uint8_t {
  ok            = 0,
  bad_magic     = 1,   // not an Inkcell font
  bad_version   = 2,   // a format that this library does not read: regenerate
  corrupt       = 3,   // an offset, a length or a checksum does not fit
  no_glyph      = 4,   // code point or glyph id absent; .notdef is glyph 0
  buffer_small  = 5,   // shorter than the minimum that the call states
  misaligned    = 6,   // a font, or pixels kept as words: not a multiple of 4
  unsupported   = 7,   // a section that the font lacks, a coding not named
  bad_argument  = 8,   // outside the range that the call states
  beyond_band   = 9,   // farther than the font's distances reach: --band-px
  read_failed   = 10,  // the storage of a font did not give its bytes
  cut           = 11,  // a text was longer than what takes it
  needs_shaping = 12,  // letters that are to be joined were not: LAYOUT.md
};
// clang-format on

}  // namespace inkcell

/// Returns from the calling function unless `expression` is Status::ok.
#define INKCELL_TRY(expression)                         \
  do {                                                  \
    const ::inkcell::Status inkcell_try = (expression); \
    if (inkcell_try != ::inkcell::Status::ok) {         \
      return inkcell_try;                               \
    }                                                   \
  } while (false)
