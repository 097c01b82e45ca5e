// The prefix code of a font's outlines: section CODE (docs/FORMAT.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "outlines/outline_steps.hpp"

namespace inkcell::gen {

/// The content of a code word: the kind of a point, and the bits of its step.
struct CodeSymbol {
  WordKind kind;
  int x_bits;  // 0..15
  int y_bits;
};

/// A symbol and its word: the lowest `length` bits of `word`.
struct CodeWord {
  CodeSymbol symbol;
  int length;
  int word;

  /// Bits of a point with this word, or of the word of `end` alone.
  int total_bits() const { return length + symbol.x_bits + symbol.y_bits; }
};

/// How often each kind of step with each pair of widths occurs.
class StepCounts {
 public:
  static constexpr size_t kWidths = kMostStepBits + 1;

  /// Adds the steps of a glyph, without the last `end`: it is all zeros, like
  /// the bits after a record, so it costs nearly nothing.
  void add(const std::vector<OutlineStep>& steps);

  uint64_t ends() const { return ends_; }
  uint64_t points(WordKind kind, size_t x_bits, size_t y_bits) const {
    return points_[static_cast<size_t>(kind)][x_bits][y_bits];
  }

 private:
  uint64_t points_[3][kWidths][kWidths] = {};
  uint64_t ends_ = 0;
};

/// The lengths of a prefix code with the fewest bits and words of at most
/// `most` bits (package-merge). A count of 0 counts as 1. A single symbol gets
/// a word of one bit; two or more make the code complete.
///
/// `counts` has at most 2^most entries.
std::vector<int> limited_lengths(const std::vector<uint64_t>& counts, int most);

/// A complete prefix code. The word of `end` is all zeros.
class OutlineCode {
 public:
  /// Assigns words: `end` first, then from the longest to the shortest.
  /// `symbols` contains `end`; `lengths` come from limited_lengths().
  OutlineCode(int code_bits,
              const std::vector<CodeSymbol>& symbols,
              const std::vector<int>& lengths);

  int code_bits() const { return code_bits_; }
  /// By ascending words; the first is `end`.
  const std::vector<CodeWord>& words() const { return words_; }

  /// The 2^code_bits entries of section CODE.
  std::vector<uint16_t> table() const;

  /// The word with the fewest bits for `step`, or null if none fits.
  const CodeWord* find(const OutlineStep& step) const;

 private:
  int code_bits_;
  std::vector<CodeWord> words_;
};

/// The code with the smallest table and streams for `counts`, as far as the
/// search finds it. Joins pairs of widths, then improves single symbols. The
/// same counts give the same code on every machine. Words have `most_bits` bits
/// at most, 4..7.
OutlineCode make_outline_code(const StepCounts& counts, int most_bits = 7);

/// A code for all possible steps, without a search: for trials, whose picture
/// does not depend on the code.
OutlineCode widest_outline_code();

/// Bits of the streams for `counts`, without the table.
uint64_t stream_bits(const StepCounts& counts, const OutlineCode& code);

}  // namespace inkcell::gen
