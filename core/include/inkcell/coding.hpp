// The codings of fonts: what the glyphs of a font are made of.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

namespace detail {
struct Source;
}

/// A coding that this program can draw. Font::open names it, and with it the
/// linker keeps what draws such glyphs.
struct Coding {
  uint8_t number;  // format::Coding
  const detail::Source* source;
};

/// Outlines, the coding of Font::open without a name. Where
/// INKCELL_ONLY_STRIKES is defined, neither this coding nor that of fields is
/// there, and the linker names who asks for it.
extern const Coding kOutlineCoding;

}  // namespace inkcell
