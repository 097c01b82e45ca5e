// Section GRID and the hints in records (docs/FORMAT.md): hints to bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "hints/glyph_hints.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {

/// Bits in the order in which a reader takes them.
using HintBits = std::vector<bool>;

/// A code word for some neighbouring numbers.
struct NumberWord {
  uint32_t base = 0;
  unsigned extra = 0;   // bits of the number above the base
  unsigned length = 0;  // of the word
  uint32_t word = 0;    // its first bit is the lowest
  uint32_t end = 0;     // after the last number that it writes
};

/// A prefix code for numbers of 0..1534.
class NumberCode {
 public:
  /// Writes every number of `counts`, with words of `code_bits` bits at most.
  NumberCode(const std::map<uint32_t, uint64_t>& counts, unsigned code_bits);

  /// `number` is one of those.
  void put(uint32_t number, HintBits& bits) const;

  /// Of all numbers that were counted.
  uint64_t total_bits() const { return total_bits_; }

  /// The 2^code_bits entries of its table.
  std::vector<uint16_t> table() const;

 private:
  std::vector<NumberWord> words_;  // by ascending bases
  unsigned code_bits_;
  uint64_t total_bits_ = 0;
};

/// The code words of a font's hints.
class HintCode {
 public:
  /// The smallest tables and records together, with tables of 2^most_code_bits
  /// entries at most.
  HintCode(const FontHints& hints, unsigned most_code_bits);

  /// The hints of a glyph of this font; none without a section.
  HintBits bits(const GlyphHints& hints) const;

  /// The section, without padding; nothing for a font without hints.
  std::vector<uint8_t> section() const;

 private:
  FaceHints face_;
  bool is_empty_;
  uint32_t first_y_ = 0;
  uint32_t first_x_ = 0;
  unsigned code_bits_ = 0;
  std::vector<NumberCode> codes_;  // of each table
};

}  // namespace inkcell::gen
