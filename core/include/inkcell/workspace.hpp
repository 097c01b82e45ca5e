// RAM that a caller lends to a call.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {

/// RAM lent by the caller for drawing one glyph at a time. `data` is a multiple
/// of 4. Its content has no meaning between calls. Tasks that draw at the same
/// time need one each.
struct Workspace {
  uint8_t* data = nullptr;
  size_t size = 0;  // [bytes]

  constexpr Workspace() noexcept = default;
  constexpr Workspace(uint8_t* first, size_t bytes) noexcept
      : data(first), size(bytes) {}
  constexpr Workspace(Span<uint8_t> bytes) noexcept
      : data(bytes.data), size(bytes.size) {}
};

}  // namespace inkcell
