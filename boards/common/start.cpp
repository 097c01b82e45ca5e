// From reset to main(), and from its result to the exit code.
#include "start.hpp"

#include <stddef.h>

#include "board.hpp"
#include "semihosting.hpp"

extern "C" {
// Set by flash_and_ram.ld.
extern const uint32_t inkcell_data_load[];
extern uint32_t inkcell_data_begin[];
extern uint32_t inkcell_data_end[];
extern uint32_t inkcell_bss_begin[];
extern uint32_t inkcell_bss_end[];
extern void (*const inkcell_init_begin[])() noexcept;
extern void (*const inkcell_init_end[])() noexcept;

// C++ forbids calling main() by its name.
int inkcell_application(int argc, char** argv) noexcept asm("main");
}

namespace {

constexpr size_t kLineBytes = 256;
constexpr int kMaxArguments = 16;

// Calls main() with the words of the command line. They are on the stack, so
// that they take no static RAM.
int call_application() noexcept {
  char line[kLineBytes];
  char* arguments[kMaxArguments + 1];
  int count = 0;
  inkcell::semihosting::command_line(line, sizeof line);
  char* at = line;
  while (*at != '\0' && count < kMaxArguments) {
    arguments[count++] = at;
    while (*at != '\0' && *at != ' ') {
      ++at;
    }
    if (*at == ' ') {
      *at++ = '\0';
    }
  }
  arguments[count] = nullptr;
  return inkcell_application(count, arguments);
}

}  // namespace

extern "C" void inkcell_start() noexcept {
  const uint32_t* from = inkcell_data_load;
  for (uint32_t* to = inkcell_data_begin; to != inkcell_data_end; ++to) {
    *to = *from++;
  }
  for (uint32_t* to = inkcell_bss_begin; to != inkcell_bss_end; ++to) {
    *to = 0;
  }
  inkcell::board::init();
  for (auto* init = inkcell_init_begin; init != inkcell_init_end; ++init) {
    (*init)();
  }
  inkcell::board::exit(call_application());
}

extern "C" void inkcell_fault(uint32_t address) noexcept {
  inkcell::board::print("fault at ");
  inkcell::board::print_hex(address);
  inkcell::board::print("\n");
  inkcell::board::exit(inkcell::board::kFaultExitCode);
}

void inkcell::board::exit(int code) noexcept {
  semihosting::exit(code);
  for (;;) {
#if !defined(__ARM_ARCH_5TEJ__)
    asm volatile("wfi");
#endif
  }
}
