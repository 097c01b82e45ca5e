// One second-order field in direct form, and combinations of them, in real
// numbers: what docs/FORMAT.md ("Glyph record, type 2") says they are worth.
#pragma once

#include <cmath>
#include <cstdint>

namespace inkcell {
namespace gen {

/// The numbers of a field as they lie in ROM.
struct DirectField {
  int16_t nx = 0;  // Q14
  int16_t ny = 0;
  int16_t c = 0;   // Q4 u
  int16_t cw = 0;  // Q4 u
  int16_t k = 0;   // 2^-19 / u; 0: a line

  bool is_arc() const { return k != 0; }
  bool operator==(const DirectField& o) const {
    return nx == o.nx && ny == o.ny && c == o.c && k == o.k &&
           (k == 0 || cw == o.cw);
  }
};

/// The same in real numbers.
struct FieldModel {
  double nx = 0;
  double ny = 0;
  double c = 0;
  double cw = 0;
  double k = 0;

  FieldModel() = default;
  explicit FieldModel(const DirectField& field)
      : nx(field.nx / 16384.0),
        ny(field.ny / 16384.0),
        c(field.c / 16.0),
        cw(field.cw / 16.0),
        k(std::ldexp(field.k, -19)) {}

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

inline int field_count(Join join) {
  return join == Join::single                         ? 1
         : (join == Join::min2 || join == Join::max2) ? 2
                                                      : 3;
}

}  // namespace gen
}  // namespace inkcell
