// Symbols of a code that become one: fewer words, and wider numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "outlines/outline_code.hpp"

namespace inkcell::gen {

/// A symbol and how many steps it writes.
struct Share {
  CodeSymbol symbol;
  uint64_t count;
};

/// Bits of a step's numbers that follow the word.
int number_bits(const CodeSymbol& symbol);

/// Symbols of points by class; those of different classes are not joined.
class SymbolShares {
 public:
  explicit SymbolShares(const ClassCounts& counts);

  /// Class by class.
  std::vector<Share> all() const;

  /// Joins the two symbols that lose least entropy. False: there are none.
  bool join_two();

 private:
  static constexpr int64_t kNoPair = std::numeric_limits<int64_t>::max();

  struct Class {
    std::vector<Share> shares;
    int64_t least_loss = kNoPair;
    size_t first = 0;  // the pair with this loss
    size_t second = 0;

    void find_pair();
  };

  std::array<Class, kStepClasses> classes_;
};

}  // namespace inkcell::gen
