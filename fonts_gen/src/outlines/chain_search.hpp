// Searches for chains on the grid that fit a part of a contour.
#pragma once

#include <cstddef>
#include <vector>

#include "outlines/curve_fit.hpp"
#include "outlines/refit_memo.hpp"
#include "outlines/trace.hpp"

namespace inkcell::gen {

/// Searches for chains between the nodes `first` < `last` of a trace; node
/// nodes.size() is the first one again.
class ChainSearch {
 public:
  /// Refers to all arguments.
  ChainSearch(const Trace& trace, const RefitScale& scale, RefitMemo& memo);

  const Node& node(size_t i) const {
    return trace_.nodes[i == trace_.nodes.size() ? 0 : i];
  }

  /// The greatest care of the stretches in between.
  Care care(size_t first, size_t last) const;

  /// Finds an acceptable chain of `controls` quadratics, or a line for 0.
  /// Results are cached in the memo.
  bool find(size_t first, size_t last, size_t controls, Chain& chain) const;

  /// Moves control points by small steps until the chain is acceptable.
  bool improve(size_t first, size_t last, Chain& chain) const;

  /// Whether the chain, on the grid, is within the tolerance and turns back
  /// where the source does.
  bool acceptable(size_t first, size_t last, const Chain& chain) const;

  /// The nearest chain for one stretch, acceptable or not.
  Chain nearest(size_t stretch) const;

 private:
  double tolerance(size_t first, size_t last) const;
  SampleSpan span(size_t first, size_t last) const;
  bool own_controls(size_t first, size_t last, Chain& chain) const;
  bool keeps_extremes(size_t first, size_t last, const Chain& chain) const;
  FixedControls fix(size_t first, size_t last, const Chain& chain) const;

  bool search(size_t first, size_t last, size_t controls, Chain& chain) const;
  Fingerprint fingerprint(size_t first, size_t last, size_t controls) const;

  const Trace& trace_;
  const RefitScale& scale_;
  RefitMemo& memo_;
  std::vector<Fingerprint> stretches_;  // each with the node where it begins
};

}  // namespace inkcell::gen
