// A firmware that tests its board: memory, arguments, counter, stack, faults.
#include <stddef.h>
#include <stdint.h>

#include "board.hpp"
#include "counter.hpp"
#include "semihosting.hpp"
#include "stack.hpp"

extern "C" {
void* memcpy(void* to, const void* from, size_t size);
void* memmove(void* to, const void* from, size_t size);
void* memset(void* to, int value, size_t size);
int memcmp(const void* left, const void* right, size_t size);
}

namespace board = inkcell::board;
namespace semihosting = inkcell::semihosting;

namespace {

int failures = 0;

void check(bool condition, const char* what) noexcept {
  if (!condition) {
    ++failures;
    board::print("failed: ");
    board::print(what);
    board::print("\n");
  }
}

bool equal(const char* left, const char* right) noexcept {
  while (*left == *right && *left != '\0') {
    ++left;
    ++right;
  }
  return *left == *right;
}

// Hides a value from the optimiser.
template <typename T>
T opaque(T value) noexcept {
  asm volatile("" : "+r"(value));
  return value;
}

uint32_t initialised[3] = {1, 2, 0xdeadbeef};
uint8_t zeroed[5];

struct Constructed {
  uint32_t value;
  Constructed() noexcept : value(opaque(0x1234u)) {}
};
const Constructed constructed;

void test_memory() noexcept {
  check(initialised[2] == 0xdeadbeef && initialised[0] == 1, ".data");
  check(zeroed[0] == 0 && zeroed[4] == 0, ".bss");
  check(constructed.value == 0x1234, "constructors");
  check(opaque(-7) / opaque(2) == -3 && opaque(-7) >> 1 == -4, "arithmetic");
  check(opaque(int64_t{1} << 40) / opaque(1000) == 1099511627, "64 bits");
}

// All starts and ends within a word, for each function.
void test_memory_functions() noexcept {
  uint8_t bytes[24];
  for (size_t start = 0; start < 4; ++start) {
    for (size_t size = 0; size < 12; ++size) {
      for (size_t i = 0; i < sizeof bytes; ++i) {
        bytes[i] = static_cast<uint8_t>(i);
      }
      memcpy(bytes + start, "abcdefghijklm", opaque(size));
      check(memcmp(bytes + start, "abcdefghijklm", size) == 0, "memcpy");
      check(bytes[start + size] == start + size, "memcpy's end");
      memmove(bytes + start + 1, bytes + start, opaque(size));
      check(memcmp(bytes + start + 1, "abcdefghijklm", size) == 0,
            "memmove up");
      memmove(bytes + start, bytes + start + 1, opaque(size));
      check(memcmp(bytes + start, "abcdefghijklm", size) == 0, "memmove down");
      memset(bytes + start, 0xee, opaque(size));
      check(size == 0 || bytes[start + size - 1] == 0xee, "memset");
      check(start == 0 || bytes[start - 1] == start - 1, "memset's start");
    }
  }
  check(memcmp("ab", "ac", 2) < 0 && memcmp("b", "a", 1) > 0, "memcmp");
}

void test_arguments(int count, char** arguments) noexcept {
  check(count == 4, "argc");
  check(equal(arguments[1], "all"), "argv[1]");
  check(equal(arguments[2], "one,two"), "argv[2]");
  check(equal(arguments[3], "--three=3"), "argv[3]");
  check(arguments[4] == nullptr, "argv's end");
}

void test_files() noexcept {
  const char* name = "board_selftest.tmp";
  const char text[] = "to be read back";
  intptr_t file = semihosting::open(name, semihosting::Mode::write);
  check(file >= 0 && semihosting::write(file, text, sizeof text), "write");
  semihosting::close(file);
  char back[sizeof text] = {};
  file = semihosting::open(name, semihosting::Mode::read);
  check(file >= 0 && semihosting::length(file) == sizeof text, "length");
  check(semihosting::read(file, back, sizeof back), "read");
  check(equal(back, text), "what was read");
  semihosting::close(file);
  check(semihosting::open("no/such/file", semihosting::Mode::read) == -1,
        "a missing file");
}

#if defined(INKCELL_COUNTER_PICOSECONDS)
// Two instructions, `count` times.
void two_instructions(uint32_t count) noexcept {
#  if defined(__riscv)
  asm volatile("1: addi %0, %0, -1\n bnez %0, 1b" : "+r"(count));
#  else
  asm volatile(".syntax unified\n1: subs %0, %0, #1\n bne 1b"
               : "+l"(count)
               :
               : "cc");
#  endif
}

void test_counter() noexcept {
  for (int pass = 0; pass < 3; ++pass) {
    const uint32_t some =
        board::count_instructions([] { two_instructions(1000); });
    const uint32_t more =
        board::count_instructions([] { two_instructions(11000); });
    board::print_decimal(some);
    board::print(" and ");
    board::print_decimal(more);
    board::print(" instructions counted\n");
    // Loading a constant takes one instruction, or two for a long one.
    check(some >= 2001 && some <= 2004, "the count of 1000 loops");
    check(more >= 22001 && more <= 22004, "the count of 11000 loops");
  }
}
#else
void test_counter() noexcept {}
#endif

[[gnu::noinline]] uint32_t recurse(uint32_t depth) noexcept {
  volatile uint32_t frame[16];
  frame[depth % 16] = depth;
  return depth == 0 ? 0 : recurse(depth - 1) + frame[depth % 16];
}

void test_stack() noexcept {
  const size_t one = board::count_stack([] { recurse(opaque(1u)); });
  const size_t ten = board::count_stack([] { recurse(opaque(10u)); });
  board::print_decimal(static_cast<uint32_t>(one));
  board::print(" and ");
  board::print_decimal(static_cast<uint32_t>(ten));
  board::print(" bytes of stack used\n");
  check(one >= 2 * 64 && one <= 2 * 64 + 80, "the stack of 2 calls");
  check((ten - one) % 9 == 0 && (ten - one) / 9 >= 64, "the stack of 11 calls");
}

void fail_on_purpose(const char* how) noexcept {
  if (equal(how, "undefined")) {
#if defined(__riscv)
    asm volatile(".word 0");
#elif defined(__thumb__)
    asm volatile("udf #0");
#else
    asm volatile(".word 0xe7f000f0");
#endif
  } else if (equal(how, "address")) {
    *reinterpret_cast<volatile uint32_t*>(opaque(uintptr_t{0x70000000})) = 1;
  } else if (equal(how, "unaligned")) {
    const uintptr_t odd = reinterpret_cast<uintptr_t>(initialised) + 1;
    opaque(*reinterpret_cast<volatile uint32_t*>(opaque(odd)));
  } else if (equal(how, "divide")) {
    opaque(opaque(1u) / opaque(0u));
  } else if (equal(how, "stack")) {
    opaque(recurse(1000000));
  }
}

int number_after(const char* text, const char* prefix) noexcept {
  while (*prefix != '\0') {
    if (*text++ != *prefix++) {
      return -1;
    }
  }
  int value = 0;
  while (*text >= '0' && *text <= '9') {
    value = value * 10 + (*text++ - '0');
  }
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    board::print("no arguments\n");
    return 1;
  }
  const int code = number_after(argv[1], "exit=");
  if (code >= 0) {
    return code;
  }
  fail_on_purpose(argv[1]);
  test_memory();
  test_memory_functions();
  test_arguments(argc, argv);
  test_files();
  test_counter();
  test_stack();
  board::print(failures == 0 ? "passed\n" : "FAILED\n");
  return failures;
}
