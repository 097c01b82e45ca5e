#include "morph/find_morph.hpp"

#include <algorithm>
#include <utility>

#include "morph/match_loops.hpp"
#include "morph/morph_loop.hpp"
#include "morph/slits.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// An outer contour and its holes.
struct Body {
  Loop outer;
  std::vector<Loop> holes;
};

// What a hole becomes: a hole of the other body by its number, or one of these.
constexpr int kJoined = -1;  // a part of the outer contour, by a cut
constexpr int kSlit = -2;    // nothing, by way of a slit
using Fates = std::vector<int>;

using Fars = std::vector<double>;
const Fars kFewFars_u = {kUsualFar_u, 140, 500, 1000};
const Fars kMoreFars_u = {60, 80, 110, 180, 350, 700, 1500, 2500};
constexpr size_t kMostCuts = 16;
// Trials that are matched with care: some at once, more if none is good.
constexpr size_t kFewTrials = 10;
constexpr size_t kMostTrials = 40;
constexpr size_t kMostRepaired = 12;
constexpr size_t kMostJudged = 40;
constexpr int kMostRepairs = 16;
// More holes become slits.
constexpr size_t kMostHoles = 3;

double priced(const MorphPair& pair) {
  double sum = 0;
  for (const MorphContour& contour : pair.contours) {
    for (const MorphPiece& piece : contour.pieces) {
      sum += piece_cost(piece.side[0].p, piece.side[1].p, kUsualFar_u);
    }
  }
  return sum;
}

struct Plan {
  MorphPair pair;
  MorphQuality quality;
  double cost = 0;
  // What it came from, to try again.
  Loop outer[2];
  double far_u = 0;

  bool is_good() const { return quality.is_within(kGoodAreaError); }
  bool is_usable() const { return quality.is_within(kMostAreaError); }
};

void judge(Plan& plan) {
  constexpr double kCrossing = 400;
  constexpr double kAreaError = 15000;
  plan.quality = quality_of(plan.pair);
  plan.cost = priced(plan.pair) +
              kCrossing * static_cast<double>(plan.quality.crossings.size()) +
              kAreaError * std::max(0.0, plan.quality.area_error - 0.02);
}

void judge_thickness(Plan& plan) {
  constexpr double kThickening = 6000;
  plan.cost += kThickening * std::max(0.0, thickening_of(plan.pair) - 1.1);
}

bool is_better(const Plan& a, const Plan& b) {
  if (a.is_good() != b.is_good()) {
    return a.is_good();
  }
  return a.is_usable() != b.is_usable() ? a.is_usable() : a.cost < b.cost;
}

double perimeter_of(const Loop& loop) {
  double sum = 0;
  for (const LoopEdge& edge : loop) {
    sum += length_of(edge.p);
  }
  return sum;
}

// Tries all fates of the holes of two bodies.
class BodyMorph {
 public:
  BodyMorph(const Body& a, const Body& b) : bodies_{&a, &b} {
    for (size_t k = 0; k < 2; ++k) {
      loops_[k] = bodies_[k]->holes;
      loops_[k].insert(loops_[k].begin(), bodies_[k]->outer);
      fates_[k].assign(bodies_[k]->holes.size(), kSlit);
    }
    for (const Loop& first : a.holes) {
      for (const Loop& second : b.holes) {
        matches_.push_back(match_loops(first, second, {}));
      }
    }
  }

  // The best plan first.
  std::vector<Plan> find() {
    choose_first(0);
    std::stable_sort(
        trials_.begin(), trials_.end(),
        [](const Trial& a, const Trial& b) { return a.cost < b.cost; });
    const auto has_good = [this] {
      return std::any_of(plans_.begin(), plans_.end(),
                         [](const Plan& plan) { return plan.is_good(); });
    };
    for (size_t i = 0; i < trials_.size() && i < kMostTrials; ++i) {
      if (i % kFewTrials == 0 && has_good()) {
        break;
      }
      plan(trials_[i], kFewFars_u);
    }
    for (size_t i = 0; i < trials_.size() && i < kFewTrials; ++i) {
      if (has_good()) {
        break;
      }
      plan(trials_[i], kMoreFars_u);
    }
    std::stable_sort(plans_.begin(), plans_.end(), is_better);
    if (!has_good()) {
      repair();
      std::stable_sort(plans_.begin(), plans_.end(), is_better);
    }
    plans_.resize(std::min(plans_.size(), kMostJudged));
    for (Plan& plan : plans_) {
      judge_thickness(plan);
    }
    std::stable_sort(plans_.begin(), plans_.end(), is_better);
    return std::move(plans_);
  }

 private:
  // Fates of all holes, and the outer contours with those that are joined.
  struct Trial {
    Fates fates[2];
    Loop outer[2];
    double cost = 0;  // roughly
  };

  const Loop& hole(size_t body, size_t i) const {
    return bodies_[body]->holes[i];
  }
  const LoopMatch& match_of(size_t first, int second) const {
    return matches_[first * bodies_[1]->holes.size() +
                    static_cast<size_t>(second)];
  }

  size_t count_of(int fate, size_t body) const {
    return static_cast<size_t>(
        std::count(fates_[body].begin(), fates_[body].end(), fate));
  }

  void choose_first(size_t i) {
    if (i == fates_[0].size()) {
      std::fill(fates_[1].begin(), fates_[1].end(), kJoined);
      for (size_t k = 0; k < i; ++k) {
        if (fates_[0][k] >= 0) {
          fates_[1][static_cast<size_t>(fates_[0][k])] = static_cast<int>(k);
        }
      }
      choose_second(0);
      return;
    }
    const auto count = static_cast<int>(std::min(fates_[1].size(), kMostHoles));
    const int last = i < kMostHoles ? count : kSlit + 1;
    for (int fate = kSlit; fate < last; ++fate) {
      const auto end = fates_[0].begin() + static_cast<ptrdiff_t>(i);
      if (fate < 0 || std::find(fates_[0].begin(), end, fate) == end) {
        fates_[0][i] = fate;
        choose_first(i + 1);
      }
    }
  }

  void choose_second(size_t i) {
    if (i == fates_[1].size()) {
      // Rather one hole that moves than two slits.
      if (count_of(kSlit, 0) * count_of(kSlit, 1) == 0) {
        add_trials();
      }
      return;
    }
    if (fates_[1][i] >= 0) {
      choose_second(i + 1);
      return;
    }
    for (const int fate : {kSlit, kJoined}) {
      if (fate == kSlit || i < kMostHoles) {
        fates_[1][i] = fate;
        choose_second(i + 1);
      }
    }
    fates_[1][i] = kJoined;
  }

  // The outer contours with the holes that are joined to them, by many cuts.
  void add_trials() {
    std::vector<Trial> all(1);
    Trial& first = all.front();
    double holes = 0;
    for (size_t k = 0; k < 2; ++k) {
      first.fates[k] = fates_[k];
      first.outer[k] = bodies_[k]->outer;
      for (size_t i = 0; i < fates_[k].size(); ++i) {
        if (fates_[k][i] == kSlit) {
          holes += 2 * perimeter_of(hole(k, i));
        } else if (k == 0 && fates_[k][i] >= 0) {
          holes += match_of(i, fates_[k][i]).cost;
        }
      }
    }
    MatchOptions quick;
    quick.parts = 1;
    first.cost = match_loops(first.outer[0], first.outer[1], quick).cost;
    for (size_t k = 0; k < 2; ++k) {
      for (size_t i = 0; i < fates_[k].size(); ++i) {
        if (fates_[k][i] != kJoined) {
          continue;
        }
        std::vector<Trial> next;
        for (const Trial& trial : all) {
          for (const Bridge& bridge :
               bridges_between(trial.outer[k], hole(k, i))) {
            Trial made = trial;
            made.outer[k] = joined(trial.outer[k], hole(k, i), bridge);
            made.cost = match_loops(made.outer[0], made.outer[1], quick).cost;
            next.push_back(std::move(made));
          }
        }
        std::stable_sort(
            next.begin(), next.end(),
            [](const Trial& a, const Trial& b) { return a.cost < b.cost; });
        next.resize(std::min(next.size(), kMostCuts));
        all = std::move(next);
      }
    }
    for (Trial& trial : all) {
      trial.cost += holes;
      trials_.push_back(std::move(trial));
    }
  }

  void plan(const Trial& trial, const Fars& fars_u) {
    for (const double far_u : fars_u) {
      Plan plan;
      plan.outer[0] = trial.outer[0];
      plan.outer[1] = trial.outer[1];
      plan.far_u = far_u;
      MatchOptions options;
      options.far_u = far_u;
      std::vector<MorphContour>& contours = plan.pair.contours;
      contours.push_back(
          match_loops(trial.outer[0], trial.outer[1], options).contour);
      for (size_t i = 0; i < trial.fates[0].size(); ++i) {
        if (trial.fates[0][i] >= 0) {
          contours.push_back(match_of(i, trial.fates[0][i]).contour);
        }
      }
      if (open_slits(trial, plan.pair)) {
        judge(plan);
        plans_.push_back(std::move(plan));
      }
    }
  }

  // Holes that open as slits: those that cross least. False: there is no room.
  bool open_slits(const Trial& trial, MorphPair& pair) const {
    for (size_t k = 0; k < 2; ++k) {
      for (size_t i = 0; i < trial.fates[k].size(); ++i) {
        if (trial.fates[k][i] != kSlit) {
          continue;
        }
        const auto slits =
            slits_for(hole(k, i), loops_[1 - k], static_cast<int>(1 - k));
        size_t least = SIZE_MAX;
        MorphPair best;
        for (const MorphContour& slit : slits) {
          MorphPair with = pair;
          with.contours.push_back(slit);
          const size_t crossings = quality_of(with).crossings.size();
          if (crossings < least) {
            least = crossings;
            best = std::move(with);
          }
          if (least == 0) {
            break;
          }
        }
        if (least == SIZE_MAX) {
          return false;
        }
        pair = std::move(best);
      }
    }
    return true;
  }

  // Matches outer contours again where pieces crossed, at other stops.
  void repair() {
    constexpr double kPenalty = 30;
    const size_t count = std::min(plans_.size(), kMostRepaired);
    for (size_t i = 0; i < count; ++i) {
      Plan plan = plans_[i];
      MatchOptions options;
      options.far_u = plan.far_u;
      for (int round = 0; round < kMostRepairs && !plan.is_good(); ++round) {
        for (const MorphCrossing& crossing : plan.quality.crossings) {
          for (size_t k = 0; k < 2; ++k) {
            if (crossing.contour[k] == 0) {
              const MorphPiece& piece =
                  plan.pair.contours[0].pieces[crossing.piece[k]];
              options.penalties.push_back(
                  {{piece.stop[0], piece.stop[1]}, kPenalty});
            }
          }
        }
        if (plan.quality.crossings.empty()) {
          break;  // the area is wrong, not the stops
        }
        plan.pair.contours[0] =
            match_loops(plan.outer[0], plan.outer[1], options).contour;
        judge(plan);
        if (is_better(plan, plans_[i])) {
          plans_[i] = plan;
        }
      }
    }
  }

  const Body* bodies_[2];
  std::vector<Loop> loops_[2];      // the outer contour first
  std::vector<LoopMatch> matches_;  // of each hole with each
  Fates fates_[2];
  std::vector<Trial> trials_;
  std::vector<Plan> plans_;
};

MorphPolygons polygon_of(const Loop& loop) {
  MorphPolygons out(1);
  for (const LoopEdge& edge : loop) {
    for (int i = 0; i < 4; ++i) {
      out[0].push_back(point_at(edge.p, i / 4.0));
    }
  }
  return out;
}

std::vector<Body> bodies_of(const Outline& outline) {
  std::vector<Body> bodies;
  std::vector<Loop> holes;
  for (Loop& loop : loops_of(outline)) {
    if (area_of(loop) > 0) {
      bodies.push_back({std::move(loop), {}});
    } else {
      holes.push_back(std::move(loop));
    }
  }
  for (Loop& hole : holes) {
    Body* owner = nullptr;
    for (Body& body : bodies) {
      if (depth_at(polygon_of(body.outer), hole.front().p[0]) > 0 &&
          (owner == nullptr || area_of(body.outer) < area_of(owner->outer))) {
        owner = &body;
      }
    }
    if (owner != nullptr) {
      owner->holes.push_back(std::move(hole));
    }
  }
  return bodies;
}

// Joins the two bodies that are nearest to each other: they split on the way.
void join_nearest(std::vector<Body>& bodies) {
  Bridge best;
  best.length = kInfinity;
  size_t from = 0;
  size_t to = 0;
  for (size_t i = 0; i < bodies.size(); ++i) {
    for (size_t j = i + 1; j < bodies.size(); ++j) {
      for (const Bridge& bridge :
           bridges_between(bodies[i].outer, bodies[j].outer)) {
        if (bridge.length < best.length) {
          best = bridge;
          from = i;
          to = j;
        }
      }
    }
  }
  Body& kept = bodies[from];
  Body& gone = bodies[to];
  kept.outer = joined(kept.outer, gone.outer, best);
  kept.holes.insert(kept.holes.end(), gone.holes.begin(), gone.holes.end());
  bodies.erase(bodies.begin() + static_cast<ptrdiff_t>(to));
}

// Swaps the bodies of `second` so that each is near its partner in `first`.
void pair_nearest(const std::vector<Body>& first, std::vector<Body>& second) {
  for (size_t i = 0; i < first.size(); ++i) {
    const Point at = centroid_of(first[i].outer);
    const auto begin = second.begin() + static_cast<ptrdiff_t>(i);
    std::iter_swap(begin,
                   std::min_element(begin, second.end(),
                                    [&at](const Body& a, const Body& b) {
                                      return length(centroid_of(a.outer) - at) <
                                             length(centroid_of(b.outer) - at);
                                    }));
  }
}

// Two bodies that one is cut into.
struct Halves {
  std::vector<Body> bodies;
  double cut = 0;   // its length [u]
  double cost = 0;  // roughly
};

// Cuts the one body of `bodies` into those that become the two of `others`: the
// best cuts, the shortest first. None: it has holes, or no chord through its
// ink.
std::vector<Halves> split(const std::vector<Body>& bodies,
                          const std::vector<Body>& others) {
  constexpr size_t kMostStops = 64;
  constexpr size_t kMostSplits = 8;
  std::vector<Halves> all;
  if (bodies.size() != 1 || others.size() != 2 ||
      !bodies.front().holes.empty()) {
    return all;
  }
  const Loop& whole = bodies.front().outer;
  std::vector<LoopStop> stops = stops_of(whole, 4);
  for (int parts = 2; stops.size() > kMostStops && parts != 0; parts /= 2) {
    stops = stops_of(whole, parts);
  }
  const MorphPolygons polygons = polygon_of(whole);
  const auto is_inside = [&](const LoopStop& a, const LoopStop& b) {
    return a.edge != b.edge &&
           depth_at(polygons, 0.9 * a.at + 0.1 * b.at) > 1 &&
           depth_at(polygons, middle(a.at, b.at)) > 1 &&
           depth_at(polygons, 0.1 * a.at + 0.9 * b.at) > 1;
  };
  MatchOptions quick;
  quick.parts = 1;
  for (size_t i = 0; i < stops.size() && stops.size() <= kMostStops; ++i) {
    for (size_t j = 0; j < stops.size(); ++j) {
      if (is_inside(stops[i], stops[j])) {
        Loop parts[2] = {part_between(whole, stops[i], stops[j]),
                         part_between(whole, stops[j], stops[i])};
        const double cut = length(stops[i].at - stops[j].at);
        const double cost = match_loops(parts[0], others[0].outer, quick).cost +
                            match_loops(parts[1], others[1].outer, quick).cost;
        all.push_back({{{std::move(parts[0]), {}}, {std::move(parts[1]), {}}},
                       cut,
                       cost});
      }
    }
  }
  std::stable_sort(
      all.begin(), all.end(),
      [](const Halves& a, const Halves& b) { return a.cost < b.cost; });
  all.resize(std::min(all.size(), kMostSplits));
  std::stable_sort(
      all.begin(), all.end(),
      [](const Halves& a, const Halves& b) { return a.cut < b.cut; });
  return all;
}

struct Morph {
  std::optional<MorphPair> pair;
  double cost = kInfinity;
};

// Of bodies of equal number, each with the one at its place.
Morph morph_bodies(const std::vector<Body>& first,
                   const std::vector<Body>& second) {
  MorphPair whole;
  double cost = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    std::vector<Plan> plans = BodyMorph(first[i], second[i]).find();
    if (plans.empty() || !plans.front().is_usable()) {
      return {};
    }
    cost += plans.front().cost;
    for (MorphContour& contour : plans.front().pair.contours) {
      whole.contours.push_back(std::move(contour));
    }
  }
  if (!quality_of(whole).is_within(kMostAreaError)) {
    return {};
  }
  return {std::move(whole), cost};
}

}  // namespace

std::optional<MorphPair> find_morph(const Outline& first,
                                    const Outline& second) {
  std::vector<Body> bodies[2] = {bodies_of(first), bodies_of(second)};
  if (bodies[0].empty() || bodies[1].empty()) {
    return std::nullopt;
  }
  Morph best;
  for (size_t k = 0; k < 2; ++k) {
    for (const Halves& halves : split(bodies[k], bodies[1 - k])) {
      best = k == 0 ? morph_bodies(halves.bodies, bodies[1])
                    : morph_bodies(bodies[0], halves.bodies);
      if (best.pair) {
        break;
      }
    }
  }
  for (size_t k = 0; k < 2; ++k) {
    while (bodies[k].size() > bodies[1 - k].size()) {
      join_nearest(bodies[k]);
    }
  }
  pair_nearest(bodies[0], bodies[1]);
  Morph joined = morph_bodies(bodies[0], bodies[1]);
  return joined.cost < best.cost ? joined.pair : best.pair;
}

}  // namespace inkcell::gen
