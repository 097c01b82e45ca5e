// The prefix code of a font's outlines: section CODE (docs/FORMAT.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "outlines/outline_steps.hpp"

namespace inkcell::gen {

/// The content of a code word: the kind of a point, and the bits of its step.
struct CodeSymbol {
  WordKind kind;
  int x_bits;  // 0..15
  int y_bits;
  int sign = 0;  // of the first number that has bits, 1 or -1; 0: either
};

/// The symbol of exactly this step.
CodeSymbol symbol_of(const OutlineStep& step);

/// Whether steps of `narrow` may be written by the word of `wide`.
bool covers(const CodeSymbol& wide, const CodeSymbol& narrow);

/// The smallest tables to try. Smaller ones cannot distinguish the kinds of
/// points.
inline constexpr int kLeastCodeBits = 4;
inline constexpr int kMostCodeBits = 7;

/// Of each entry of a table of code words.
inline constexpr uint64_t kEntryBits = 16;

/// A symbol and its word: the lowest `length` bits of `word`.
struct CodeWord {
  CodeSymbol symbol;
  int length;
  int word;
  bool shares_bit = false;  // its last bit is the first one of the number
  size_t next_table = 0;

  /// Bits of a point with this word, or of the word of `end` alone.
  int total_bits() const {
    return length - (shares_bit ? 1 : 0) + symbol.x_bits + symbol.y_bits;
  }
};

/// What a step says about the next one: its kind, whether it goes along an
/// axis, and the sign of its first number.
size_t class_of(const CodeSymbol& symbol);
inline constexpr size_t kStepClasses = 3 * 7 + 1;
/// That of the beginning of a record, and of an end.
inline constexpr size_t kStartClass = 0;

/// How often each kind of step with each pair of widths occurs, after steps of
/// one class.
struct ClassCounts {
  struct Less {
    bool operator()(const CodeSymbol& a, const CodeSymbol& b) const;
  };

  std::map<CodeSymbol, uint64_t, Less> points;
  uint64_t ends = 0;
  bool has_end = false;  // perhaps only of a record

  void add(const ClassCounts& other);
};

/// How often each kind of step occurs in a font.
class StepCounts {
 public:
  /// Adds the steps of a glyph. The last `end` does not count: it is all zeros,
  /// like the bits after a record, so it costs nearly nothing.
  void add(const std::vector<OutlineStep>& steps);

  const std::array<ClassCounts, kStepClasses>& after() const { return after_; }
  /// After any class, without signs.
  ClassCounts all() const;

 private:
  std::array<ClassCounts, kStepClasses> after_;
};

/// Complete prefix codes, one a table. The word of `end` is all zeros.
class OutlineCode {
 public:
  using Words = std::vector<CodeWord>;
  using TableOfClass = std::array<size_t, kStepClasses>;

  /// A single table. Assigns words: `end` first, then from the longest to the
  /// shortest. `symbols` contains `end`; `lengths` come from limited_lengths().
  OutlineCode(int code_bits,
              const std::vector<CodeSymbol>& symbols,
              const std::vector<int>& lengths);

  /// 1, 2, 4 or 8 tables with words; records begin with table 0. Sets their
  /// `next_table`.
  OutlineCode(int code_bits,
              std::vector<Words> tables,
              const TableOfClass& table_of_class);

  int code_bits() const { return code_bits_; }
  size_t table_count() const { return tables_.size(); }
  /// By ascending words; the first is `end` if the table has one.
  const Words& words(size_t table = 0) const { return tables_[table]; }

  /// The entries of section CODE, 2^code_bits a table.
  std::vector<uint16_t> table() const;

  /// The word of a table with the fewest bits for `step`, or null if none fits.
  const CodeWord* find(const OutlineStep& step, size_t table) const {
    return find(symbol_of(step), table);
  }
  const CodeWord* find(const CodeSymbol& symbol, size_t table) const;

  /// The table of a word after a step of this class.
  size_t table_after(size_t step_class) const {
    return table_of_class_[step_class];
  }

 private:
  int code_bits_;
  std::vector<Words> tables_;
  TableOfClass table_of_class_ = {};
};

/// A code for all possible steps, without a search: for trials, whose picture
/// does not depend on the code.
OutlineCode widest_outline_code();

/// Bits of the streams for `counts`, without the tables.
uint64_t stream_bits(const StepCounts& counts, const OutlineCode& code);

}  // namespace inkcell::gen
