// Boolean operations on contours, whose curves are kept.
#pragma once

#include <string>
#include <vector>

#include "model/glyph.hpp"

namespace inkcell::design {

/// The area of `a` combined with that of `b`, each filled where the winding
/// number is not zero: "union", "intersection", "difference" (a without b) or
/// "exclusion" (in one of both). Counter-clockwise around ink.
///
/// Contours and curves that the other area leaves whole keep their points. New
/// points, where contours cross, are whole font units, and so are the handles
/// of curves that are cut. Open contours are kept.
///
/// Throws Error for an unknown `operation`.
std::vector<PointContour> combined(const std::vector<PointContour>& a,
                                   const std::vector<PointContour>& b,
                                   const std::string& operation);

}  // namespace inkcell::design
