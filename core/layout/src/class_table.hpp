// Properties of code points, packed as runs of code points of one class.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace inkcell::detail {

// A run is a byte of two fields, and up to three more.
//   bits 5..7  class: index into `common`; 7: the class is the next byte
//   bits 0..4  length - 1, below 29; 29: the next byte plus 30; 30: the next
//              two, low byte first, plus 286
// Runs follow each other without a gap from the first to the last code point
// that the table describes. `blocks` says where every 32nd run begins.
struct ClassTable {
  const uint8_t* runs;
  const uint32_t* blocks;  // first code point << 11 | offset in runs
  uint32_t block_count;
  uint32_t end;  // the first code point that it does not describe
  uint8_t common[7];
  uint8_t other;  // class of code points from `end` on
};

// `code_point` is at least the first one that the table describes.
uint8_t class_of(const ClassTable& table, uint32_t code_point) noexcept;

}  // namespace inkcell::detail
