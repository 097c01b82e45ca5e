// The cheapest way to make a cell of some of its candidates.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "edges/candidates.hpp"
#include "edges/model.hpp"
#include "edges/points.hpp"

namespace inkcell {
namespace gen {

/// A cell made of fields; members in the order of the stream.
struct Leaf {
  Join join = Join::single;
  std::array<const Candidate*, 3> members{};
  double bits = 0;  // with the symbol of the square
  double loss = 0;  // what its errors are worth [bits]
};

/// A field at a point: distance [u] and gradient.
struct FieldValue {
  float v = 0;
  float gx = 0;
  float gy = 0;
};

/// Up to three fields joined, primitive_count(join) of them: docs/FORMAT.md,
/// "The value of a cell", in real numbers. [u]
float join_values(Join join, const std::array<FieldValue, 3>& fields);

/// What the leaf says at point `i`. [u]
float leaf_value(const Leaf& leaf, size_t i);

/// How far a leaf is from the truth.
struct LeafError {
  double squares = 0;  // their sum, as Points::weight has it
  size_t failed = 0;   // the first point that misses the limit; size() if none
};

/// `squares` is that of the points before `failed`.
LeafError measure_leaf(const Leaf& leaf, const Points& points);

class LeafSearch {
 public:
  /// The leaf with the least bits and loss less bonus among all single
  /// candidates, pairs and triples, in every combination, that keep the limit
  /// at all points. False if there is none. `out` refers to `candidates`.
  bool find(int size_log2,
            const Points& points,
            const std::vector<Candidate>& candidates,
            Leaf& out);

 private:
  void attempt(Join join,
               const Candidate& a,
               const Candidate* b,
               const Candidate* c);
  void attempt_triples(const Candidate& a,
                       const Candidate& b,
                       const Candidate& c);
  static double least_value(const Candidate& c);
  bool fails_again(const Leaf& leaf) const;

  int size_log2_ = 0;
  const Points* points_ = nullptr;
  Leaf best_;
  double best_value_ = 0;
  bool found_ = false;
  // Points at which combinations failed lately: the next one may fail there.
  std::array<size_t, 8> hot_{};
  size_t next_hot_ = 0;
};

}  // namespace gen
}  // namespace inkcell
