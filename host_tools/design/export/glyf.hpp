// Outlines of TrueType: quadratic curves in whole font units.
#pragma once

#include <string>
#include <vector>

#include "export/sfnt.hpp"
#include "model/glyph.hpp"

namespace inkcell::design {

struct GlyfPoint {
  int x = 0;  // [font units]
  int y = 0;
  bool on_curve = true;
};

using GlyfContour = std::vector<GlyfPoint>;

/// Both ends inclusive. [font units]
struct GlyfBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// All zero without points.
GlyfBox box_of(const std::vector<GlyfContour>& contours);

/// How far quadratic curves may be from the cubics that they stand for.
/// [font units]
inline constexpr double kQuadraticBound = 0.3;

/// The closed contours with coordinates rounded; open ones are left out. Points
/// of quadratic curves stay as they are, cubics become as few quadratics as
/// keep kQuadraticBound.
///
/// Throws Error if a coordinate is beyond +-16383.
std::vector<GlyfContour> glyf_contours(
    const std::vector<PointContour>& contours);

/// What every record begins with; -1 contours: it holds components.
BigEndian glyf_header(int contours, const GlyfBox& box);

/// The record of a glyph without components; empty without contours.
BigEndian glyf_record(const std::vector<GlyfContour>& contours);

}  // namespace inkcell::design
