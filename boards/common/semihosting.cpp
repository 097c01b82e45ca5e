// The semihosting trap of each architecture, and its calls.
#include "semihosting.hpp"

extern "C" {
// The label inkcell_semihosting_trap marks the trapping instruction, for fault
// handlers. `block` points to the operation's parameters.
intptr_t inkcell_semihosting(uint32_t operation, const void* block) noexcept;
}

#if defined(__riscv)
// The three instructions must be uncompressed and in one page.
asm(R"(
    .section .text.inkcell_semihosting, "ax"
    .globl inkcell_semihosting, inkcell_semihosting_trap
    .type inkcell_semihosting, @function
    .option push
    .option norvc
    .balign 16
inkcell_semihosting:
    slli zero, zero, 0x1f
inkcell_semihosting_trap:
    ebreak
    srai zero, zero, 7
    .option pop
    ret
    .previous
)");
#elif defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
asm(R"(
    .section .text.inkcell_semihosting, "ax"
    .globl inkcell_semihosting, inkcell_semihosting_trap
    .type inkcell_semihosting, %function
    .thumb_func
    .balign 4
inkcell_semihosting:
inkcell_semihosting_trap:
    bkpt 0xab
    bx lr
    .previous
)");
#else
// The trap overwrites lr, as these cores run everything in supervisor mode.
asm(R"(
    .section .text.inkcell_semihosting, "ax"
    .globl inkcell_semihosting, inkcell_semihosting_trap
    .type inkcell_semihosting, %function
    .balign 4
inkcell_semihosting:
    mov r2, lr
inkcell_semihosting_trap:
    svc 0x123456
    bx r2
    .previous
)");
#endif

namespace inkcell::semihosting {
namespace {

// The operations' numbers in the Arm semihosting specification.
enum Operation : uint32_t {
  kOpen = 0x01,
  kClose = 0x02,
  kWrite = 0x05,
  kRead = 0x06,
  kLength = 0x0c,
  kGetCommandLine = 0x15,
  kExitExtended = 0x20,
};

constexpr uintptr_t kApplicationExit = 0x20026;

uintptr_t address(const void* pointer) noexcept {
  return reinterpret_cast<uintptr_t>(pointer);
}

}  // namespace

intptr_t open(const char* name, Mode mode) noexcept {
  size_t size = 0;
  while (name[size] != '\0') {
    ++size;
  }
  // For writing, a terminal is opened as text.
  const bool terminal = name[0] == ':' && mode == Mode::write;
  const uintptr_t block[3] = {
      address(name), terminal ? 4 : static_cast<uintptr_t>(mode), size};
  return inkcell_semihosting(kOpen, block);
}

bool read(intptr_t file, void* bytes, size_t size) noexcept {
  const uintptr_t block[3] = {static_cast<uintptr_t>(file), address(bytes),
                              size};
  return inkcell_semihosting(kRead, block) == 0;
}

bool write(intptr_t file, const void* bytes, size_t size) noexcept {
  const uintptr_t block[3] = {static_cast<uintptr_t>(file), address(bytes),
                              size};
  return inkcell_semihosting(kWrite, block) == 0;
}

intptr_t length(intptr_t file) noexcept {
  const uintptr_t block[1] = {static_cast<uintptr_t>(file)};
  return inkcell_semihosting(kLength, block);
}

void close(intptr_t file) noexcept {
  const uintptr_t block[1] = {static_cast<uintptr_t>(file)};
  inkcell_semihosting(kClose, block);
}

bool command_line(char* line, size_t size) noexcept {
  uintptr_t block[2] = {address(line), size};
  if (inkcell_semihosting(kGetCommandLine, block) != 0) {
    line[0] = '\0';
    return false;
  }
  return true;
}

void exit(int code) noexcept {
  const uintptr_t block[2] = {kApplicationExit, static_cast<uintptr_t>(code)};
  inkcell_semihosting(kExitExtended, block);
}

}  // namespace inkcell::semihosting
