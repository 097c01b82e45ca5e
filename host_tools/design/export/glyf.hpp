// Outlines of TrueType: quadratic curves in integer font units.
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

/// All zero if there are no points.
GlyfBox box_of(const std::vector<GlyfContour>& contours);

/// The largest distance of quadratics from the cubics that they replace. [font
/// units]
inline constexpr double kQuadraticBound = 0.3;

/// The closed contours with rounded coordinates; open ones are left out. Points
/// of quadratics are kept; cubics become as few quadratics as kQuadraticBound
/// allows.
///
/// Throws Error if a coordinate is beyond +-16383.
std::vector<GlyfContour> glyf_contours(
    const std::vector<PointContour>& contours);

/// The head of each record; contours = -1: it holds components.
BigEndian glyf_header(int contours, const GlyfBox& box);

/// The record of a glyph without components; empty without contours.
BigEndian glyf_record(const std::vector<GlyfContour>& contours);

}  // namespace inkcell::design
