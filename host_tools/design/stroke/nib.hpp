// Pen nibs: ellipses and rectangles.
#pragma once

#include <string>
#include <vector>

#include "fit/vectors.hpp"

namespace inkcell::design {

/// A nib (the paper, section 5): profile, size and angle, which may change
/// along the stroke.
struct Nib {
  enum class Kind { ellipse, rectangle };

  Kind kind = Kind::ellipse;
  double width = 0;   // [u] along the angle
  double height = 0;  // [u] across
  double angle = 0;   // [radians] counter-clockwise from the x axis
};

/// The least width and height of nibs, so that every stroke has area. [u]
inline constexpr double kLeastNib_u = 1.0 / 16;

/// Parses "ellipse:80,30,45" or "rectangle:80,30,45": width and height [u],
/// angle [degrees]. The default height is the width, the default angle 0.
/// Throws Error.
Nib parse_nib(const std::string& text);
std::string text_of(const Nib& nib);

/// The number of corners that puts an ellipse within `bound` of the polygon
/// [u]; 4 for a rectangle. All nibs of a stroke use the same number.
int corner_count(const Nib& nib, double bound);

/// A convex polygon around the origin, counter-clockwise.
std::vector<Point> nib_polygon(const Nib& nib, int corners);

}  // namespace inkcell::design
