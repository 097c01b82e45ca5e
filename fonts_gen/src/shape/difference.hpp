// What one filled area has and another one lacks.
#pragma once

#include <vector>

#include "shape/shape.hpp"

namespace inkcell::gen {

/// The area of `a` without that of `b`: closed polygons, outer ones
/// counter-clockwise, holes clockwise. Coordinates are rounded to 1/65536 u.
///
/// Throws GeometryError.
std::vector<std::vector<Point>> difference(const Shape& a, const Shape& b);

}  // namespace inkcell::gen
