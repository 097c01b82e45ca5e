#include "outlines/chain_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// A tangent within 0.6 degrees of an axis is parallel to it.
constexpr double kParallel = 0.01;
// A chain off by this many tolerances may become acceptable by small moves.
constexpr double kWorthMoving = 4;
// Larger than any limit. [grid units]
constexpr double kAny = 1e6;
constexpr int kMostMoves = 40;

Point rounded(const Point& p) {
  return {std::floor(p.x + 0.5), std::floor(p.y + 0.5)};
}

// Whether two points of a chain coincide.
bool has_twins(const Chain& chain) {
  Point before = chain.from;
  for (const Point& control : chain.controls) {
    if (control == before) {
      return true;
    }
    before = control;
  }
  return before == chain.to;
}

// Least and greatest value of a coordinate of a quadratic.
void extent(const Segment& q, double Point::*c, double& low, double& high) {
  const double a = q.p[0].*c;
  const double b = q.p[1].*c;
  const double e = q.p[2].*c;
  low = std::min({low, a, e});
  high = std::max({high, a, e});
  const double d = a - 2 * b + e;
  if (d != 0) {
    const double t = (a - b) / d;
    if (t > 0 && t < 1) {
      const double v = a + t * (b - a);
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
}

}  // namespace

ChainSearch::ChainSearch(const Trace& trace,
                         const RefitScale& scale,
                         RefitMemo& memo)
    : trace_(trace), scale_(scale), memo_(memo) {
  for (size_t i = 0; i < trace.stretches.size(); ++i) {
    const Node& at = trace.nodes[i];
    const Stretch& stretch = trace.stretches[i];
    Fingerprint print;
    print.add(at.on_grid);
    print.add(at.before);
    print.add(at.after);
    print.add(uint64_t{at.extreme_x} << 1 | uint64_t{at.extreme_y});
    print.add(static_cast<uint64_t>(stretch.kind));
    print.add(static_cast<uint64_t>(stretch.care));
    print.add(stretch.control);
    const SampleSpan samples = span(i, i + 1);
    print.add(uint64_t{samples.count});
    for (size_t k = 0; k < samples.count; ++k) {
      print.add(samples.first[k]);
    }
    stretches_.push_back(print);
  }
}

// Everything that search() depends on.
Fingerprint ChainSearch::fingerprint(size_t first,
                                     size_t last,
                                     size_t controls) const {
  Fingerprint print;
  print.add(scale_.tolerance);
  print.add(scale_.careful_tolerance);
  print.add(scale_.chord_bound);
  print.add(scale_.extreme_tolerance);
  print.add(uint64_t{controls});
  for (size_t i = first; i < last; ++i) {
    print.add(stretches_[i]);
  }
  print.add(node(last).on_grid);
  print.add(node(last).before);
  return print;
}

Care ChainSearch::care(size_t first, size_t last) const {
  Care most = Care::none;
  for (size_t i = first; i < last; ++i) {
    most = std::max(most, trace_.stretches[i].care);
  }
  return most;
}

double ChainSearch::tolerance(size_t first, size_t last) const {
  return care(first, last) == Care::none ? scale_.tolerance
                                         : scale_.careful_tolerance;
}

SampleSpan ChainSearch::span(size_t first, size_t last) const {
  const size_t from = trace_.nodes[first].at;
  const size_t to = last == trace_.nodes.size() ? trace_.samples.size() - 1
                                                : trace_.nodes[last].at;
  return {trace_.samples.data() + from, to - from + 1};
}

bool ChainSearch::own_controls(size_t first, size_t last, Chain& chain) const {
  if (last - first != chain.controls.size()) {
    return false;
  }
  for (size_t i = first; i < last; ++i) {
    if (trace_.stretches[i].kind != Stretch::Kind::quadratic) {
      return false;
    }
    chain.controls[i - first] = rounded(trace_.stretches[i].control);
  }
  return true;
}

// The chain starts and ends along an axis where the source does. Where the
// source turns back in between, two controls are level with that place.
FixedControls ChainSearch::fix(size_t first,
                               size_t last,
                               const Chain& chain) const {
  const size_t n = chain.controls.size();
  FixedControls fixed(n);
  const auto set = [&](size_t i, bool x, double value) {
    (x ? fixed.x : fixed.y)[i] = true;
    (x ? fixed.at[i].x : fixed.at[i].y) = value;
  };
  const SampleSpan whole = span(first, last);
  if (n > 1) {
    for (size_t m = first + 1; m < last; ++m) {
      const Node& at = trace_.nodes[m];
      const double part = static_cast<double>(at.at - trace_.nodes[first].at) /
                          static_cast<double>(whole.count - 1);
      const double place = part * static_cast<double>(n) - 0.5;
      const size_t k =
          std::min(n - 2, static_cast<size_t>(std::max(0.0, place)));
      if (at.extreme_x || at.extreme_y) {
        set(k, at.extreme_x, at.extreme_x ? at.on_grid.x : at.on_grid.y);
        set(k + 1, at.extreme_x, at.extreme_x ? at.on_grid.x : at.on_grid.y);
      }
    }
  }
  const Point& start = node(first).after;
  const Point& end = node(last).before;
  if (std::fabs(start.x) < kParallel) {
    set(0, true, chain.from.x);
  } else if (std::fabs(start.y) < kParallel) {
    set(0, false, chain.from.y);
  }
  if (std::fabs(end.x) < kParallel) {
    set(n - 1, true, chain.to.x);
  } else if (std::fabs(end.y) < kParallel) {
    set(n - 1, false, chain.to.y);
  }
  return fixed;
}

bool ChainSearch::find(size_t first,
                       size_t last,
                       size_t controls,
                       Chain& chain) const {
  const Fingerprint print = fingerprint(first, last, controls);
  if (const std::optional<Chain>* known = memo_.chains.find(print)) {
    if (*known) {
      chain = **known;
    }
    return known->has_value();
  }
  const bool found = search(first, last, controls, chain);
  memo_.chains.add(print, found ? std::optional<Chain>(chain) : std::nullopt);
  return found;
}

bool ChainSearch::search(size_t first,
                         size_t last,
                         size_t controls,
                         Chain& chain) const {
  chain.from = node(first).on_grid;
  chain.to = node(last).on_grid;
  chain.controls.assign(controls, Point{});
  if (controls == 0) {
    return acceptable(first, last, chain);
  }
  if (own_controls(first, last, chain) && acceptable(first, last, chain)) {
    return true;
  }
  const FixedControls fixed = fix(first, last, chain);
  const FixedControls free(controls);
  const FixedControls* const variants[] = {&fixed, &free};
  for (size_t i = fixed.any() ? 0 : 1; i < std::size(variants); ++i) {
    if (!fit_controls(span(first, last), *variants[i], tolerance(first, last),
                      chain)) {
      continue;
    }
    for (Point& control : chain.controls) {
      control = rounded(control);
    }
    if (improve(first, last, chain)) {
      return true;
    }
  }
  return false;
}

bool ChainSearch::improve(size_t first, size_t last, Chain& chain) const {
  const double wanted = tolerance(first, last);
  Deviation deviation(span(first, last), scale_.chord_bound);
  double best = deviation.of(chain, kWorthMoving * wanted);
  if (best > kWorthMoving * wanted) {
    return false;
  }
  for (int move = 0; move < kMostMoves && best > wanted; ++move) {
    bool moved = false;
    for (Point& control : chain.controls) {
      for (const Point step :
           {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}, Point{1, 1},
            Point{-1, -1}, Point{1, -1}, Point{-1, 1}}) {
        const Point before = control;
        control = control + step;
        const double d = deviation.of(chain, best);
        if (d < best) {
          best = d;
          moved = true;
        } else {
          control = before;
        }
      }
    }
    if (!moved) {
      return false;
    }
  }
  return best <= wanted && !has_twins(chain) &&
         keeps_extremes(first, last, chain);
}

bool ChainSearch::acceptable(size_t first,
                             size_t last,
                             const Chain& chain) const {
  const double wanted = tolerance(first, last);
  return !has_twins(chain) &&
         Deviation(span(first, last), scale_.chord_bound).of(chain, wanted) <=
             wanted &&
         keeps_extremes(first, last, chain);
}

bool ChainSearch::keeps_extremes(size_t first,
                                 size_t last,
                                 const Chain& chain) const {
  bool any = false;
  for (size_t m = first + 1; m < last; ++m) {
    any |= trace_.nodes[m].extreme_x || trace_.nodes[m].extreme_y;
  }
  if (!any) {
    return true;
  }
  // The extent of the source between its nodes, rounded to the grid.
  for (const auto c : {&Point::x, &Point::y}) {
    double low = std::min(chain.from.*c, chain.to.*c);
    double high = std::max(chain.from.*c, chain.to.*c);
    double chain_low = low;
    double chain_high = high;
    for (size_t m = first + 1; m < last; ++m) {
      const Node& at = trace_.nodes[m];
      if (c == &Point::x ? at.extreme_x : at.extreme_y) {
        low = std::min(low, at.on_grid.*c);
        high = std::max(high, at.on_grid.*c);
      }
    }
    for (size_t i = 0; i < chain.controls.size(); ++i) {
      extent(chain.quadratic(i), c, chain_low, chain_high);
    }
    if (std::fabs(chain_low - low) > scale_.extreme_tolerance ||
        std::fabs(chain_high - high) > scale_.extreme_tolerance) {
      return false;
    }
  }
  return true;
}

Chain ChainSearch::nearest(size_t stretch) const {
  Chain line{node(stretch).on_grid, {}, node(stretch + 1).on_grid};
  const Stretch& source = trace_.stretches[stretch];
  if (source.kind == Stretch::Kind::line) {
    return line;
  }
  Chain curve = line;
  curve.controls.push_back(source.control);
  if (source.kind == Stretch::Kind::other &&
      !fit_controls(span(stretch, stretch + 1), FixedControls(1), kAny,
                    curve)) {
    return line;
  }
  curve.controls[0] = rounded(curve.controls[0]);
  const SampleSpan samples = span(stretch, stretch + 1);
  const auto deviation = [&](const Chain& chain) {
    return Deviation(samples, scale_.chord_bound).of(chain, kAny);
  };
  return deviation(curve) < deviation(line) ? curve : line;
}

}  // namespace inkcell::gen
