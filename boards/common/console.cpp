// Prints strings and numbers by console_write().
#include "board.hpp"

namespace inkcell::board {

void print(const char* text) noexcept {
  size_t size = 0;
  while (text[size] != '\0') {
    ++size;
  }
  console_write(text, size);
}

void print_decimal(uint32_t value) noexcept {
  char digits[10];
  size_t first = sizeof digits;
  do {
    digits[--first] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  console_write(digits + first, sizeof digits - first);
}

void print_hex(uint32_t value) noexcept {
  char digits[10] = {'0', 'x'};
  for (size_t i = 0; i < 8; ++i) {
    const uint32_t digit = (value >> (28 - 4 * i)) & 15;
    digits[2 + i] =
        static_cast<char>(digit < 10 ? '0' + digit : 'a' + digit - 10);
  }
  console_write(digits, sizeof digits);
}

}  // namespace inkcell::board
