// The zero contour of a glyph's field, as dense points.
#pragma once

#include <functional>
#include <vector>

#include "fit/loop.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "shape/shape.hpp"

namespace inkcell::design {

/// The distance of `field` at a place. [u]
double distance_u(const GlyphField& field, const Point& p);

/// Follows the edge of `field` through the leaves of its quadtree (Perry and
/// Frisken, section 5). Leaves that the edge crosses are found by their
/// distances; in them the edge is followed through squares of 1 u, by its
/// crossings with their sides. Every loop is closed. Coordinates in u, filled
/// on the left; tangents by the field's gradient.
std::vector<Loop> walk_contours(const GlyphField& field);

/// The same for any distance, positive inside, that changes by at most 1 u per
/// u, within a box that contains the contour. [u] Throws gen::GeometryError if
/// the box is larger than 8 em by 8 em.
std::vector<Loop> walk_contours(
    const std::function<double(const Point&)>& distance, const gen::Box& box);

}  // namespace inkcell::design
