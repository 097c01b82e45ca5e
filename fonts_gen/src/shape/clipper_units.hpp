// Coordinates as Clipper takes them: whole numbers.
#pragma once

#include <cmath>
#include <polyclipping/clipper.hpp>
#include <utility>

#include "shape/outline.hpp"

namespace inkcell::gen {

// Below 2^30 Clipper needs no 128-bit products, and products of two coordinates
// are exact enough in its doubles.
inline constexpr double kClipperUnits_per_u = 65536;
static_assert(kCoordinateLimit * kClipperUnits_per_u < 0x3fffffff,
              "outlines must stay in Clipper's fast range");

inline ClipperLib::IntPoint to_clipper(const Point& p) {
  return {std::llround(p.x * kClipperUnits_per_u),
          std::llround(p.y * kClipperUnits_per_u)};
}

inline Point from_clipper(const ClipperLib::IntPoint& p) {
  return {static_cast<double>(p.X) / kClipperUnits_per_u,
          static_cast<double>(p.Y) / kClipperUnits_per_u};
}

/// Each path as a contour of lines.
inline Outline outline_of(const ClipperLib::Paths& paths) {
  Outline outline;
  for (const ClipperLib::Path& path : paths) {
    Contour contour;
    for (size_t i = 0; i < path.size(); ++i) {
      contour.segments.push_back(line_segment(
          from_clipper(path[i]), from_clipper(path[(i + 1) % path.size()])));
    }
    outline.contours.push_back(std::move(contour));
  }
  return outline;
}

/// The result of an operation. Throws GeometryError with `failure`.
inline ClipperLib::Paths executed(ClipperLib::Clipper& clipper,
                                  ClipperLib::ClipType operation,
                                  const char* failure) {
  ClipperLib::Paths paths;
  try {
    if (clipper.Execute(operation, paths, ClipperLib::pftNonZero,
                        ClipperLib::pftNonZero)) {
      return paths;
    }
  } catch (const ClipperLib::clipperException&) {
    // Refused below, as the other failures.
  }
  throw GeometryError(GeometryError::Kind::not_united, failure);
}

}  // namespace inkcell::gen
