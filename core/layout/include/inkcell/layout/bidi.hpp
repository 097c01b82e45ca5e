// The order of mixed lines: Unicode's bidirectional algorithm, UAX #9.
//
// Levels are found once for each paragraph, in RAM that the caller lends; lines
// are then walked in visual order without more. All of Unicode 15: embeddings,
// overrides, isolates, brackets and mirror images. A program that names no Bidi
// links none of it, and reads all text from left to right.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/text.hpp"

namespace inkcell {

/// Where a paragraph begins.
enum class BaseDirection : uint8_t {
  from_text,  // where its first strong character says; left if there is none
  left_to_right,
  right_to_left,
};

/// Characters of one direction that stand side by side, by their bytes.
struct BidiRun {
  size_t begin = 0;
  size_t end = 0;
  uint8_t level = 0;  // odd: right to left

  constexpr bool is_right_to_left() const noexcept { return level % 2 != 0; }
};

/// Levels of one paragraph. One for each task that lays out text.
class Bidi {
 public:
  /// `cells`: one for each byte of the longest paragraph. What stands farther
  /// from the beginning of its paragraph has the paragraph's own direction.
  explicit constexpr Bidi(Span<uint16_t> cells) noexcept : cells_(cells) {}

  /// Finds the levels of the paragraph that begins at the byte `begin` of
  /// `text` and ends with its first paragraph separator (rules P2 to L1, the
  /// latter as if it were one line). Time grows with its length, at worst, of
  /// brackets in brackets, with the square of that.
  void resolve(const Text& text,
               size_t begin,
               BaseDirection direction) noexcept;

  /// The same unless that paragraph was resolved last.
  void prepare(const Text& text,
               size_t begin,
               BaseDirection direction) noexcept {
    if (text_ != text.data || begin_ != begin || direction_ != direction) {
      resolve(text, begin, direction);
    }
  }
  /// Call it when text was changed in place.
  void forget() noexcept { text_ = nullptr; }

  /// The paragraph that was resolved: its bytes, and its direction.
  size_t begin() const noexcept { return begin_; }
  size_t end() const noexcept { return end_; }
  uint8_t base_level() const noexcept { return base_level_; }

  /// The level of the character at an offset in the text.
  uint8_t level(size_t offset) const noexcept;

  /// The run that stands at the left end of the line [begin, end), and the one
  /// to the right of `run` (rule L2); false if there is none, `run` is then of
  /// no use. The line must not be empty, and lie in the paragraph.
  BidiRun first_run(size_t begin, size_t end) const noexcept;
  bool next_run(size_t begin, size_t end, BidiRun& run) const noexcept;

 private:
  Span<uint16_t> cells_;
  const char* text_ = nullptr;  // that was resolved
  BaseDirection direction_ = BaseDirection::from_text;
  size_t begin_ = 0;
  size_t end_ = 0;
  size_t count_ = 0;  // cells in use
  uint8_t base_level_ = 0;
};

}  // namespace inkcell
