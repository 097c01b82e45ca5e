// RAM that a caller lends to a call.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {

/// RAM lent by the caller for drawing one glyph at a time. `data` is a multiple
/// of 4. Its content has no meaning between calls. Tasks that draw at the same
/// time need one each.
struct Workspace : Span<uint8_t> {
  using Span::Span;
  constexpr Workspace(Span bytes) noexcept : Span(bytes) {}
};

}  // namespace inkcell
