#include "areas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace inkcell::tools {
namespace {

// Adds the parameters at which a coordinate passes a whole number.
void add_cuts(double from, double to, std::vector<double>& cuts) {
  const auto [low, high] = std::minmax(from, to);
  for (double at = std::floor(low) + 1; at < high; at += 1) {
    cuts.push_back((at - from) / (to - from));
  }
}

}  // namespace

// What is filled to the right of a piece is added to its pixel and to all
// pixels to the right of that: `steps` has the difference of each pixel from
// the one to its left.
std::vector<double> pixel_areas(const std::vector<TrueGlyph::Chord>& border,
                                int width,
                                int height) {
  const auto columns = static_cast<size_t>(width) + 1;
  std::vector<double> steps(columns * static_cast<size_t>(height));
  std::vector<double> cuts;
  for (const TrueGlyph::Chord& piece : border) {
    cuts = {0, 1};
    add_cuts(piece.a.x, piece.b.x, cuts);
    add_cuts(piece.a.y, piece.b.y, cuts);
    std::sort(cuts.begin(), cuts.end());
    for (size_t i = 1; i < cuts.size(); ++i) {
      const double t = (cuts[i - 1] + cuts[i]) / 2;
      const double x = piece.a.x + t * (piece.b.x - piece.a.x);
      const double y = piece.a.y + t * (piece.b.y - piece.a.y);
      const double down = (cuts[i] - cuts[i - 1]) * (piece.b.y - piece.a.y);
      const double column = std::floor(x);
      double* const at = steps.data() +
                         static_cast<size_t>(std::floor(y)) * columns +
                         static_cast<size_t>(column);
      at[0] += down * (1 - (x - column));
      at[1] += down * (x - column);
    }
  }
  std::vector<double> areas;
  for (size_t row = 0; row < static_cast<size_t>(height); ++row) {
    double sum = 0;
    for (size_t x = 0; x + 1 < columns; ++x) {
      sum += steps[row * columns + x];
      areas.push_back(std::clamp(sum, 0.0, 1.0));
    }
  }
  return areas;
}

}  // namespace inkcell::tools
