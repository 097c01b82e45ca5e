// The list of tests, and what is printed about them.
#include "check.hpp"

namespace check {

namespace {

Test* first_test = nullptr;
Test* last_test = nullptr;
Test* running = nullptr;
bool running_failed = false;
int failures_printed = 0;  // of the running test

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
  write(": ");
  write(what);
  return true;
}

}  // namespace

Test::Test(const char* test_name, Body test_body)
    : name(test_name), body(test_body) {
  if (last_test == nullptr) {
    first_test = this;
  } else {
    last_test->next = this;
  }
  last_test = this;
}

int run_all() {
  int passed = 0;
  int failures = 0;
  for (running = first_test; running != nullptr; running = running->next) {
    running_failed = false;
    failures_printed = 0;
    running->body();
    ++(running_failed ? failures : passed);
  }
  write_number(passed);
  write(" passed, ");
  write_number(failures);
  write(" failed\n");
  if (passed + failures == 0) {
    return 255;  // constructors did not run, or the file is empty
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
