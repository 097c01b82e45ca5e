// The list of tests, and what is printed about them.
#include "check.hpp"
#include "pixels.hpp"

// Where the section begins and ends, by the linker.
extern "C" {
extern const check::Test __start_inkcell_tests[];
extern const check::Test __stop_inkcell_tests[];
}

namespace check {

namespace {

const Test* running = nullptr;
bool running_failed = false;
int failures_printed = 0;    // of the running test
int32_t running_round = -1;  // none

// A check in a loop over all inputs may fail a million times.
constexpr int kMaxPrinted = 10;

const char* base_name(const char* path) {
  const char* base = path;
  for (const char* at = path; *at != '\0'; ++at) {
    if (*at == '/') {
      base = at + 1;
    }
  }
  return base;
}

// Whether `text` is `begin` and then `end`.
bool is_same(const char* text, const char* begin, const char* end) {
  while (*begin != '\0' && *text == *begin) {
    ++text;
    ++begin;
  }
  while (*begin == '\0' && *end != '\0' && *text == *end) {
    ++text;
    ++end;
  }
  return *begin == '\0' && *end == '\0' && *text == '\0';
}

// Whether `wanted`, "test/number", names this test; its number.
bool names_test(const char* wanted, const char* test, int32_t& number) {
  while (*test != '\0' && *wanted == *test) {
    ++wanted;
    ++test;
  }
  if (*test != '\0' || *wanted != '/') {
    return false;
  }
  number = 0;
  for (++wanted; *wanted >= '0' && *wanted <= '9'; ++wanted) {
    number = number * 10 + (*wanted - '0');
  }
  return *wanted == '\0';
}

// Whether `name` is that of a test or of its file.
bool is_name(const char* name, const Test& test) {
  return is_same(name, test.name, "") ||
         is_same(base_name(test.file) + sizeof("test_") - 1, name, ".cpp");
}

bool is_wanted(const Test& test, int name_count, const char* const* names) {
  int32_t number;
  if (wanted_round() != nullptr &&
      !names_test(wanted_round(), test.name, number)) {
    return false;
  }
  for (int i = 0; i < name_count; ++i) {
    if (is_name(names[i], test)) {
      return true;
    }
  }
  return name_count == 0;
}

// The number of names that are those of no test; says so.
int unknown_names(int name_count, const char* const* names) {
  int unknown = 0;
  for (int i = 0; i < name_count; ++i) {
    const Test* test = __start_inkcell_tests;
    while (test != __stop_inkcell_tests && !is_name(names[i], *test)) {
      ++test;
    }
    if (test == __stop_inkcell_tests) {
      write("no test and no file test_<name>.cpp is called ");
      write(names[i]);
      write("\n");
      ++unknown;
    }
  }
  return unknown;
}

bool begin_failure(const char* file, int line, const char* what) {
  running_failed = true;
  if (failures_printed == kMaxPrinted) {
    return false;
  }
  ++failures_printed;
  write(base_name(file));
  write(":");
  write_number(line);
  write(": ");
  write(running->name);
  if (running_round >= 0) {
    write("/");
    write_number(running_round);
  }
  write(": ");
  write(what);
  return true;
}

}  // namespace

int run(int name_count, const char* const* names) {
  const int unknown = unknown_names(name_count, names);
  int passed = 0;
  int failures = 0;
  for (running = __start_inkcell_tests; running != __stop_inkcell_tests;
       ++running) {
    if (!is_wanted(*running, name_count, names)) {
      continue;
    }
    running_failed = false;
    failures_printed = 0;
    running_round = -1;
    running->body();
    ++(running_failed ? failures : passed);
  }
  write_number(passed);
  write(" passed, ");
  write_number(failures);
  write(" failed\n");
  if (unknown != 0 || passed + failures == 0) {
    return 255;
  }
  return failures > 255 ? 255 : failures;
}

void fail(const char* file, int line, const char* what) {
  if (begin_failure(file, line, what)) {
    write("\n");
  }
}

void fail_values(
    const char* file, int line, const char* what, int64_t left, int64_t right) {
  if (begin_failure(file, line, what)) {
    write(": ");
    write_number(left);
    write(" and ");
    write_number(right);
    write("\n");
  }
}

bool failed() {
  return running_failed;
}

bool begin_round(int32_t number) {
  int32_t wanted;
  if (wanted_round() != nullptr &&
      (!names_test(wanted_round(), running->name, wanted) ||
       number != wanted)) {
    return false;
  }
  if (!running_failed) {
    running_round = number;
  }
  return true;
}

void end_rounds() {
  if (running_failed && running_round >= 0) {
    write("the round alone: INKCELL_ROUND=");
    write(running->name);
    write("/");
    write_number(running_round);
    write("\n");
  }
  running_round = -1;
}

void write(const char* text) {
  size_t size = 0;
  while (text[size] != '\0') {
    ++size;
  }
  write(text, size);
}

void write_number(int64_t value) {
  char digits[20];
  char* at = digits + sizeof(digits);
  auto rest = static_cast<uint64_t>(value < 0 ? ~value : value);
  rest += value < 0 ? 1u : 0u;
  do {
    *--at = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  if (value < 0) {
    *--at = '-';
  }
  write(at, static_cast<size_t>(digits + sizeof(digits) - at));
}

}  // namespace check
