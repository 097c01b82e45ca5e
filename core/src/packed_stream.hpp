// What the decoder of packed glyphs reads from and remembers: bits, and the
// fields that were used last.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/format.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace detail {

// Bits of a stream, the first in the highest place of a byte; zeros behind its
// end.
class BitStream {
 public:
  BitStream() noexcept = default;
  explicit BitStream(Span<const uint8_t> bytes) noexcept
      : next_(bytes.begin()), left_(static_cast<ptrdiff_t>(bytes.size)) {}

  // Makes 16 bits available, at least.
  void fill() noexcept {
    if (missing_ <= 0) {
      return;
    }
    left_ -= 2;
    if (left_ >= 0) {
      bits_ |= (uint32_t{next_[0]} << 8 | next_[1]) << missing_;
      next_ += 2;
    } else if (left_ == -1) {
      bits_ |= uint32_t{next_[0]} << 8 << missing_;
    }
    missing_ -= 16;
  }

  // The next `width` bits, of those that are available; 1 at least.
  uint32_t peek(uint32_t width) const noexcept { return bits_ >> (32 - width); }
  void drop(uint32_t width) noexcept {
    bits_ <<= width;
    missing_ += static_cast<int32_t>(width);
  }

  // Takes `width` bits, 16 at most.
  uint32_t number(uint32_t width) noexcept {
    fill();
    const uint32_t value = peek(16) >> (16 - width);
    drop(width);
    return value;
  }

  // Bytes of which no bit has been taken; less than 0 behind the end.
  ptrdiff_t left() const noexcept { return left_ + ((16 - missing_) >> 3); }

 private:
  const uint8_t* next_ = nullptr;
  ptrdiff_t left_ = 0;    // bytes from `next_` on
  uint32_t bits_ = 0;     // those to come, from the highest place on
  int32_t missing_ = 16;  // of them, to have 16
};

// The last fields that were used, the latest in front, by where they lie.
class RecentFields {
 public:
  // Places, for `move`. The list ends before `end`.
  uint32_t begin() const noexcept { return begin_; }
  uint32_t end() const noexcept { return end_; }
  const uint16_t* front() const noexcept { return units_ + begin_; }

  // Empties the list, and makes room for `count` fields.
  uint16_t* reset(uint32_t count) noexcept {
    begin_ = kRoom - count;
    end_ = kRoom;
    return units_ + begin_;
  }
  // Moves the field at `place` forward to `rank`.
  void move(uint32_t place, uint32_t rank) noexcept {
    if (place == begin_ + rank) {
      return;
    }
    uint16_t* const to = units_ + begin_ + rank;
    uint16_t* from = units_ + place;
    const uint16_t unit = *from;
    do {
      *from = from[-1];
      --from;
    } while (from != to);
    *to = unit;
  }
  // The list grows until `trim` is called; it has room for kRoom.
  void insert(uint32_t unit, uint32_t rank) noexcept {
    if (begin_ == 0) {
      for (begin_ = kRoom; end_ != 0;) {
        units_[--begin_] = units_[--end_];
      }
      end_ = kRoom;
    }
    --begin_;
    uint16_t* const list = units_ + begin_;
    for (uint32_t i = 0; i < rank; ++i) {
      list[i] = list[i + 1];
    }
    list[rank] = static_cast<uint16_t>(unit);
  }
  // Forgets what is too old.
  void trim() noexcept {
    if (end_ - begin_ > format::packed::kRecentFields) {
      end_ = begin_ + format::packed::kRecentFields;
    }
  }

 private:
  // Twice as many as are kept, so that few of all insertions must move them.
  static constexpr uint32_t kRoom = 2 * format::packed::kRecentFields;

  uint16_t units_[kRoom];
  uint32_t begin_ = kRoom;
  uint32_t end_ = kRoom;
};

}  // namespace detail
}  // namespace inkcell
