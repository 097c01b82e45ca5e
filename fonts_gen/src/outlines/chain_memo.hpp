// Chains that were looked for already. The refits of one glyph differ in few
// places: everywhere else they ask for the same chains again.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "outlines/curve_fit.hpp"

namespace inkcell {
namespace gen {

/// 128 bits that stand for a sequence of words and numbers: that two sequences
/// have the same ones is less likely than an error of the machine.
class Fingerprint {
 public:
  void add(uint64_t word);
  void add(double number);
  void add(const Point& point);
  void add(const Fingerprint& other);

  bool operator==(const Fingerprint& other) const {
    return a_ == other.a_ && b_ == other.b_;
  }
  /// For hash tables.
  size_t hash() const { return static_cast<size_t>(a_); }

 private:
  uint64_t a_ = 0;
  uint64_t b_ = 0;
};

class ChainMemo {
 public:
  /// What a search found, which may be no chain; null if it was not made.
  const std::optional<Chain>* find(const Fingerprint& search) const;

  void add(const Fingerprint& search, std::optional<Chain> result);

 private:
  struct Hash {
    size_t operator()(const Fingerprint& search) const { return search.hash(); }
  };
  std::unordered_map<Fingerprint, std::optional<Chain>, Hash> results_;
};

}  // namespace gen
}  // namespace inkcell
