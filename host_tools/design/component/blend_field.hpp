// The distance to a blend of two shapes: their union with fillets in corners.
#pragma once

#include <vector>

#include "fit/vectors.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {

/// max(a, b) + w h^2 / (4 k), h = max(k - |a - b|, 0), of the distances to both
/// shapes. The weight w is 0 but in corners of the union, where the edges of
/// both cross: 1 between edges that cross at right angles or more sharply,
/// less where they cross at smaller angles. Edges that run side by side, and
/// shapes that do not cross, stay.
class BlendField {
 public:
  /// `radius` is k, above 0. [u]
  BlendField(const gen::Shape& a, const gen::Shape& b, double radius);

  double distance(const Point& p) const;
  /// What the blend adds to the union's distance.
  double swell(const Point& p) const;
  /// Around the blend.
  gen::Box box() const;

 private:
  // A corner of the union, with the normals of both edges away from ink.
  struct Corner {
    Point at;
    Point normal_a;
    Point normal_b;
    double reach = 0;   // of the fillet along the edges [u]
    double weight = 0;  // by the angle
  };

  double weight_at(const Point& p) const;
  double swell_of(const Point& p, double a, double b) const;

  gen::Shape a_;
  gen::Shape b_;
  double radius_;
  std::vector<Corner> corners_;
};

}  // namespace inkcell::design
