#include "field/cell_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkcell::gen {
namespace {

constexpr size_t kSide = Lattice::kSteps + 1;
constexpr size_t kPoints = kSide * kSide;

// From round kPatience on, a fit this far beyond the limit is given up. [limit]
constexpr int kPatience = 2;
constexpr double kHopeless = 1.5;
// A fit below this is good enough: what is left is for quantisation, and for
// what lies between the points. [limit] With 1 in its place, two fits of five
// fail in the test and cells grow by a tenth.
constexpr double kEnough = 0.7;

// What a point keeps of its weight in each round if it has no error.
constexpr double kMemory = 0.4;

// Beyond the band a distance only has to stay beyond.
constexpr double kWeightBeyond = 0.25;

using Nine = std::array<double, 9>;

std::array<double, 3> lagrange(double t) {
  return {2 * (t - 0.5) * (t - 1), -4 * t * (t - 1), 2 * t * (t - 0.5)};
}

// Weights of the nine distances at each point.
std::array<Nine, kPoints> make_basis() {
  std::array<Nine, kPoints> basis;
  for (size_t p = 0; p < kPoints; ++p) {
    const double steps = kSide - 1;
    const auto x = lagrange(static_cast<double>(p % kSide) / steps);
    const auto y = lagrange(static_cast<double>(p / kSide) / steps);
    for (size_t k = 0; k < 9; ++k) {
      basis[p][k] = x[k % 3] * y[k / 3];
    }
  }
  return basis;
}

double dot(const Nine& a, const Nine& b) {
  double sum = 0;
  for (size_t k = 0; k < 9; ++k) {
    sum += a[k] * b[k];
  }
  return sum;
}

// The normal equations: `matrix` x = `right`, symmetric and positive. Only the
// lower triangle is set.
struct Normal {
  std::array<Nine, 9> matrix{};
  Nine right{};

  void add(const Nine& row, double value, double weight) {
    for (size_t r = 0; r < 9; ++r) {
      const double scaled = weight * row[r];
      right[r] += scaled * value;
      for (size_t c = 0; c <= r; ++c) {
        matrix[r][c] += scaled * row[c];
      }
    }
  }

  // Cholesky's way, in place. False if the matrix has no positive pivot.
  bool solve(Nine& x) {
    for (size_t c = 0; c < 9; ++c) {
      for (size_t r = c; r < 9; ++r) {
        double sum = matrix[r][c];
        for (size_t k = 0; k < c; ++k) {
          sum -= matrix[r][k] * matrix[c][k];
        }
        if (r == c && !(sum > 0)) {
          return false;
        }
        matrix[r][c] = r == c ? std::sqrt(sum) : sum / matrix[c][c];
      }
    }
    for (size_t r = 0; r < 9; ++r) {
      double sum = right[r];
      for (size_t k = 0; k < r; ++k) {
        sum -= matrix[r][k] * x[k];
      }
      x[r] = sum / matrix[r][r];
    }
    for (size_t r = 9; r-- > 0;) {
      double sum = x[r];
      for (size_t k = r + 1; k < 9; ++k) {
        sum -= matrix[k][r] * x[k];
      }
      x[r] = sum / matrix[r][r];
    }
    return true;
  }
};

double first_weight(const Metric& metric, double truth_u) {
  const double slope = metric.slope(truth_u);
  const bool beyond = std::fabs(truth_u) > metric.band_u();
  return slope * slope * (beyond ? kWeightBeyond : 1);
}

const std::array<Nine, kPoints>& basis() {
  static const std::array<Nine, kPoints> kBasis = make_basis();
  return kBasis;
}

bool least_squares(const Lattice& truth,
                   const std::array<double, kPoints>& weight,
                   Nine& values) {
  Normal normal;
  for (size_t p = 0; p < kPoints; ++p) {
    normal.add(basis()[p], truth[p], weight[p]);
  }
  return normal.solve(values);
}

// Returns the largest.
double errors_of(const Metric& metric,
                 const Lattice& truth,
                 const Nine& values,
                 std::array<double, kPoints>& error) {
  double worst = 0;
  for (size_t p = 0; p < kPoints; ++p) {
    error[p] = metric.error(truth[p], dot(basis()[p], values));
    worst = std::max(worst, error[p]);
  }
  return worst;
}

}  // namespace

bool fit_cell(const Metric& metric,
              Lattice& lattice,
              const Neighbourhood& truth,
              int rounds,
              std::array<double, 9>& nine) {
  lattice.fill(truth);
  std::array<double, kPoints> weight;
  for (size_t p = 0; p < kPoints; ++p) {
    weight[p] = first_weight(metric, lattice[p]);
  }
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    Nine values{};
    if (!least_squares(lattice, weight, values)) {
      break;
    }
    std::array<double, kPoints> error;
    const double worst = errors_of(metric, lattice, values, error);
    if (worst < best) {
      best = worst;
      nine = values;
    }
    if (best <= kEnough * metric.limit() ||
        (round >= kPatience && worst > kHopeless * metric.limit())) {
      break;
    }
    for (size_t p = 0; p < kPoints; ++p) {
      weight[p] *= kMemory + error[p] / worst;
    }
  }
  return best <= metric.limit();
}

}  // namespace inkcell::gen
