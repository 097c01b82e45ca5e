// Embedding levels of one paragraph: UAX #9, sections 3.3.1 to 3.3.6.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "bidi_class.hpp"
#include "inkcell/text.hpp"

namespace inkcell::detail {

// What is known of a character: the cell of its first byte. The cells of other
// bytes only say that they are such.
struct BidiCell {
  static constexpr uint32_t kClassBits = 5;
  static constexpr uint32_t kClassMask = (1 << kClassBits) - 1;
  static constexpr uint32_t kLevelMask = 127 << kClassBits;
  static constexpr uint32_t kOpensIsolate = 1 << 12;
  static constexpr uint32_t kClosesIsolate = 1 << 13;
  static constexpr uint32_t kPaired = 1 << 14;  // a bracket with its partner
  static constexpr uint32_t kFollows = 1 << 15;

  static constexpr uint8_t level(uint16_t cell) noexcept {
    return static_cast<uint8_t>((cell & kLevelMask) >> kClassBits);
  }
};

// Works in the cells, one for each byte. Positions are bytes of the paragraph;
// `count_` is none.
class BidiLevels {
 public:
  // `text` begins with the paragraph and has at least `count` bytes.
  BidiLevels(const char* text, uint16_t* cells, uint32_t count) noexcept
      : text_(text), cells_(cells), count_(count) {}

  // Fills in the classes, as far as whole characters go. Returns their bytes:
  // less than `count` if the paragraph ends before.
  uint32_t read() noexcept;

  // Rules P2 and P3: 0 or 1.
  uint8_t base_level() const noexcept;

  // All further rules up to L1.
  void resolve(uint8_t base_level) noexcept;

 private:
  // An isolating run sequence (BD13), between two directions.
  struct Sequence {
    uint32_t first;
    uint8_t level;
    BidiClass before;  // l or r
    BidiClass after;
  };
  class Stack;

  BidiClass get(uint32_t at) const noexcept {
    return static_cast<BidiClass>(cells_[at] & BidiCell::kClassMask);
  }
  void set(uint32_t at, BidiClass value) noexcept;
  uint8_t level(uint32_t at) const noexcept {
    return BidiCell::level(cells_[at]);
  }
  void set_level(uint32_t at, uint32_t value) noexcept;
  bool has(uint32_t at, uint32_t flag) const noexcept {
    return (cells_[at] & flag) != 0;
  }
  bool is_removed(uint32_t at) const noexcept {
    return get(at) == BidiClass::bn;
  }
  uint32_t code_point(uint32_t at) const noexcept;
  BidiClass first_class(uint32_t at) const noexcept;

  uint32_t next(uint32_t at) const noexcept;
  uint32_t next_kept(uint32_t at) const noexcept;
  uint32_t previous_kept(uint32_t at) const noexcept;
  uint32_t next_in_sequence(uint32_t at) const noexcept;
  uint32_t end_of_isolate(uint32_t at) const noexcept;
  bool has_start_of_isolate(uint32_t at) const noexcept;
  BidiClass first_strong(uint32_t at, bool is_isolate) const noexcept;

  void set_explicit() noexcept;
  void put(uint32_t at, const Stack& stack) noexcept;
  Sequence sequence_from(uint32_t first) const noexcept;
  void resolve_sequences() noexcept;
  void resolve_weak(const Sequence& sequence) noexcept;
  void resolve_separators(const Sequence& sequence) noexcept;
  void pair_brackets(const Sequence& sequence) noexcept;
  void resolve_brackets(const Sequence& sequence) noexcept;
  void resolve_pair(uint32_t opening,
                    const Sequence& sequence,
                    BidiClass before) noexcept;
  void set_bracket(uint32_t at, BidiClass value) noexcept;
  void resolve_neutrals(const Sequence& sequence) noexcept;
  void set_implicit() noexcept;
  void reset_spaces() noexcept;

  const char* text_;
  uint16_t* cells_;
  uint32_t count_;
  uint8_t base_level_ = 0;
};

}  // namespace inkcell::detail
