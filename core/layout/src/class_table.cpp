#include "class_table.hpp"

namespace inkcell::detail {

uint8_t class_of(const ClassTable& table, uint32_t code_point) noexcept {
  if (code_point >= table.end) {
    return table.other;
  }
  constexpr uint32_t kOffsetBits = 11;
  constexpr uint32_t kOffsetMask = (1u << kOffsetBits) - 1;
  // Invariant: the block of the code point is at `low` or between it and
  // `high`.
  const uint32_t key = code_point << kOffsetBits | kOffsetMask;
  uint32_t low = 0;
  uint32_t high = table.block_count;
  while (high - low > 1) {
    const uint32_t middle = (low + high) / 2;
    (table.blocks[middle] <= key ? low : high) = middle;
  }
  const uint32_t block = table.blocks[low];
  const uint8_t* run = table.runs + (block & kOffsetMask);
  // Code points of the block before the wanted one, counted down run by run.
  uint32_t rest = code_point - (block >> kOffsetBits);
  for (;;) {
    const uint32_t code = *run++;
    const uint32_t index = code >> 5;
    const uint8_t found = index == 7 ? *run++ : table.common[index];
    uint32_t length = (code & 31) + 1;
    if (length == 30) {
      length = *run++ + 30u;
    } else if (length == 31) {
      length = (run[0] | uint32_t{run[1]} << 8) + 286;
      run += 2;
    }
    if (rest < length) {
      return found;
    }
    rest -= length;
  }
}

}  // namespace inkcell::detail
