// Counting the instructions of a piece of code, exactly and repeatably.
//
// qemu_run.sh lets every instruction last a fixed virtual time, so a timer
// counts instructions. On hardware the same code counts time. Boards whose
// timer ticks more slowly than instructions do not define
// INKCELL_COUNTER_PICOSECONDS and have no counter.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace board {

/// The board's counter; wraps at 2^INKCELL_COUNTER_BITS. [ticks]
uint32_t counter_ticks() noexcept;

#if defined(INKCELL_COUNTER_PICOSECONDS)

/// What qemu_run.sh makes an instruction last.
#  if defined(__riscv)
inline constexpr uint64_t kInstructionPicoseconds = 1000;
#  else
inline constexpr uint64_t kInstructionPicoseconds = 256000;
#  endif

inline constexpr uint64_t kTickPicoseconds = INKCELL_COUNTER_PICOSECONDS;
inline constexpr uint32_t kCounterMask = 0xffffffffu >>
                                         (32 - INKCELL_COUNTER_BITS);

// Each reading is up to one tick off, so the difference is, too. Less than half
// an instruction rounds to the exact count.
static_assert(kTickPicoseconds * 2 <= kInstructionPicoseconds ||
                  kTickPicoseconds == kInstructionPicoseconds,
              "the counter is too coarse to count instructions");

/// The most that can be counted before the counter wraps.
inline constexpr uint32_t kMaxInstructions = static_cast<uint32_t>(
    kCounterMask * kTickPicoseconds / kInstructionPicoseconds);

namespace detail {

// The instructions from one reading of the counter to the next, with `work()`
// between them.
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

/// The instructions that `work()` executes, at most kMaxInstructions; with the
/// call, if the compiler makes one.
template <typename Work>
uint32_t count_instructions(const Work& work) noexcept {
  const uint32_t count = detail::count_with_reading(work);
  return count - detail::count_with_reading([] {});
}

#endif

}  // namespace board
}  // namespace inkcell
