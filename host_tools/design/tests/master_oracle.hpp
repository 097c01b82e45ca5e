// Draws bitmap masters from outlines, and compares outlines.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bitmap/bitmap.hpp"
#include "bitmap/edge_walk.hpp"
#include "fit/vectors.hpp"
#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::test {

struct Errors {
  double worst = 0;
  double sum = 0;
  double count = 0;

  void note(double error, double weight = 1) {
    worst = std::max(worst, std::fabs(error));
    sum += weight * error * error;
    count += weight;
  }
  double rms() const { return count == 0 ? 0 : std::sqrt(sum / count); }
};

/// The shape with a margin, in grey or bilevel, and its position.
Bitmap draw_master(const gen::Shape& shape,
                   double px_per_em,
                   bool is_grey,
                   MasterPlace& place);

/// Places where the united contours turn by more than 10 degrees. [u]
std::vector<Point> corners_of(const gen::Outline& source);

/// Whether a corner is nearer than 3 u.
bool is_near_any(const Point& p, const std::vector<Point>& corners);

/// Records the distances of the border of `from` from that of `to`: everywhere,
/// and away from corners. [u]
void compare_edges(const gen::Shape& from,
                   const gen::Shape& to,
                   const std::vector<Point>& corners,
                   Errors& off_corners,
                   Errors& all);

}  // namespace inkcell::design::test
