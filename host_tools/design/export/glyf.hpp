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

/// The record of the glyph, empty for one without contours.
BigEndian glyf_record(const std::vector<GlyfContour>& contours);

}  // namespace inkcell::design
