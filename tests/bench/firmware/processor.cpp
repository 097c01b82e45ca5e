// Sets the core up before main() as compilers expect it when they are told its
// name only: unaligned access is not refused, as the boards' start-up has it,
// and the floating-point unit, where it is used, is on.
#include <stdint.h>

#include "registers.hpp"

#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH >= 7

namespace {

// Configuration and control register.
constexpr uintptr_t kConfiguration = 0xe000ed14;
constexpr uint32_t kUnalignedTrap = 1 << 3;

#  if defined(__ARM_FP)
// Coprocessor access control: full access to coprocessors 10 and 11.
constexpr uintptr_t kAccess = 0xe000ed88;
constexpr uint32_t kFloatingPoint = 0xf << 20;
#  endif

[[gnu::constructor]] void set_up() {
  using inkcell::board::reg;
  reg(kConfiguration) = reg(kConfiguration) & ~kUnalignedTrap;
#  if defined(__ARM_FP)
  reg(kAccess) = reg(kAccess) | kFloatingPoint;
#  endif
  asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

#endif
