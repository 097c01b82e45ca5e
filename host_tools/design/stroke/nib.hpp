// Pen nibs: ellipses and rectangles.
#pragma once

#include <string>
#include <vector>

#include "fit/vectors.hpp"

namespace inkcell::design {

/// The paper, section 5: a nib has a profile, a size and an angle, and they may
/// change along the stroke.
struct Nib {
  enum class Kind { ellipse, rectangle };

  Kind kind = Kind::ellipse;
  double width = 0;   // [u] along the angle
  double height = 0;  // [u] across
  double angle = 0;   // [radians] counter-clockwise from the x axis
};

/// Nibs are at least this wide and high, so that every stroke has area. [u]
inline constexpr double kLeastNib_u = 1.0 / 16;

/// Reads "ellipse:80,30,45" or "rectangle:80,30,45": width and height [u],
/// angle [degrees]; the height is the width, the angle 0 if left out. Throws
/// Error.
Nib parse_nib(const std::string& text);

/// Corners of a nib so that an ellipse's border is within `bound` of the
/// polygon. [u] A rectangle has four. All nibs of a stroke take the same
/// number.
int corner_count(const Nib& nib, double bound);

/// A convex polygon around the origin, counter-clockwise.
std::vector<Point> nib_polygon(const Nib& nib, int corners);

}  // namespace inkcell::design
