// A test harness that needs nothing: the same tests run on host and boards.
//
//   TEST(halves_round_up) {
//     CHECK(is_empty(Rect{}));
//     CHECK_EQ(divide_by_255(128), 1u);
//   }
//
// A failed check is reported and the test goes on. Each file of tests becomes a
// program; check_main.cpp runs all its tests in the order of the file.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace check {

/// A test of this program. Lives in static memory; linked in by constructors.
class Test {
 public:
  using Body = void (*)();

  Test(const char* name, Body body);

  const char* name;
  Body body;
  Test* next = nullptr;
};

/// Runs all tests, prints the names of those that fail and a closing line.
/// Returns the number of failed tests, at most 255; 255 if there are none.
int run_all();

/// Notes that a check of the running test failed.
void fail(const char* file, int line, const char* what);
void fail_values(
    const char* file, int line, const char* what, int64_t left, int64_t right);

/// Prints on the console: stdout, or the board's.
void write(const char* text);
void write(const char* text, size_t size);
void write_number(int64_t value);

/// Whether the running test has failed: to leave a long loop after the first
/// report.
bool failed();

/// For Rounds: failures from here on are of this round of the running test.
/// False where another round was asked for: it shall not run.
bool begin_round(int32_t number);
void end_rounds();

/// The one round that shall run, "test/number"; null: all. Host: the
/// environment variable INKCELL_ROUND.
const char* wanted_round();

}  // namespace check

#define TEST(test_name)                                                      \
  static void test_##test_name();                                            \
  static ::check::Test registered_##test_name(#test_name, test_##test_name); \
  static void test_##test_name()

#define CHECK(condition)                             \
  do {                                               \
    if (!(condition)) {                              \
      ::check::fail(__FILE__, __LINE__, #condition); \
    }                                                \
  } while (false)

/// Both must be integers or enumerations, and are compared as int64_t.
#define CHECK_EQ(left, right)                                       \
  do {                                                              \
    const auto check_left = static_cast<int64_t>(left);             \
    const auto check_right = static_cast<int64_t>(right);           \
    if (check_left != check_right) {                                \
      ::check::fail_values(__FILE__, __LINE__, #left " == " #right, \
                           check_left, check_right);                \
    }                                                               \
  } while (false)

/// For a call that returns a Status.
#define CHECK_OK(call) CHECK_EQ((call), ::inkcell::Status::ok)
