// Cortex-M: vector table, reset and faults.
#include <stdint.h>

#include "registers.hpp"
#include "start.hpp"

extern "C" {
extern uint32_t inkcell_stack_top[];
[[noreturn]] void inkcell_reset() noexcept;
void inkcell_fault_entry() noexcept;
}

namespace {

// Configuration and control register: refuse unaligned access and division by
// zero. Cortex-M0 ignores the write; its hardware always refuses the first.
constexpr uintptr_t kConfiguration = 0xe000ed14;
constexpr uint32_t kDivideByZeroTrap = 1 << 4;
constexpr uint32_t kUnalignedTrap = 1 << 3;

using Handler = void (*)() noexcept;

struct VectorTable {
  uint32_t* stack;
  Handler handlers[15];
};

constexpr Handler kFault = inkcell_fault_entry;

}  // namespace

[[gnu::section(".vectors"), gnu::used]] const VectorTable inkcell_vectors = {
    inkcell_stack_top,
    {inkcell_reset, kFault, kFault, kFault, kFault, kFault, nullptr, nullptr,
     nullptr, nullptr, kFault, kFault, nullptr, kFault, kFault}};

extern "C" void inkcell_reset() noexcept {
#if __ARM_ARCH >= 7
  inkcell::board::reg(kConfiguration) =
      inkcell::board::reg(kConfiguration) | kDivideByZeroTrap | kUnalignedTrap;
#endif
  inkcell_start();
}

// The core has pushed eight words; the seventh is the address of the
// instruction. If the stack pointer has left the stack, they cannot be read and
// nothing can be pushed: restart from the top.
//
// If the instruction is the semihosting trap, there is no debugger to handle
// it: continue after it with the result -1.
asm(R"(
    .syntax unified
    .section .text.inkcell_fault_entry, "ax"
    .globl inkcell_fault_entry
    .type inkcell_fault_entry, %function
    .thumb_func
    .balign 4
inkcell_fault_entry:
    movs r0, #0
    mov r1, sp
    ldr r2, =inkcell_stack_limit
    cmp r1, r2
    blo 1f
    ldr r2, =inkcell_stack_top - 32
    cmp r1, r2
    bhi 1f
    ldr r0, [r1, #24]
    ldr r2, =inkcell_semihosting_trap
    lsrs r2, r2, #1
    lsls r2, r2, #1
    cmp r0, r2
    bne 1f
    adds r0, #2
    str r0, [r1, #24]
    movs r0, #0
    mvns r0, r0
    str r0, [r1]
    bx lr
1:  ldr r1, =inkcell_stack_top
    mov sp, r1
    ldr r1, =inkcell_fault
    bx r1
    .pool
    .previous
)");
