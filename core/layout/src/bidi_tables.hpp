// Tables for mixed text that host_tools/unicode/make_tables.py generates.
#pragma once

#include <stdint.h>

#include "class_table.hpp"

namespace inkcell::detail {

// Values of BidiClass.
extern const ClassTable kBidiClasses;

// Characters that have mirror images. Of a block of `count` pairs with
// distance 1 each is followed by its image; with others the first `count` code
// points stand `distance` before theirs.
struct MirrorBlock {
  uint16_t first;
  uint16_t code;  // distance << 4 | (count - 1) << 2 | kind

  enum Kind : uint32_t { no_brackets, first_opens, second_opens };

  constexpr uint32_t distance() const noexcept { return code >> 4; }
  constexpr uint32_t count() const noexcept { return (code >> 2 & 3) + 1; }
  constexpr uint32_t kind() const noexcept { return code & 3; }
};

// In no order.
extern const MirrorBlock kMirrorBlocks[];
extern const uint32_t kMirrorBlockCount;

}  // namespace inkcell::detail
