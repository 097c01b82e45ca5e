// Paints the stack, and finds how much of the paint is overwritten.
#include "stack.hpp"

namespace inkcell::board {
namespace {

constexpr uint32_t kPaint = 0x5ac3a53c;

}  // namespace

[[gnu::noinline]] void paint_stack() noexcept {
  const volatile uint32_t* end =
      reinterpret_cast<const volatile uint32_t*>(stack_pointer());
  for (volatile uint32_t* at = inkcell_stack_limit; at < end; ++at) {
    *at = kPaint;
  }
}

uintptr_t lowest_stack_used() noexcept {
  const volatile uint32_t* at = inkcell_stack_limit;
  while (at < inkcell_stack_top && *at == kPaint) {
    ++at;
  }
  return reinterpret_cast<uintptr_t>(at);
}

}  // namespace inkcell::board
