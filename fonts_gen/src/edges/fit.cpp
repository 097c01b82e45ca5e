#include "edges/fit.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell {
namespace gen {
namespace {

constexpr int kRounds = 7;

// Solves the symmetric 3 x 3 system a x = b in place. False if singular.
bool solve(double a[3][3], double b[3]) {
  for (int i = 0; i < 3; ++i) {
    int pivot = i;
    for (int row = i + 1; row < 3; ++row) {
      if (std::fabs(a[row][i]) > std::fabs(a[pivot][i])) {
        pivot = row;
      }
    }
    if (std::fabs(a[pivot][i]) < 1e-12) {
      return false;
    }
    if (pivot != i) {
      std::swap_ranges(a[i], a[i] + 3, a[pivot]);
      std::swap(b[i], b[pivot]);
    }
    for (int row = i + 1; row < 3; ++row) {
      const double factor = a[row][i] / a[i][i];
      for (int column = i; column < 3; ++column) {
        a[row][column] -= factor * a[i][column];
      }
      b[row] -= factor * b[i];
    }
  }
  for (int i = 2; i >= 0; --i) {
    for (int column = i + 1; column < 3; ++column) {
      b[i] -= a[i][column] * b[column];
    }
    b[i] /= a[i][i];
  }
  return true;
}

double leeway(const FitPoint& p) {
  return std::max(0.5 * std::min(p.high - p.low, 64.0), 0.05);
}

// Improves `fit`; with `fixed`, all but the angle.
bool refine(const std::vector<FitPoint>& points,
            bool curved,
            bool fixed,
            PrimitiveFit& fit) {
  const size_t count = points.size();
  static thread_local std::vector<double> weights;
  static thread_local std::vector<double> errors;
  weights.assign(count, 1.0);
  errors.resize(count);
  for (int round = 0; round < kRounds; ++round) {
    const double nx = std::cos(fit.angle);
    const double ny = std::sin(fit.angle);
    double m[3][3] = {};
    double r[3] = {};
    double worst = 1e-9;
    for (size_t i = 0; i < count; ++i) {
      const FitPoint& p = points[i];
      const double u = nx * p.x + ny * p.y;
      const double v = nx * p.y - ny * p.x;
      const double residual = p.d - (fit.d0 + u + 0.5 * fit.k * v * v);
      const double j[3] = {1, fixed ? 0 : v - fit.k * v * u,
                           curved ? 0.5 * v * v : 0};
      const double way = leeway(p);
      errors[i] = std::fabs(residual) / way;
      worst = std::max(worst, errors[i]);
      const double weight = weights[i] / (way * way);
      for (int a = 0; a < 3; ++a) {
        r[a] += weight * j[a] * residual;
        for (int b = 0; b < 3; ++b) {
          m[a][b] += weight * j[a] * j[b];
        }
      }
    }
    for (int a = 0; a < 3; ++a) {
      m[a][a] = m[a][a] * (1 + 1e-9) + 1e-9;
    }
    if (!solve(m, r)) {
      return false;
    }
    fit.d0 += r[0];
    fit.angle += std::clamp(r[1], -0.5, 0.5);
    fit.k += r[2];
    if (round >= 2) {
      for (size_t i = 0; i < count; ++i) {
        weights[i] *= 0.2 + errors[i] / worst;
      }
    }
  }
  return std::isfinite(fit.d0) && std::isfinite(fit.angle) &&
         std::isfinite(fit.k);
}

}  // namespace

bool fit_field(const std::vector<FitPoint>& points,
               bool curved,
               PrimitiveFit& out) {
  if (points.size() < 3) {
    return false;
  }
  // A plane to begin with.
  double m[3][3] = {};
  double r[3] = {};
  for (const FitPoint& p : points) {
    const double j[3] = {1, p.x, p.y};
    const double way = leeway(p);
    for (int a = 0; a < 3; ++a) {
      r[a] += j[a] * p.d / (way * way);
      for (int b = 0; b < 3; ++b) {
        m[a][b] += j[a] * j[b] / (way * way);
      }
    }
  }
  for (int a = 0; a < 3; ++a) {
    m[a][a] *= 1 + 1e-9;
  }
  if (!solve(m, r) || std::hypot(r[1], r[2]) < 0.2) {
    return false;
  }
  PrimitiveFit fit;
  fit.d0 = r[0];
  fit.angle = std::atan2(r[2], r[1]);
  if (!refine(points, curved, false, fit)) {
    return false;
  }
  out = fit;
  return true;
}

void fit_at_angle(const std::vector<FitPoint>& points,
                  bool curved,
                  PrimitiveFit& fit) {
  PrimitiveFit refined = fit;
  refined.k = curved ? fit.k : 0;
  if (refine(points, curved, true, refined)) {
    refined.angle = fit.angle;
    fit = refined;
  }
}

}  // namespace gen
}  // namespace inkcell
