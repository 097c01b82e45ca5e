#include "edges/leaf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "edges/bit_costs.hpp"

namespace inkcell {
namespace gen {
namespace {

// Fields whose gradients enclose less are not rounded where they meet.
// [squared sine]
constexpr float kLeastSine2 = 0.022f;

// What an error of the tolerance in a pixel at the largest size may cost. More
// makes truer fonts that are larger.
constexpr double kErrorBits = 8;

FieldValue value_of(const Candidate& c, size_t i) {
  return {c.value[i], c.is_arc ? c.gx[i] : c.nx, c.is_arc ? c.gy[i] : c.ny};
}

// The lesser of two, or the distance to the vertex where they meet.
float least(const FieldValue& a, const FieldValue& b) {
  const float lesser = std::min(a.v, b.v);
  if (lesser >= 0) {
    return lesser;
  }
  const float cosine = a.gx * b.gx + a.gy * b.gy;
  const float from_b = b.v - cosine * a.v;
  const float sine2 = 1 - cosine * cosine;
  if (a.v - cosine * b.v > 0 || from_b > 0 || sine2 < kLeastSine2) {
    return lesser;
  }
  return -std::sqrt(a.v * a.v + from_b * from_b / sine2);
}

FieldValue negated(const FieldValue& a) {
  return {-a.v, -a.gx, -a.gy};
}

float least_of_three(const FieldValue& a,
                     const FieldValue& b,
                     const FieldValue& c) {
  if (c.v >= a.v && c.v >= b.v) {
    return least(a, b);
  }
  return b.v >= a.v ? least(a, c) : least(b, c);
}

// Bits of the fields of a group; puts them into the order of the stream:
// reused ones by rank, then new ones.
double order_group(const Candidate** members, int count, int place) {
  std::sort(members, members + count,
            [](const Candidate* a, const Candidate* b) {
              return a->is_new != b->is_new ? !a->is_new : a->rank < b->rank;
            });
  double bits = 0;
  int previous = -1;
  bool after_new = false;
  for (int i = 0; i < count; ++i) {
    const Candidate& c = *members[i];
    if (c.is_new) {
      bits += kind_bits(place + i, after_new,
                        kind_symbol::kNew + static_cast<int>(c.code.kind)) +
              c.bits;
    } else {
      bits += kind_bits(place + i, after_new, kind_symbol::kReuse) +
              rank_bits(i == 0, c.rank - previous - 1);
      previous = c.rank;
    }
    after_new = c.is_new;
  }
  return bits;
}

double order_leaf(Leaf& leaf, int size_log2) {
  const Candidate** members = leaf.members.data();
  const double bits =
      node_bits(size_log2, node_symbol::kJoin + static_cast<int>(leaf.join));
  if (is_nested(leaf.join)) {
    return bits + order_group(members, 1, 0) + order_group(members + 1, 2, 1);
  }
  return bits + order_group(members, primitive_count(leaf.join), 0);
}

}  // namespace

float join_values(Join join, const std::array<FieldValue, 3>& fields) {
  if (join == Join::single) {
    return fields[0].v;
  }
  const bool greatest = takes_greatest(join);
  const float sign = greatest ? -1.0f : 1.0f;
  const FieldValue a = greatest ? negated(fields[0]) : fields[0];
  const FieldValue b = greatest ? negated(fields[1]) : fields[1];
  if (primitive_count(join) == 2) {
    return sign * least(a, b);
  }
  const FieldValue c = greatest ? negated(fields[2]) : fields[2];
  if (join == Join::min3 || join == Join::max3) {
    return sign * least_of_three(a, b, c);
  }
  FieldValue inner = b.v >= c.v ? b : c;
  inner.v = -least(negated(b), negated(c));
  return sign * least(a, inner);
}

float leaf_value(const Leaf& leaf, size_t i) {
  std::array<FieldValue, 3> values;
  for (size_t m = 0; m < static_cast<size_t>(primitive_count(leaf.join)); ++m) {
    values[m] = value_of(*leaf.members[m], i);
  }
  return join_values(leaf.join, values);
}

LeafError measure_leaf(const Leaf& leaf, const Points& points) {
  LeafError error;
  for (size_t i = 0; i < points.size(); ++i) {
    const float v = leaf_value(leaf, i);
    if (!points.keeps_limit(i, v)) {
      error.failed = i;
      return error;
    }
    const float miss = v - points.d[i];
    error.squares += static_cast<double>(points.weight[i] * miss * miss);
  }
  error.failed = points.size();
  return error;
}

bool LeafSearch::fails_again(const Leaf& leaf) const {
  for (const size_t i : hot_) {
    if (i < points_->size() && !points_->keeps_limit(i, leaf_value(leaf, i))) {
      return true;
    }
  }
  return false;
}

void LeafSearch::attempt(Join join,
                         const Candidate& a,
                         const Candidate* b,
                         const Candidate* c) {
  Leaf leaf;
  leaf.join = join;
  leaf.members = {&a, b, c};
  leaf.bits = order_leaf(leaf, size_log2_);
  double value = leaf.bits;
  for (const Candidate* member : leaf.members) {
    value -= member != nullptr ? member->bonus : 0;
  }
  if (value >= best_value_ || fails_again(leaf)) {
    return;
  }
  const LeafError error = measure_leaf(leaf, *points_);
  if (error.failed < points_->size()) {
    hot_[next_hot_] = error.failed;
    next_hot_ = (next_hot_ + 1) % hot_.size();
    return;
  }
  leaf.loss = kErrorBits * error.squares;
  if (value + leaf.loss < best_value_) {
    best_ = leaf;
    best_value_ = value + leaf.loss;
    found_ = true;
  }
}

// What a field adds to the value of any leaf, at least.
double LeafSearch::least_value(const Candidate& c) {
  constexpr double kLeastSymbol = 1;
  return c.is_new ? kLeastSymbol + c.bits - c.bonus : 2 * kLeastSymbol;
}

void LeafSearch::attempt_triples(const Candidate& a,
                                 const Candidate& b,
                                 const Candidate& c) {
  attempt(Join::min3, a, &b, &c);
  attempt(Join::max3, a, &b, &c);
  for (const Join join : {Join::min_max, Join::max_min}) {
    attempt(join, a, &b, &c);
    attempt(join, b, &a, &c);
    attempt(join, c, &a, &b);
  }
}

// Every combination says at each point what one of its fields says there, but
// at rounded vertices. So its fields together must pass everywhere else.
bool LeafSearch::find(int size_log2,
                      const Points& points,
                      const std::vector<Candidate>& candidates,
                      Leaf& out) {
  size_log2_ = size_log2;
  points_ = &points;
  best_value_ = std::numeric_limits<double>::infinity();
  found_ = false;
  const size_t words = (points.size() + 63) / 64;
  std::vector<uint64_t> needed(words);
  for (size_t i = 0; i < points.size(); ++i) {
    needed[i / 64] |= uint64_t{points.corner[i] < 0} << (i % 64);
  }
  // Takes what `c` serves out of `from`; true if nothing is left.
  const auto served = [&](const std::vector<uint64_t>& from, const Candidate& c,
                          std::vector<uint64_t>& rest) {
    uint64_t any = 0;
    for (size_t w = 0; w < words; ++w) {
      rest[w] = from[w] & ~c.passes[w];
      any |= rest[w];
    }
    return any == 0;
  };
  std::vector<uint64_t> after_a(words);
  std::vector<uint64_t> after_b(words);
  std::vector<uint64_t> after_c(words);
  const size_t count = candidates.size();
  for (size_t i = 0; i < count; ++i) {
    if (served(needed, candidates[i], after_a)) {
      attempt(Join::single, candidates[i], nullptr, nullptr);
    }
  }
  for (size_t i = 0; i < count; ++i) {
    const Candidate& a = candidates[i];
    served(needed, a, after_a);
    for (size_t j = i + 1; j < count; ++j) {
      const Candidate& b = candidates[j];
      const double of_two = least_value(a) + least_value(b);
      const bool all = served(after_a, b, after_b);
      if (all && of_two < best_value_) {
        attempt(Join::min2, a, &b, nullptr);
        attempt(Join::max2, a, &b, nullptr);
      }
      for (size_t k = j + 1; k < count; ++k) {
        const Candidate& c = candidates[k];
        if (of_two + least_value(c) < best_value_ &&
            served(after_b, c, after_c)) {
          attempt_triples(a, b, c);
        }
      }
    }
  }
  out = best_;
  return found_;
}

}  // namespace gen
}  // namespace inkcell
