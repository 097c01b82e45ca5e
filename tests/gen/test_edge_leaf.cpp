// Cells made of candidates: what they say, and that the cheapest is found.
#include <gtest/gtest.h>

#include "edges/leaf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "edge_trees.hpp"
#include "edges/bit_costs.hpp"

namespace inkcell {
namespace gen {
namespace test {
namespace {

constexpr Join kAllJoins[] = {Join::single, Join::min2, Join::max2,
                              Join::min3,   Join::max3, Join::min_max,
                              Join::max_min};

class FieldLeaf : public testing::Test {
 protected:
  double any(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  int whole(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }

  // A field through the square of 64 u at the origin.
  PrimitiveNumbers any_field() {
    const double angle = any(0, 6.2832);
    PrimitiveNumbers field;
    field.nx_q14 = static_cast<int16_t>(std::lround(16384 * std::cos(angle)));
    field.ny_q14 = static_cast<int16_t>(std::lround(16384 * std::sin(angle)));
    const double at = field.nx_q14 / 512.0 + field.ny_q14 / 512.0;
    field.c_q4 = static_cast<int16_t>(std::lround(16 * (any(-20, 20) - at)));
    if (whole(0, 1) == 0) {
      field.bend = static_cast<int16_t>(whole(1, 1500) * (2 * whole(0, 1) - 1));
      field.along_q4 = static_cast<int16_t>(whole(-800, 800));
    }
    return field;
  }

  // A lattice of 9 x 9 in that square.
  static Points lattice() {
    Points points;
    for (int y = 0; y <= 64; y += 8) {
      for (int x = 0; x <= 64; x += 8) {
        points.x.push_back(static_cast<float>(x));
        points.y.push_back(static_cast<float>(y));
        points.d.push_back(0);
        points.low.push_back(0);
        points.high.push_back(0);
        points.weight.push_back(0);
        points.chain.push_back(0);
        points.corner.push_back(-1);
        points.in_band.push_back(true);
        ++points.in_band_count;
      }
    }
    return points;
  }

  static Candidate candidate(const PrimitiveNumbers& field,
                             const Points& points) {
    const Primitive model(field);
    Candidate c;
    c.field = field;
    c.is_arc = is_arc(field);
    c.nx = static_cast<float>(model.nx);
    c.ny = static_cast<float>(model.ny);
    c.passes.resize((points.size() + 63) / 64);
    for (size_t i = 0; i < points.size(); ++i) {
      double gx = 0;
      double gy = 0;
      model.gradient(points.x[i], points.y[i], gx, gy);
      c.value.push_back(
          static_cast<float>(model.value(points.x[i], points.y[i])));
      if (c.is_arc) {
        c.gx.push_back(static_cast<float>(gx));
        c.gy.push_back(static_cast<float>(gy));
      }
      const bool ok =
          c.value[i] >= points.low[i] && c.value[i] <= points.high[i];
      c.passes[i / 64] |= uint64_t{ok} << (i % 64);
    }
    return c;
  }

  std::mt19937 random_{5};
};

TEST_F(FieldLeaf, ValueIsTheOneOfTheDocument) {
  const Points points = lattice();
  size_t rounded = 0;
  size_t compared = 0;
  for (int round = 0; round < 600; ++round) {
    for (const Join join : kAllJoins) {
      std::vector<Candidate> candidates;
      std::vector<Primitive> models;
      for (int i = 0; i < primitive_count(join); ++i) {
        const PrimitiveNumbers field = any_field();
        candidates.push_back(candidate(field, points));
        models.emplace_back(field);
      }
      Leaf leaf;
      leaf.join = join;
      for (size_t i = 0; i < candidates.size(); ++i) {
        leaf.members[i] = &candidates[i];
      }
      for (size_t i = 0; i < points.size(); ++i) {
        const PlainValue plain =
            plain_value(join, models, points.x[i], points.y[i]);
        if (!plain.close_call) {
          ASSERT_NEAR(leaf_value(leaf, i), plain.value, 1e-2)
              << static_cast<int>(join);
          ++compared;
          rounded += plain.rounded ? 1u : 0u;
        }
      }
    }
  }
  EXPECT_GT(compared, 300000u);
  EXPECT_GT(rounded, 10000u);
}

// A corner of a square: what fields say there is the distance.
TEST_F(FieldLeaf, CornersAreRound) {
  Points points = lattice();
  PrimitiveNumbers right;  // inside where x < 32
  right.nx_q14 = -16384;
  right.c_q4 = 32 * 16;
  PrimitiveNumbers upper;
  upper.ny_q14 = -16384;
  upper.c_q4 = 32 * 16;
  const Candidate a = candidate(right, points);
  const Candidate b = candidate(upper, points);
  Leaf leaf;
  leaf.join = Join::min2;
  leaf.members = {&a, &b, nullptr};
  for (size_t i = 0; i < points.size(); ++i) {
    const double dx = points.x[i] - 32;
    const double dy = points.y[i] - 32;
    const double exact =
        dx > 0 && dy > 0 ? -std::hypot(dx, dy) : -std::max(dx, dy);
    EXPECT_NEAR(leaf_value(leaf, i), exact, 1e-3) << dx << ' ' << dy;
  }
}

// What a leaf costs and how its fields lie, said again in plain words.
struct PlainCost {
  double bits = 0;
  std::vector<const Candidate*> order;
};

PlainCost plain_cost(Join join,
                     const std::vector<const Candidate*>& members,
                     int size_log2) {
  PlainCost cost;
  cost.bits =
      kNodeBits[6 - std::max(0, size_log2 - 2)][3 + static_cast<int>(join)];
  std::vector<std::vector<const Candidate*>> groups;
  if (is_nested(join)) {
    groups = {{members[0]}, {members[1], members[2]}};
  } else {
    groups = {members};
  }
  size_t place = 0;
  for (std::vector<const Candidate*>& group : groups) {
    std::stable_sort(group.begin(), group.end(),
                     [](const Candidate* a, const Candidate* b) {
                       const int rank_a = a->is_new ? 100 : a->rank;
                       const int rank_b = b->is_new ? 100 : b->rank;
                       return rank_a < rank_b;
                     });
    for (size_t i = 0; i < group.size(); ++i, ++place) {
      const Candidate& c = *group[i];
      cost.order.push_back(&c);
      const bool after_new = i > 0 && group[i - 1]->is_new;
      const uint8_t* kinds = kKindBits[2 * place + (after_new ? 1 : 0)];
      if (c.is_new) {
        cost.bits += kinds[1 + static_cast<size_t>(c.code.kind)] + c.bits;
      } else {
        const int step = i == 0 ? c.rank : c.rank - group[i - 1]->rank - 1;
        cost.bits += kinds[0] + kRankBits[i == 0 ? 0 : 1][step];
      }
    }
  }
  return cost;
}

// All ways to make a leaf of `candidates`.
template <typename Visit>
void for_all_leaves(const std::vector<Candidate>& candidates, Visit visit) {
  const size_t count = candidates.size();
  for (const Join join : kAllJoins) {
    const bool nested = is_nested(join);
    const int fields = primitive_count(join);
    for (size_t i = 0; i < count; ++i) {
      if (fields == 1) {
        visit(join, std::vector<const Candidate*>{&candidates[i]});
        continue;
      }
      for (size_t j = 0; j < count; ++j) {
        if (j == i || (!nested && j < i)) {
          continue;
        }
        if (fields == 2) {
          visit(join,
                std::vector<const Candidate*>{&candidates[i], &candidates[j]});
          continue;
        }
        for (size_t k = j + 1; k < count; ++k) {
          if (k != i) {
            visit(join, std::vector<const Candidate*>{
                            &candidates[i], &candidates[j], &candidates[k]});
          }
        }
      }
    }
  }
}

TEST_F(FieldLeaf, SearchFindsTheCheapest) {
  int found_of[kJoins] = {};
  int none = 0;
  LeafSearch search;
  for (int round = 0; round < 600; ++round) {
    SCOPED_TRACE(round);
    const int size_log2 = whole(1, 8);
    Points points = lattice();
    std::vector<PrimitiveNumbers> fields;
    for (int i = 0; i < 7; ++i) {
      fields.push_back(any_field());
    }
    // The truth is some combination of the first three.
    const Join truth = kAllJoins[whole(0, kJoins - 1)];
    std::vector<Primitive> models;
    for (int i = 0; i < primitive_count(truth); ++i) {
      models.emplace_back(fields[static_cast<size_t>(i)]);
    }
    const float leeway = static_cast<float>(any(0.5, 6));
    const bool hopeless = round % 10 == 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const PlainValue value =
          plain_value(truth, models, points.x[i], points.y[i]);
      points.d[i] = static_cast<float>(value.value) + (hopeless ? 1000 : 0);
      points.low[i] = points.d[i] - leeway;
      points.high[i] = points.d[i] + leeway;
      points.corner[i] = 0;  // any point may be at a rounded vertex
    }
    std::vector<Candidate> candidates;
    int rank = 0;
    for (size_t i = 0; i < fields.size(); ++i) {
      Candidate c = candidate(fields[i], points);
      c.is_new = whole(0, 1) == 0;
      if (c.is_new) {
        c.code.kind = static_cast<PrimitiveKind>(whole(0, 3));
        c.bits = whole(8, 30);
        c.bonus = whole(0, 3);
      } else {
        c.rank = rank++;
        rank += whole(0, 1);
      }
      candidates.push_back(std::move(c));
    }
    std::shuffle(candidates.begin(), candidates.end(), random_);

    double least = std::numeric_limits<double>::infinity();
    for_all_leaves(candidates, [&](Join join, const auto& members) {
      double value = plain_cost(join, members, size_log2).bits;
      Leaf leaf;
      leaf.join = join;
      for (size_t i = 0; i < members.size(); ++i) {
        leaf.members[i] = members[i];
        value -= members[i]->bonus;
      }
      bool passes = value < least;
      for (size_t i = 0; i < points.size() && passes; ++i) {
        const float v = leaf_value(leaf, i);
        passes = v >= points.low[i] && v <= points.high[i];
      }
      least = passes ? value : least;
    });

    Leaf leaf;
    const bool found = search.find(size_log2, points, candidates, leaf);
    ASSERT_EQ(found, std::isfinite(least));
    ASSERT_EQ(found, !hopeless);
    if (!found) {
      ++none;
      continue;
    }
    ++found_of[static_cast<int>(leaf.join)];
    const auto count = static_cast<size_t>(primitive_count(leaf.join));
    const std::vector<const Candidate*> members(leaf.members.begin(),
                                                leaf.members.begin() + count);
    const PlainCost cost = plain_cost(leaf.join, members, size_log2);
    EXPECT_EQ(leaf.bits, cost.bits);
    EXPECT_EQ(members, cost.order);
    double value = leaf.bits;
    for (const Candidate* member : members) {
      value -= member->bonus;
    }
    EXPECT_EQ(value, least);
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_GE(leaf_value(leaf, i), points.low[i]);
      EXPECT_LE(leaf_value(leaf, i), points.high[i]);
    }
  }
  EXPECT_EQ(none, 60);
  for (const Join join : kAllJoins) {
    EXPECT_GT(found_of[static_cast<int>(join)], 10) << static_cast<int>(join);
  }
}

// Where no corner is nearest, a combination shows one of its fields: what is
// left out for that reason would not have passed.
TEST_F(FieldLeaf, SearchNeedsFieldsThatServeEveryPoint) {
  Points points = lattice();
  PrimitiveNumbers right;
  right.nx_q14 = -16384;
  right.c_q4 = 32 * 16;
  PrimitiveNumbers upper;
  upper.ny_q14 = -16384;
  upper.c_q4 = 32 * 16;
  for (size_t i = 0; i < points.size(); ++i) {
    const double dx = points.x[i] - 32;
    const double dy = points.y[i] - 32;
    const bool corner = dx > 0 && dy > 0;
    points.d[i] =
        static_cast<float>(corner ? -std::hypot(dx, dy) : -std::max(dx, dy));
    points.low[i] = points.d[i] - 0.5f;
    points.high[i] = points.d[i] + 0.5f;
    points.corner[i] = corner ? 0 : -1;
  }
  std::vector<Candidate> candidates = {candidate(right, points),
                                       candidate(upper, points)};
  candidates[1].rank = 1;
  LeafSearch search;
  Leaf leaf;
  ASSERT_TRUE(search.find(6, points, candidates, leaf));
  EXPECT_EQ(leaf.join, Join::min2);
  EXPECT_EQ(leaf.members[0], &candidates[0]);
  EXPECT_EQ(leaf.members[1], &candidates[1]);
  candidates.pop_back();
  EXPECT_FALSE(search.find(6, points, candidates, leaf));
  EXPECT_FALSE(search.find(6, points, {}, leaf));
}

// Two fields keep the limit: the one that costs a bit more is taken if its
// errors are worth it.
TEST_F(FieldLeaf, TruthIsWorthBits) {
  Points points = lattice();
  PrimitiveNumbers true_field;
  true_field.nx_q14 = 16384;
  true_field.c_q4 = -32 * 16;
  PrimitiveNumbers cheap_field = true_field;
  cheap_field.c_q4 = -31 * 16;
  for (size_t i = 0; i < points.size(); ++i) {
    points.d[i] = points.x[i] - 32;
    points.low[i] = points.d[i] - 2;
    points.high[i] = points.d[i] + 2;
  }
  std::vector<Candidate> candidates = {candidate(cheap_field, points),
                                       candidate(true_field, points)};
  candidates[0].is_new = candidates[1].is_new = true;
  candidates[0].bits = 20;
  candidates[1].bits = 21;
  LeafSearch search;
  for (const bool counts : {false, true}) {
    points.weight.assign(points.size(), counts ? 0.1f : 0.0f);
    Leaf leaf;
    ASSERT_TRUE(search.find(6, points, candidates, leaf));
    EXPECT_EQ(leaf.members[0], &candidates[counts ? 1 : 0]);
    EXPECT_EQ(leaf.loss, 0);
    leaf.members[0] = &candidates[0];
    const LeafError error = measure_leaf(leaf, points);
    EXPECT_EQ(error.failed, points.size());
    EXPECT_NEAR(error.squares, counts ? 8.1 : 0, 1e-4);
  }
  points.high[70] = points.d[70] + 0.5f;
  Leaf leaf;
  leaf.members[0] = &candidates[0];
  EXPECT_EQ(measure_leaf(leaf, points).failed, 70u);
}

}  // namespace
}  // namespace test
}  // namespace gen
}  // namespace inkcell
