// What the programs are given, and what they print.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "board.hpp"
#include "semihosting.hpp"

namespace bench {

// Decimal digits up to the first other character.
inline uint32_t parse(const char* digits) {
  uint32_t value = 0;
  while (*digits >= '0' && *digits <= '9') {
    value = value * 10 + static_cast<uint32_t>(*digits++ - '0');
  }
  return value;
}

// Reads a file of at most `room` bytes. Its size, or 0 if there is none.
inline size_t read_file(const char* name, uint8_t* bytes, size_t room) {
  using namespace inkcell;
  const intptr_t file = semihosting::open(name, semihosting::Mode::read);
  const intptr_t length = file < 0 ? -1 : semihosting::length(file);
  const auto size = static_cast<size_t>(length);
  const bool is_read =
      length >= 0 && size <= room && semihosting::read(file, bytes, size);
  return is_read ? size : 0;
}

// Prints a row: a word, and numbers.
template <typename... Numbers>
void print_row(const char* word, Numbers... numbers) {
  using namespace inkcell;
  board::print(word);
  const auto print_number = [](uint32_t number) {
    board::print(" ");
    board::print_decimal(number);
  };
  (print_number(static_cast<uint32_t>(numbers)), ...);
  board::print("\n");
}

// Values of several glyphs or frames.
struct Total {
  uint32_t sum = 0;
  uint32_t most = 0;
  uint32_t count = 0;

  void add(uint32_t value) {
    sum += value;
    most = value > most ? value : most;
    ++count;
  }
  uint32_t mean() const { return count == 0 ? 0 : (sum + count / 2) / count; }
};

// Says why a program ends, and is its exit code.
inline int fail(const char* why) {
  inkcell::board::print(why);
  inkcell::board::print("\n");
  return 1;
}

}  // namespace bench
