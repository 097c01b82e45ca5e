// Second-order fields in real numbers: what docs/FORMAT.md says the numbers of
// a record are worth.
#pragma once

#include <cmath>
#include <cstdint>

#include "edges/code.hpp"

namespace inkcell {
namespace gen {

inline bool is_arc(const PrimitiveNumbers& field) {
  return field.bend != 0;
}

inline bool same_primitive(const PrimitiveNumbers& a,
                           const PrimitiveNumbers& b) {
  return a.nx_q14 == b.nx_q14 && a.ny_q14 == b.ny_q14 && a.c_q4 == b.c_q4 &&
         a.bend == b.bend && (a.bend == 0 || a.along_q4 == b.along_q4);
}

/// A field in real numbers. [u]
struct Primitive {
  double nx = 0;
  double ny = 0;
  double c = 0;
  double cw = 0;
  double k = 0;

  Primitive() = default;
  explicit Primitive(const PrimitiveNumbers& field)
      : nx(field.nx_q14 / 16384.0),
        ny(field.ny_q14 / 16384.0),
        c(field.c_q4 / 16.0),
        cw(field.along_q4 / 16.0),
        k(std::ldexp(field.bend, -19)) {}

  double value(double x, double y) const {
    const double w = nx * y - ny * x + cw;
    return nx * x + ny * y + c + k * w * w;
  }

  void gradient(double x, double y, double& gx, double& gy) const {
    const double bend = 2 * k * (nx * y - ny * x + cw);
    gx = nx - bend * ny;
    gy = ny + bend * nx;
  }
};

/// How the fields of a cell are joined.
enum class Join : uint8_t {
  single,
  min2,
  max2,
  min3,
  max3,
  min_max,  // min(f0, max(f1, f2))
  max_min,  // max(f0, min(f1, f2))
};

inline constexpr int kJoins = 7;

inline int primitive_count(Join join) {
  return join == Join::single                         ? 1
         : (join == Join::min2 || join == Join::max2) ? 2
                                                      : 3;
}

/// Whether the last step takes the greatest.
inline bool takes_greatest(Join join) {
  return join == Join::max2 || join == Join::max3 || join == Join::max_min;
}

/// Whether two of three fields are joined first, the other way round.
inline bool is_nested(Join join) {
  return join == Join::min_max || join == Join::max_min;
}

}  // namespace gen
}  // namespace inkcell
