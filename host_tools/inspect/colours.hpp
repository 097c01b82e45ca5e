// Colours of pictures, and how fields are shown by them.
#pragma once

#include <algorithm>
#include <cmath>

#include "image.hpp"

namespace inkcell::tools {

struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

inline Colour mix(const Colour& a, const Colour& b, double share_of_b) {
  const double t = std::clamp(share_of_b, 0.0, 1.0);
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

inline void put(Image& image, int x, int y, const Colour& colour) {
  uint8_t* pixel = image.at(x, y);
  pixel[0] = static_cast<uint8_t>(std::lround(colour.red));
  pixel[1] = static_cast<uint8_t>(std::lround(colour.green));
  pixel[2] = static_cast<uint8_t>(std::lround(colour.blue));
}

inline Colour get(const Image& image, int x, int y) {
  const uint8_t* pixel = image.at(x, y);
  return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
          static_cast<double>(pixel[2])};
}

/// The field at a point.
struct FieldSample {
  double distance_u = 0;  // positive inside
  bool is_saturated = false;
};

/// Strongest at the edge, fading away from it on both sides; saturated areas
/// are flat. The edge itself is a line 2 px wide.
inline Colour field_colour(const FieldSample& sample, double px_per_u) {
  constexpr Colour kEdge = {24, 32, 48};
  constexpr Colour kInsideNear = {222, 104, 66};
  constexpr Colour kInsideFar = {252, 214, 164};
  constexpr Colour kOutsideNear = {136, 176, 214};
  constexpr Colour kOutsideFar = {238, 244, 250};
  constexpr Colour kSaturated = {255, 255, 255};
  // Distance over which the colours change. [u] They go in steps, which show
  // as lines of equal distance and keep files small.
  constexpr double kFade = 96;
  constexpr double kBandStep = 8;
  const double distance = std::fabs(sample.distance_u);
  const double band = std::floor(distance / kBandStep) * kBandStep;
  Colour colour = kSaturated;
  if (sample.distance_u > 0) {
    colour =
        mix(kInsideNear, kInsideFar, sample.is_saturated ? 1 : band / kFade);
  } else if (!sample.is_saturated) {
    colour = mix(kOutsideNear, kOutsideFar, band / kFade);
  }
  return mix(colour, kEdge, std::clamp(1.5 - distance * px_per_u, 0.0, 1.0));
}

}  // namespace inkcell::tools
