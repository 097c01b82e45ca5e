#include "outlines/chain_path.hpp"

#include <algorithm>
#include <cmath>

#include "outlines/point_bits.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr size_t kMostControls = 4;
constexpr size_t kMostStretches = 20;
// The search ends after this many consecutive nodes that no chain reaches.
constexpr int kMostFailures = 3;

// Extra cost of a curve, which takes longer to draw than a line. From 0 to 8
// the size of a font stays the same and its curves get fewer. [bits]
constexpr double kCurve_bits = 8;
// Extra cost of a corner where the source is smooth. [bits]
constexpr double kKink_bits = 3;
constexpr double kKink_cos = 0.9975641;  // 4 degrees at each side
// More than any chain costs.
constexpr double kUnacceptable_bits = 1000;

double kink_bits(const Node& node, const Point& wanted, const Point& leg) {
  const bool smooth = dot(node.before, node.after) > kKink_cos;
  return smooth && dot(wanted, direction(leg)) < kKink_cos ? kKink_bits : 0;
}

double bits_of(const ChainSearch& search, const PathStep& step) {
  const Chain& chain = step.chain;
  double bits = kCurve_bits * static_cast<double>(chain.controls.size());
  Point pen = chain.from;
  for (const Point& control : chain.controls) {
    bits += point_bits(pen, control);
    pen = control;
  }
  bits += point_bits(pen, chain.to);
  const Node& first = search.node(step.first);
  const Node& last = search.node(step.last);
  const Point& first_control =
      chain.controls.empty() ? chain.to : chain.controls.front();
  const Point& last_control =
      chain.controls.empty() ? chain.from : chain.controls.back();
  return bits + kink_bits(first, first.after, first_control - chain.from) +
         kink_bits(last, last.before, chain.to - last_control);
}

// Finds the chain with the fewest controls, at least `fewest`. False if none is
// acceptable.
bool find_chain(const ChainSearch& search, size_t fewest, PathStep& step) {
  const Care care = search.care(step.first, step.last);
  if (care == Care::exact && step.last > step.first + 1) {
    return false;
  }
  const size_t most = care == Care::none ? kMostControls : 1;
  for (size_t controls = fewest; controls <= most; ++controls) {
    if (search.find(step.first, step.last, controls, step.chain)) {
      return true;
    }
  }
  return false;
}

// The cheapest path to each node so far.
class CheapestPaths {
 public:
  explicit CheapestPaths(size_t nodes)
      : cost_(nodes + 1, kInfinity), last_(nodes + 1) {
    cost_[0] = 0;
  }

  void offer(const PathStep& step, double bits) {
    bits += cost_[step.first];
    if (bits < cost_[step.last]) {
      cost_[step.last] = bits;
      last_[step.last] = step;
    }
  }

  std::vector<PathStep> path() const {
    std::vector<PathStep> path;
    for (size_t i = last_.size() - 1; i > 0; i = last_[i].first) {
      path.push_back(last_[i]);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  std::vector<double> cost_;
  std::vector<PathStep> last_;
};

}  // namespace

std::vector<PathStep> cheapest_path(const Trace& trace,
                                    const ChainSearch& search) {
  const size_t n = trace.nodes.size();
  CheapestPaths paths(n);
  for (size_t i = 0; i < n; ++i) {
    int failures = 0;
    // Longer chains need at least as many controls; one less is tried too, as
    // the search may have missed a curve.
    size_t fewest = 0;
    for (size_t j = i + 1; j <= std::min(n, i + kMostStretches); ++j) {
      PathStep step{i, j, {}};
      if (find_chain(search, fewest, step)) {
        failures = 0;
        fewest = std::max<size_t>(step.chain.controls.size(), 1) - 1;
        paths.offer(step, bits_of(search, step));
      } else if (j == i + 1) {
        step.chain = search.nearest(i);
        paths.offer(step, kUnacceptable_bits + bits_of(search, step));
      } else if (++failures == kMostFailures) {
        break;
      }
      if (j < n && trace.nodes[j].hard) {
        break;
      }
    }
  }
  return paths.path();
}

namespace {

// Joints with larger turns cannot be left out.
constexpr double kJoinTurn_cos = 0.9396926;

// Replaces two chains by one without their joint.
bool join(const ChainSearch& search,
          const PathStep& a,
          const PathStep& b,
          PathStep& joined) {
  const Node& joint = search.node(a.last);
  if (a.chain.controls.empty() || b.chain.controls.empty() || joint.hard ||
      dot(joint.before, joint.after) < kJoinTurn_cos ||
      search.care(a.first, b.last) != Care::none) {
    return false;
  }
  joined = {a.first, b.last, a.chain};
  std::vector<Point>& controls = joined.chain.controls;
  const size_t k = controls.size();
  controls.insert(controls.end(), b.chain.controls.begin(),
                  b.chain.controls.end());
  joined.chain.to = b.chain.to;
  const Point left = controls[k - 1];
  const Point right = controls[k];
  const Point shift = 2.0 * (a.chain.to - middle(left, right));
  // Moves one control, the other, or both, so that the joint is midway again.
  for (const double share : {0.0, 0.5, 1.0}) {
    const Point s{std::floor(share * shift.x + 0.5),
                  std::floor(share * shift.y + 0.5)};
    controls[k - 1] = left + s;
    controls[k] = right + (shift - s);
    if (search.acceptable(a.first, b.last, joined.chain)) {
      return true;
    }
  }
  controls[k - 1] = left;
  controls[k] = right;
  return search.improve(a.first, b.last, joined.chain);
}

// Moves controls where that saves bits.
void cheapen(const ChainSearch& search, PathStep& step) {
  for (size_t i = 0; i < step.chain.controls.size(); ++i) {
    double bits = bits_of(search, step);
    const Point home = step.chain.controls[i];
    Point best = home;
    for (int dx = -2; dx <= 2; ++dx) {
      for (int dy = -2; dy <= 2; ++dy) {
        step.chain.controls[i] =
            home + Point{static_cast<double>(dx), static_cast<double>(dy)};
        const double b = bits_of(search, step);
        if (b < bits && search.acceptable(step.first, step.last, step.chain)) {
          bits = b;
          best = step.chain.controls[i];
        }
      }
    }
    step.chain.controls[i] = best;
  }
}

}  // namespace

void drop_joints(const ChainSearch& search, std::vector<PathStep>& path) {
  for (size_t i = 0; i + 1 < path.size();) {
    PathStep joined;
    if (join(search, path[i], path[i + 1], joined)) {
      path[i] = std::move(joined);
      path.erase(path.begin() + static_cast<ptrdiff_t>(i) + 1);
    } else {
      ++i;
    }
  }
  for (PathStep& step : path) {
    if (search.care(step.first, step.last) == Care::none) {
      cheapen(search, step);
    }
  }
}

}  // namespace inkcell::gen
