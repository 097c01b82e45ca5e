#include "fit/parabola.hpp"

#include <cmath>

namespace inkcell::design {

Parabola fit_parabola(const std::vector<double>& s,
                      const std::vector<Point>& points) {
  const int degree = s.size() >= 6 ? 2 : 1;
  double m[3][5] = {};
  for (size_t i = 0; i < s.size(); ++i) {
    double powers[3] = {1, s[i], s[i] * s[i]};
    for (int r = 0; r <= degree; ++r) {
      for (int c = 0; c <= degree; ++c) {
        m[r][c] += powers[r] * powers[c];
      }
      m[r][3] += powers[r] * points[i].x;
      m[r][4] += powers[r] * points[i].y;
    }
  }
  for (int k = 0; k <= degree; ++k) {  // positive definite: no pivoting
    for (int r = 0; r <= degree; ++r) {
      if (r == k || m[k][k] == 0) {
        continue;
      }
      const double f = m[r][k] / m[k][k];
      for (double *to = m[r], *from = m[k]; to != m[r] + 5; ++to, ++from) {
        *to -= f * *from;
      }
    }
  }
  Parabola result;
  for (int k = 0; k <= degree; ++k) {
    if (m[k][k] != 0) {
      result.c[k] = {m[k][3] / m[k][k], m[k][4] / m[k][k]};
    }
  }
  return result;
}

}  // namespace inkcell::design
