#include "hints/glyph_hints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace grid = format::grid;

using Height = HeightHint::Kind;

// A serif that is thinner than the standard bar by at most this gets the same
// thickness: both keep it or vanish together. [u]
constexpr double kThinnerSerif = 14;

// A row of pixels at the smallest size, 8 px. [u]
constexpr double kRow = 128;

constexpr double kMuchLonger = 2;

// The least gap between stems on one map. [u]
constexpr double kStemGap = 10;

// The leftmost and the rightmost ink are knots as well.
constexpr size_t kMostStems = (grid::kMaxKnots - 2) / 2;

// A hint that may be dropped; the least important one goes first.
struct Candidate {
  double low = 0;
  double high = 0;
  double importance = 0;
  HeightHint hint;
};

bool fits_position(double position) {
  return position >= grid::kPositionBase &&
         position <= grid::kPositionBase +
                         grid::kPositionStep * int{grid::kPositionMask};
}

int rounded(double value) {
  constexpr int kStep = grid::kPositionStep;
  return kStep * static_cast<int>(std::lround(value / kStep));
}

std::optional<int> stored_width(double width, int standard_u) {
  if (standard_u > 0 && std::abs(width - standard_u) <= kSameWidth) {
    return {};
  }
  constexpr int kStep = grid::kPositionStep;
  return std::clamp(rounded(width), kStep, kStep * int{grid::kWidthMask});
}

HeightHint bar_hint(const Stroke& bar, const FaceHints& face) {
  const std::optional<ZoneEdge> bottom = zone_of(face, bar.low, false);
  const std::optional<ZoneEdge> top = zone_of(face, bar.high, true);
  HeightHint hint;
  hint.kind = bar.kind == Stroke::Kind::serif ? Height::serif : Height::bar;
  hint.is_top_edge = !bottom && top;
  hint.edge.zone = hint.is_top_edge ? top : bottom;
  hint.edge.position_u = rounded(bar.low);
  const bool is_standard_serif =
      hint.kind == Height::serif && bar.width() <= face.bar_width_u &&
      bar.width() + kThinnerSerif >= face.bar_width_u;
  if (!is_standard_serif) {
    hint.width_u = stored_width(bar.width(), face.bar_width_u);
  }
  return hint;
}

// Whether the end may close an opening of one row: the counter between its bars
// is low, or the end is close to the opposite bar. Fitting bars may cost the
// counter a row.
bool may_close(const FreeEnd& end, const std::vector<Stroke>& bars) {
  double below = -HUGE_VAL;
  double above = HUGE_VAL;
  for (const Stroke& bar : bars) {
    if (bar.high < end.y) {
      below = std::max(below, bar.high);
    }
    if (bar.low > end.y) {
      above = std::min(above, bar.low);
    }
  }
  const double counter = above - below;
  const double opening = end.rises ? above - end.y : end.y - below;
  return opening / counter * (counter / kRow - 1) < 1;
}

// Parts that became bars keep the edges that were found before.
bool ends_bar(double y, const std::vector<Stroke>& bars) {
  return std::any_of(bars.begin(), bars.end(), [y](const Stroke& bar) {
    return rounded(bar.low) == rounded(y) || rounded(bar.high) == rounded(y);
  });
}

// Importance: bars in zones, edges in zones, bars by length, free ends.
constexpr double kOfZone = 1e6;
constexpr double kOfLoneEdge = 1e5;
constexpr double kOfBar = 1e3;

std::vector<Candidate> height_candidates(const GlyphFeatures& features,
                                         const FaceHints& face) {
  std::vector<Candidate> candidates;
  for (const Stroke& bar : features.bars) {
    const HeightHint hint = bar_hint(bar, face);
    if (hint.edge.zone || fits_position(bar.low)) {
      candidates.push_back({bar.low, bar.high,
                            (hint.edge.zone ? kOfZone : kOfBar) + bar.facing,
                            hint});
    }
  }
  for (const StrokeEdge& edge : features.lone_edges) {
    const std::optional<ZoneEdge> zone =
        zone_of(face, edge.position, !edge.ink_beyond);
    if (zone && !ends_bar(edge.position, features.bars)) {
      HeightHint hint;
      hint.kind = Height::lone_edge;
      hint.edge.zone = zone;
      candidates.push_back(
          {edge.position, edge.position, kOfLoneEdge + edge.length(), hint});
    }
  }
  for (const FreeEnd& end : features.ends) {
    if (fits_position(end.y) && may_close(end, features.bars)) {
      HeightHint hint;
      hint.kind = Height::free_end;
      hint.edge.position_u = rounded(end.y);
      hint.rises = end.rises;
      candidates.push_back({end.y, end.y, 0, hint});
    }
  }
  return candidates;
}

bool is_bar(const Candidate& candidate) {
  return candidate.hint.kind == Height::bar ||
         candidate.hint.kind == Height::serif;
}

// If bars share rows, they are side by side: keeps the most important one.
void resolve_bars(std::vector<Candidate>& candidates) {
  const auto is_worse = [&candidates](const Candidate& bar) {
    return is_bar(bar) &&
           std::any_of(candidates.begin(), candidates.end(),
                       [&bar](const Candidate& other) {
                         return is_bar(other) && other.low < bar.high &&
                                bar.low < other.high &&
                                (other.importance > bar.importance ||
                                 (other.importance == bar.importance &&
                                  other.low < bar.low));
                       });
  };
  std::vector<Candidate> kept;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(kept),
               [&](const Candidate& each) { return !is_worse(each); });
  candidates = std::move(kept);
}

size_t knots_of(const std::vector<Candidate>& candidates) {
  size_t knots = 0;
  for (const Candidate& candidate : candidates) {
    knots += is_bar(candidate) ? 2u : 1u;
  }
  return knots;
}

// The lower edge as stored.
int lower_edge(const HeightHint& hint, const FaceHints& face) {
  const bool is_bar = hint.kind == Height::bar || hint.kind == Height::serif;
  return is_bar ? edges_of(hint, face)[0] : height_of(hint.edge, face);
}

std::vector<HeightHint> choose_heights(std::vector<Candidate> candidates,
                                       const FaceHints& face) {
  resolve_bars(candidates);
  while (knots_of(candidates) > grid::kMaxKnots) {
    candidates.erase(
        std::min_element(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) {
                           return a.importance < b.importance;
                         }));
  }
  std::vector<HeightHint> heights;
  for (const Candidate& candidate : candidates) {
    heights.push_back(candidate.hint);
  }
  std::stable_sort(heights.begin(), heights.end(),
                   [&face](const HeightHint& a, const HeightHint& b) {
                     return lower_edge(a, face) < lower_edge(b, face);
                   });
  return heights;
}

// If stems share columns, they are at different heights: keeps the bowl that is
// farther from the middle, else the one that is much longer.
std::vector<Stroke> resolve_stems(const std::vector<Stroke>& stems,
                                  double middle) {
  std::vector<Stroke> kept;
  for (const Stroke& stem : stems) {
    if (!fits_position(stem.low)) {
      continue;
    }
    if (kept.empty() || stem.low >= kept.back().high + kStemGap) {
      kept.push_back(stem);
    } else {
      const Stroke& last = kept.back();
      const bool are_bowls = stem.is_round && last.is_round;
      const bool is_outer = stem.middle() > middle && stem.high > last.high;
      const bool is_shorter = stem.facing * kMuchLonger < last.facing;
      if (are_bowls ? is_outer
                    : stem.facing > kMuchLonger * last.facing ||
                          (is_outer && !is_shorter)) {
        kept.back() = stem;
      }
    }
  }
  while (kept.size() > kMostStems) {
    kept.erase(std::min_element(
        kept.begin(), kept.end(),
        [](const Stroke& a, const Stroke& b) { return a.facing < b.facing; }));
  }
  return kept;
}

// Smaller insets are not worth their bits. [u]
constexpr double kLeastInset = 8;

int inset(double distance) {
  constexpr int kMost = grid::kPositionStep * ((1 << grid::kInsetBits) - 1);
  return std::clamp(rounded(distance), 0, kMost);
}

}  // namespace

GlyphHints make_glyph_hints(const GlyphFeatures& features,
                            const FaceHints& face,
                            const Interval& box) {
  GlyphHints hints;
  if (!features.has_ink) {
    return hints;
  }
  hints.is_symmetric = features.is_symmetric;
  const double left = features.body.low - box.low;
  const double right = box.high - features.body.high;
  if (std::max(left, right) >= kLeastInset) {
    hints.left_inset_u = inset(left);
    hints.right_inset_u = inset(right);
  }
  hints.heights = choose_heights(height_candidates(features, face), face);
  for (const Stroke& stem :
       resolve_stems(features.stems, features.body.middle())) {
    StemHint hint;
    hint.position_u = rounded(stem.low);
    hint.width_u = stored_width(stem.width(), face.stem_width_u);
    hints.stems.push_back(hint);
  }
  return hints;
}

int height_of(const EdgeHint& edge, const FaceHints& face) {
  if (!edge.zone) {
    return edge.position_u;
  }
  const HintZone& zone = face.zones[edge.zone->zone];
  return zone.flat_u + (edge.zone->is_round ? zone.overshoot_u : 0);
}

std::array<int, 2> edges_of(const HeightHint& bar, const FaceHints& face) {
  const int stored = height_of(bar.edge, face);
  const int width = bar.width_u.value_or(face.bar_width_u);
  return bar.is_top_edge ? std::array<int, 2>{stored - width, stored}
                         : std::array<int, 2>{stored, stored + width};
}

}  // namespace inkcell::gen
