// Stems, bars and heights of a glyph: what must stay in step when its weight
// changes.
#pragma once

#include <vector>

#include "shape/shape.hpp"

namespace inkcell::design {

/// A movement along one axis by the place on it, linear between its knots.
class Shift {
 public:
  /// Drops knots that would put ink out of order, the later ones of `knots`.
  void add(double place, double by);
  double at(double place) const;
  bool empty() const { return knots_.empty(); }
  /// Adds to the movement of the knots from `place` on, or up to it.
  void raise(double place, double by, bool is_upwards);

 private:
  struct Knot {
    double place;
    double by;
  };
  std::vector<Knot> knots_;  // sorted
};

/// A level edge of ink, or a local extreme of a curve. [u]
struct LevelEdge {
  double place = 0;
  double middle = 0;     // on the other axis
  double half = 0;       // of its length
  bool is_top = false;   // ink is below
  double thickness = 0;  // of the ink behind it; 0: more than a bar's
};

/// Ink between two level edges: a bar, or with axes swapped a stem. [u]
struct Bar {
  double low = 0;
  double high = 0;
};

/// The level edges of a shape. `swapped` is the same shape with x and y
/// swapped.
std::vector<LevelEdge> level_edges(const gen::Shape& shape,
                                   const gen::Shape& swapped);

/// The bars between edges, the thinnest first; none overlap.
std::vector<Bar> bars_of(const std::vector<LevelEdge>& edges);

/// The ends of letters that others are level with. [u]
struct Heights {
  std::vector<double> tops;
  std::vector<double> bottoms;
};

gen::Outline swapped(const gen::Outline& outline);

/// Keeps heights: edges at those of other letters and at the ends of the ink
/// hold their places, bars grow by `up` on both sides. [u]
Shift shift_of_heights(const std::vector<LevelEdge>& edges,
                       const gen::Box& box,
                       const Heights& heights,
                       double up);

/// White between stems that meet, as in v: how wide it is between its ends
/// depends on how thick they are. [u]
struct SlantedCounter {
  double middle = 0;  // between what moves with its left and right stem
  double y = 0;       // where it is measured, halfway up
  double width = 0;   // there
};

/// How stems move, and the counters that this does not keep.
struct StemShift {
  Shift shift;
  std::vector<SlantedCounter> counters;
};

/// Keeps counters: each stem moves with the growth of those before it, less
/// the part `squeeze` (0..1), which the counters give. [u]
StemShift shift_of_stems(const gen::Shape& shape,
                         const std::vector<LevelEdge>& edges,
                         double across,
                         double squeeze);

}  // namespace inkcell::design
