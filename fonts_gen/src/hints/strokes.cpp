#include "hints/strokes.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell::gen {
namespace {

// Thinner pairs of edges are none. [u]
constexpr double kThinnest = 5;

// Facing edges overlap by at least this length [u], or this share of the
// shorter one: inner edges of serifs are split by their stems, those of bends
// are short.
constexpr double kLeastFacing = 15;
constexpr double kLeastFacingShare = 0.13;

// Pairs with a longer overlap are preferred, as if nearer by this share of its
// length, up to kMostFacing. [u]
constexpr double kFacingMerit = 0.12;
constexpr double kMostFacing = 200;

// A spine keeps this distance from other bars. [u]
constexpr double kSpineGap = 20;

// Straight stems are this many times longer than wide.
constexpr double kLeastStemShape = 0.9;

// Strokes that lean more have no position across. [u]
constexpr double kMostLean = 11;

// A straight stem shorter than this share of the longest one is the end of an
// arm, as in E.
constexpr double kLeastStemShare = 0.4;

struct Pair {
  double cost;
  double facing;
  size_t low;
  size_t high;
};

std::vector<Pair> find_pairs(const std::vector<StrokeEdge>& edges) {
  std::vector<Pair> pairs;
  for (size_t i = 0; i < edges.size(); ++i) {
    for (size_t j = 0; j < edges.size(); ++j) {
      const double width = edges[j].position - edges[i].position;
      if (!edges[i].ink_beyond || edges[j].ink_beyond || width <= kThinnest ||
          width > kThickestStroke) {
        continue;
      }
      const double facing = overlap(edges[i].pieces, edges[j].pieces);
      const double shorter = std::min(edges[i].length(), edges[j].length());
      if (facing >= kLeastFacing || facing >= kLeastFacingShare * shorter) {
        pairs.push_back({width - kFacingMerit * std::min(facing, kMostFacing),
                         facing, i, j});
      }
    }
  }
  std::stable_sort(
      pairs.begin(), pairs.end(),
      [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
  return pairs;
}

double common_lean(const StrokeEdge& a, const StrokeEdge& b) {
  const double less = std::abs(a.lean) < std::abs(b.lean) ? a.lean : b.lean;
  return a.lean * b.lean > 0 ? less : 0;
}

void sort_by_position(std::vector<Stroke>& strokes) {
  std::stable_sort(
      strokes.begin(), strokes.end(),
      [](const Stroke& a, const Stroke& b) { return a.low < b.low; });
}

}  // namespace

Strokes pair_edges(const std::vector<StrokeEdge>& edges) {
  Strokes result;
  std::vector<bool> used(edges.size());
  for (const Pair& pair : find_pairs(edges)) {
    if (used[pair.low] || used[pair.high]) {
      continue;
    }
    used[pair.low] = true;
    used[pair.high] = true;
    const StrokeEdge& low = edges[pair.low];
    const StrokeEdge& high = edges[pair.high];
    result.strokes.push_back({low.position, high.position, Stroke::Kind::plain,
                              low.is_round && high.is_round,
                              common_lean(low, high), pair.facing, low.pieces,
                              high.pieces});
  }
  sort_by_position(result.strokes);
  for (size_t i = 0; i < edges.size(); ++i) {
    if (!used[i]) {
      result.lone.push_back(edges[i]);
    }
  }
  return result;
}

Strokes find_bars(const Border& border) {
  Strokes bars = pair_edges(find_edges(border, Axis::y));
  // Without bars above and below there are no counters to preserve.
  if (bars.strokes.size() < 2) {
    return bars;
  }
  const std::vector<Stroke> spines =
      pair_edges(find_spine_edges(border, Axis::y)).strokes;
  for (Stroke spine : spines) {
    const bool is_free = std::all_of(
        bars.strokes.begin(), bars.strokes.end(), [&](const Stroke& bar) {
          return spine.low >= bar.high + kSpineGap ||
                 spine.high <= bar.low - kSpineGap;
        });
    if (is_free) {
      spine.kind = Stroke::Kind::spine;
      bars.strokes.push_back(spine);
    }
  }
  sort_by_position(bars.strokes);
  return bars;
}

std::vector<Stroke> find_stems(const Border& border) {
  std::vector<Stroke> stems = pair_edges(find_edges(border, Axis::x)).strokes;
  double longest = 0;
  for (const Stroke& stem : stems) {
    longest = std::max(longest, stem.facing);
  }
  const auto is_none = [longest](const Stroke& stem) {
    const bool is_end = stem.facing < kLeastStemShape * stem.width() ||
                        stem.facing < kLeastStemShare * longest;
    return (!stem.is_round && is_end) || std::abs(stem.lean) > kMostLean;
  };
  stems.erase(std::remove_if(stems.begin(), stems.end(), is_none), stems.end());
  return stems;
}

}  // namespace inkcell::gen
