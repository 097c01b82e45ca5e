// Switches the floating-point unit on before main(), where there is one.
#include <stdint.h>

#if defined(__ARM_FP)

#  include "registers.hpp"

namespace {

// Coprocessor access control: full access to coprocessors 10 and 11.
constexpr uintptr_t kAccess = 0xe000ed88;

[[gnu::constructor]] void switch_on() {
  inkcell::board::reg(kAccess) = inkcell::board::reg(kAccess) | 0xf << 20;
  asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace

#endif
