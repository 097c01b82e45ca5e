// Counts the instructions of a piece of code, exactly and reproducibly.
//
// qemu_run.sh gives every instruction a fixed virtual time, so a timer counts
// instructions. On hardware the same code counts time. Boards whose timer is
// slower than their instructions do not define INKCELL_COUNTER_PICOSECONDS and
// have no counter.
#pragma once

#include <stdint.h>

namespace inkcell::board {

/// The board's counter; wraps at 2^INKCELL_COUNTER_BITS. [ticks]
uint32_t counter_ticks() noexcept;

#if defined(INKCELL_COUNTER_PICOSECONDS)

/// The time of an instruction in qemu_run.sh.
#  if defined(__riscv)
inline constexpr uint64_t kInstructionPicoseconds = 1000;
#  else
inline constexpr uint64_t kInstructionPicoseconds = 256000;
#  endif

inline constexpr uint64_t kTickPicoseconds = INKCELL_COUNTER_PICOSECONDS;
inline constexpr uint32_t kCounterMask = 0xffffffffu >>
                                         (32 - INKCELL_COUNTER_BITS);

// Each reading is up to one tick off, and so is the difference. Less than half
// an instruction rounds to the exact count.
static_assert(kTickPicoseconds * 2 <= kInstructionPicoseconds ||
                  kTickPicoseconds == kInstructionPicoseconds,
              "the counter is too coarse to count instructions");

/// The largest count before the counter wraps.
inline constexpr uint32_t kMaxInstructions = static_cast<uint32_t>(
    kCounterMask * kTickPicoseconds / kInstructionPicoseconds);

namespace detail {

// The instructions from one reading of the counter to the next, including
// `work()`.
template <typename Work>
[[gnu::noinline]] uint32_t count_with_reading(const Work& work) noexcept {
  const uint32_t begin_ticks = counter_ticks();
  work();
  const uint64_t ticks = (counter_ticks() - begin_ticks) & kCounterMask;
  return static_cast<uint32_t>(
      (ticks * kTickPicoseconds + kInstructionPicoseconds / 2) /
      kInstructionPicoseconds);
}

}  // namespace detail

/// The instructions of `work()`, at most kMaxInstructions; including the call,
/// if the compiler makes one.
template <typename Work>
uint32_t count_instructions(const Work& work) noexcept {
  const uint32_t count = detail::count_with_reading(work);
  return count - detail::count_with_reading([] {});
}

#endif

}  // namespace inkcell::board
