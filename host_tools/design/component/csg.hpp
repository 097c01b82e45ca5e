// Boolean operations on shapes: union, intersection, difference, and smooth
// blends.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {

enum class Combination { unite, intersect, subtract, blend };

/// Combines two shapes. The result is a shape with exact distances; combining
/// fields point by point gives none (too small in magnitude on one side). Sharp
/// combinations are exact to 1/65536 u.
///
/// blend: the union with fillets in its corners, as BlendField has it;
/// `radius_u` is k > 0. Its edge is traced and measured again, to 1/16 u.
///
/// Throws gen::GeometryError.
gen::Shape combine(const gen::Shape& a,
                   const gen::Shape& b,
                   Combination combination,
                   double radius_u = 0);

/// The border as closed polygons, filled on the left.
std::vector<std::vector<gen::Point>> polygons_of(const gen::Shape& shape);

}  // namespace inkcell::design
