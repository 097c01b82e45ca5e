// Numbers that the programs are given and print.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "board.hpp"

namespace bench {

// Decimal digits up to the first other character.
inline uint32_t parse(const char* digits) {
  uint32_t value = 0;
  while (*digits >= '0' && *digits <= '9') {
    value = value * 10 + static_cast<uint32_t>(*digits++ - '0');
  }
  return value;
}

inline void print_number(size_t value) {
  inkcell::board::print(" ");
  inkcell::board::print_decimal(static_cast<uint32_t>(value));
}

}  // namespace bench
