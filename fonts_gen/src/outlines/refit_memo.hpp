// Caches contours and chains between the refits of a glyph, which differ only
// in few places.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include "outlines/curve_fit.hpp"
#include "outlines/minimal_outline.hpp"

namespace inkcell::gen {

/// A hash of 128 bits of a sequence of words and numbers. Collisions are less
/// likely than an error of the machine.
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

/// Results by the fingerprint of everything that they depend on.
template <typename Result>
class Memo {
 public:
  /// Null if it is not in the cache.
  const Result* find(const Fingerprint& question) const {
    const auto found = results_.find(question);
    return found == results_.end() ? nullptr : &found->second;
  }

  void add(const Fingerprint& question, Result result) {
    results_.emplace(question, std::move(result));
  }

 private:
  struct Hash {
    size_t operator()(const Fingerprint& print) const { return print.hash(); }
  };
  std::unordered_map<Fingerprint, Result, Hash> results_;
};

struct RefitMemo {
  Memo<std::optional<Chain>> chains;  // nullopt if no chain is acceptable
  Memo<MinimalContour> contours;
};

}  // namespace inkcell::gen
