// A test harness that needs nothing: the same tests run on host and boards.
//
//   TEST(halves_round_up) {
//     CHECK(is_empty(Rect{}));
//     CHECK_EQ(divide_by_255(128), 1u);
//   }
//
// A failed check is reported and the test goes on. A program has the tests of
// many files; check_main.cpp runs all, or those that its arguments name.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace check {

/// A test of this program, one of those in the section inkcell_tests: the list
/// takes no RAM, and no code before main().
struct Test {
  const char* name;
  const char* file;
  void (*body)();
};

/// Runs the tests that one of `names` names: its own, or its file's, which is
/// field for tests/unit/test_field.cpp. All if there are none. Prints what
/// fails and a closing line. Returns the number of failed tests, at most 255;
/// 255 if a name is that of no test, or no test ran.
int run(int name_count, const char* const* names);

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

/// |value|.
template <typename Number>
constexpr Number magnitude(Number value) {
  return value < 0 ? -value : value;
}

/// Values to loop over: `for (const int32_t px : each_of({9, 16})) {`.
template <typename Value, size_t kCount>
struct Values {
  const Value* begin() const { return values; }
  const Value* end() const { return values + kCount; }

  Value values[kCount];
};
template <typename Value, size_t kCount>
constexpr Values<Value, kCount> each_of(const Value (&values)[kCount]) {
  Values<Value, kCount> all = {};
  for (size_t i = 0; i < kCount; ++i) {
    all.values[i] = values[i];
  }
  return all;
}

#define TEST(test_name)                                                  \
  static void test_##test_name();                                        \
  __attribute__((section("inkcell_tests"), used,                         \
                 aligned(sizeof(void*)))) static const ::check::Test     \
      registered_##test_name = {#test_name, __FILE__, test_##test_name}; \
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
