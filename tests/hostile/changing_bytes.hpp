// Memory that reads differently each time, like flash that is being written.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"

namespace hostile {

/// A copy of `content` between two guard pages. Between start() and stop()
/// every load of it traps; one load in `one_in` finds other bytes, just this
/// once. So a value that was checked cannot be read again, whether the source
/// or the compiler does so.
///
/// x86-64 Linux; one object at a time, one thread.
class ChangingBytes {
 public:
  /// The copy ends at the upper guard page, or begins after the lower one.
  ChangingBytes(inkcell::Span<const uint8_t> content, bool is_at_end);
  ~ChangingBytes();
  ChangingBytes(const ChangingBytes&) = delete;
  ChangingBytes& operator=(const ChangingBytes&) = delete;

  inkcell::Span<const uint8_t> bytes() const { return bytes_; }
  void start(uint32_t seed, uint32_t one_in);
  void stop();

  /// The number of loads that trapped, and of those that found other bytes.
  static int64_t load_count();
  static int64_t change_count();

 private:
  uint8_t* pages_;  // guard, content, guard
  size_t page_;
  size_t inner_size_;
  inkcell::Span<const uint8_t> bytes_;
};

}  // namespace hostile
