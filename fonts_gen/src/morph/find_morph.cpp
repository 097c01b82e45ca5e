#include "morph/find_morph.hpp"

#include <algorithm>
#include <utility>

#include "morph/births.hpp"
#include "morph/match_loops.hpp"
#include "morph/match_mirrored.hpp"
#include "morph/morph_look.hpp"
#include "morph/morph_loop.hpp"
#include "morph/morph_thorns.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// An outer contour and its holes.
struct Body {
  Loop outer;
  std::vector<Loop> holes;
};

// The hole of the second body that a hole of the first one becomes.
constexpr size_t kNone = SIZE_MAX;  // it dies
using Fates = std::vector<size_t>;

using Fars = std::vector<double>;
const Fars kFewFars_u = {kUsualFar_u, 140, 500, 1000};
const Fars kMoreFars_u = {60, 80, 110, 180, 350, 700, 1500, 2500};
// Prices of askew edges; the less, the more plans that are clean and thorny.
constexpr double kTurnings[] = {2, 0.7, 0};
constexpr double kSmallThorns = 10;  // see thorns_of()
constexpr double kSmallAreaError = 0.02;
constexpr size_t kMostRepaired = 4;
constexpr int kMostRepairs = 8;
// Further holes die.
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
  bool is_looked_at = false;
  bool is_clean = false;  // without a blemish, as far as it is looked at
  double thorns = 0;
  bool is_mirrored = false;
  double cost = 0;
  // What it came from, to try again.
  MatchOptions options;
  const Fates* fates = nullptr;

  bool is_good() const { return quality.is_within(kMostAreaError); }
};

void judge(Plan& plan) {
  constexpr double kCrossing = 400;
  constexpr double kAreaError = 15000;
  constexpr double kThorn = 50;
  plan.quality = quality_of(plan.pair);
  plan.thorns = thorns_of(plan.pair);
  plan.cost =
      priced(plan.pair) + kThorn * plan.thorns +
      kCrossing * static_cast<double>(plan.quality.crossings.size()) +
      kAreaError * std::max(0.0, plan.quality.area_error - kSmallAreaError);
}

void judge_thickness(Plan& plan) {
  constexpr double kThickening = 6000;
  plan.cost += kThickening * std::max(0.0, thickening_of(plan.pair) - 1.1);
}

bool is_better(const Plan& a, const Plan& b) {
  if (a.is_good() != b.is_good()) {
    return a.is_good();
  }
  if (a.is_clean != b.is_clean) {
    return a.is_clean;
  }
  return a.is_mirrored != b.is_mirrored ? a.is_mirrored : a.cost < b.cost;
}

// The earliest step at which a contour may be born without crossing another
// one, and is no speck at the least size.
int birth_step(const MorphPair& pair, size_t contour, double area_u2) {
  // Two pixels at 24 px/em.
  constexpr double kSpeck_u2 = 2 * (kUPerEm / 24) * (kUPerEm / 24);
  constexpr int kFirstStep = 2;
  constexpr int kLastStep = 12;
  int step = kFirstStep;
  while (step < kLastStep &&
         area_u2 * (step + 1) * (step + 1) < kSpeck_u2 * kBirths * kBirths) {
    ++step;
  }
  static_assert(kBirths == kMorphSteps, "crossings are known of each birth");
  for (const MorphCrossing& crossing : crossings_of(pair)) {
    if (crossing.contour[0] == contour || crossing.contour[1] == contour) {
      const int since = pair.contours[contour].missing == 0
                            ? crossing.step
                            : kMorphSteps - crossing.step;
      step = std::max(step, std::min(since, kLastStep));
    }
  }
  return step;
}

// Contours that are born swell until the area is right.
MorphQuality swell(MorphPair& pair) {
  MorphPair trial = pair;
  MorphQuality best = quality_of(pair);
  for (int swell = 1; swell < kSwells && best.area_error > kSmallAreaError;
       ++swell) {
    for (MorphContour& contour : trial.contours) {
      contour.swell = contour.missing < 0 ? 0 : swell;
    }
    if (area_error_of(trial) < best.area_error) {
      MorphQuality quality = quality_of(trial);
      if (quality.crossings.size() <= best.crossings.size()) {
        best = std::move(quality);
        pair = trial;
      }
    }
  }
  return best;
}

// Adds a contour that the outline number `missing` lacks: born where it crosses
// least, and keeps the area. False: there is no room.
bool add_born(const Loop& loop,
              const std::vector<Loop>& glyph,
              int missing,
              MorphPair& pair) {
  const double area_u2 = std::abs(area_of(loop));
  size_t crossings = SIZE_MAX;
  double area_error = kInfinity;
  MorphPair best;
  for (const MorphContour& born : births_of(loop, glyph, missing)) {
    MorphPair with = pair;
    with.contours.push_back(born);
    const size_t last = with.contours.size() - 1;
    with.contours[last].birth = birth_step(with, last, area_u2);
    const MorphQuality quality = swell(with);
    const double error = std::max(quality.area_error, kSmallAreaError);
    if (quality.crossings.size() < crossings ||
        (quality.crossings.size() == crossings && error < area_error)) {
      crossings = quality.crossings.size();
      area_error = error;
      best = std::move(with);
    }
    if (crossings == 0 && area_error == kSmallAreaError) {
      break;
    }
  }
  if (crossings != SIZE_MAX) {
    pair = std::move(best);
  }
  return crossings != SIZE_MAX;
}

// Tries all fates of the holes of two bodies.
class BodyMorph {
 public:
  BodyMorph(const Body& a, const Body& b) : bodies_{&a, &b} {
    for (size_t k = 0; k < 2; ++k) {
      loops_[k] = bodies_[k]->holes;
      loops_[k].insert(loops_[k].begin(), bodies_[k]->outer);
    }
    for (const Loop& first : a.holes) {
      for (const Loop& second : b.holes) {
        matches_.push_back(match_loops(first, second, {}));
      }
    }
    fates_.assign(a.holes.size(), kNone);
    choose(0);
  }

  // The best plan first.
  std::vector<Plan> find() {
    for (const double turning : kTurnings) {
      plans_.clear();
      if (search(turning)) {
        break;
      }
    }
    return take();
  }

 private:
  const Loop& hole(size_t body, size_t i) const {
    return bodies_[body]->holes[i];
  }
  const LoopMatch& match_of(size_t first, size_t second) const {
    return matches_[first * bodies_[1]->holes.size() + second];
  }
  bool is_taken(size_t second) const {
    return std::find(fates_.begin(), fates_.end(), second) != fates_.end();
  }

  // Rather a hole that moves than one that dies and one that is born.
  void choose(size_t i) {
    const size_t holes[] = {fates_.size(), bodies_[1]->holes.size()};
    if (i == holes[0]) {
      const auto dead =
          static_cast<size_t>(std::count(fates_.begin(), fates_.end(), kNone));
      if (holes[0] - dead == std::min({holes[0], holes[1], kMostHoles})) {
        all_fates_.push_back(fates_);
      }
      return;
    }
    choose(i + 1);
    for (size_t k = 0; k < holes[1] && i < kMostHoles && k < kMostHoles; ++k) {
      if (!is_taken(k)) {
        fates_[i] = k;
        choose(i + 1);
        fates_[i] = kNone;
      }
    }
  }

  // Whether a good plan shows no blemish: with few thorns, if they cost.
  bool search(double turning) {
    const std::pair<const Fars&, int> kTries[] = {
        {kFewFars_u, 4}, {kMoreFars_u, 4}, {kFewFars_u, 8}};
    for (const auto& [fars_u, parts] : kTries) {
      for (const double far_u : fars_u) {
        plan(far_u, parts, turning);
      }
      look();
      if (has_clean(turning > 0 ? kSmallThorns : kInfinity)) {
        return true;
      }
    }
    std::stable_sort(plans_.begin(), plans_.end(), is_better);
    repair();
    look();
    return has_clean(kInfinity);
  }

  bool has_clean(double most_thorns) const {
    return std::any_of(plans_.begin(), plans_.end(), [&](const Plan& plan) {
      return plan.is_clean && plan.thorns <= most_thorns;
    });
  }

  void look() {
    for (Plan& plan : plans_) {
      if (plan.is_good() && !plan.is_looked_at) {
        plan.is_looked_at = true;
        plan.is_clean = !has_blemish(plan.pair);
        judge_thickness(plan);
      }
    }
  }

  std::vector<Plan> take() {
    std::stable_sort(plans_.begin(), plans_.end(), is_better);
    return std::move(plans_);
  }

  void plan(double far_u, int parts, double turning) {
    MatchOptions options;
    options.far_u = far_u;
    options.parts = parts;
    options.turning = turning;
    add_plans(match_loops(bodies_[0]->outer, bodies_[1]->outer, options),
              options, false);
    if (const std::optional<LoopMatch> mirrored =
            match_mirrored(bodies_[0]->outer, bodies_[1]->outer, options)) {
      add_plans(*mirrored, options, true);
    }
  }

  void add_plans(const LoopMatch& outer,
                 const MatchOptions& options,
                 bool is_mirrored) {
    for (const Fates& fates : all_fates_) {
      Plan plan;
      plan.options = options;
      plan.fates = &fates;
      plan.is_mirrored = is_mirrored;
      plan.pair.contours = {outer.contour};
      if (add_holes(plan)) {
        judge(plan);
        plans_.push_back(std::move(plan));
      }
    }
  }

  // False: there is no room for holes that are born.
  bool add_holes(Plan& plan) const {
    const Fates& fates = *plan.fates;
    for (size_t i = 0; i < fates.size(); ++i) {
      if (fates[i] != kNone) {
        plan.pair.contours.push_back(match_of(i, fates[i]).contour);
      }
    }
    for (size_t i = 0; i < fates.size(); ++i) {
      if (fates[i] == kNone && !add_born(hole(0, i), loops_[1], 1, plan.pair)) {
        return false;
      }
    }
    for (size_t i = 0; i < bodies_[1]->holes.size(); ++i) {
      if (std::find(fates.begin(), fates.end(), i) == fates.end() &&
          !add_born(hole(1, i), loops_[0], 0, plan.pair)) {
        return false;
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
      MatchOptions options = plan.options;
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
        plan.is_mirrored = false;
        plan.pair.contours = {
            match_loops(bodies_[0]->outer, bodies_[1]->outer, options).contour};
        if (!add_holes(plan)) {
          break;
        }
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
  Fates fates_;
  std::vector<Fates> all_fates_;
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
  double cut = 0;            // its length [u]
  double cost = 0;           // roughly
  bool is_mirrored = false;  // each is the image of itself, and what it becomes
};

// Cuts the one body of `bodies` into those that become the two of `others`: the
// best cuts, first those that keep a symmetry, then the shortest. None: it has
// holes, or no chord through its ink.
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
        const std::optional<LoopMatch> mirrored[] = {
            match_mirrored(parts[0], others[0].outer, quick),
            match_mirrored(parts[1], others[1].outer, quick)};
        const bool is_mirrored = mirrored[0] && mirrored[1];
        const double cost =
            is_mirrored
                ? mirrored[0]->cost + mirrored[1]->cost
                : match_loops(parts[0], others[0].outer, quick).cost +
                      match_loops(parts[1], others[1].outer, quick).cost;
        all.push_back({{{std::move(parts[0]), {}}, {std::move(parts[1]), {}}},
                       cut,
                       cost,
                       is_mirrored});
      }
    }
  }
  std::stable_sort(
      all.begin(), all.end(), [](const Halves& a, const Halves& b) {
        return a.is_mirrored != b.is_mirrored ? a.is_mirrored : a.cost < b.cost;
      });
  all.resize(std::min(all.size(), kMostSplits));
  std::stable_sort(all.begin(), all.end(),
                   [](const Halves& a, const Halves& b) {
                     return !b.is_mirrored && (a.is_mirrored || a.cut < b.cut);
                   });
  return all;
}

struct Morph {
  std::optional<MorphPair> pair;
  double cost = kInfinity;
  bool is_mirrored = true;
};

// Of bodies of equal number, each with the one at its place.
Morph morph_bodies(const std::vector<Body>& first,
                   const std::vector<Body>& second) {
  MorphPair whole;
  double cost = 0;
  bool is_mirrored = true;
  for (size_t i = 0; i < first.size(); ++i) {
    std::vector<Plan> plans = BodyMorph(first[i], second[i]).find();
    if (plans.empty() || !plans.front().is_good() || !plans.front().is_clean) {
      return {};
    }
    cost += plans.front().cost;
    is_mirrored = is_mirrored && plans.front().is_mirrored;
    for (MorphContour& contour : plans.front().pair.contours) {
      whole.contours.push_back(std::move(contour));
    }
  }
  if (!quality_of(whole).is_within(kMostAreaError)) {
    return {};
  }
  return {std::move(whole), cost, is_mirrored};
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
  if (best.pair && best.is_mirrored) {
    return best.pair;
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
