#include "trace/corner_census.hpp"

#include <algorithm>
#include <vector>

#include "fit/vectors.hpp"
#include "outlines/curves.hpp"
#include "outlines/unite.hpp"

namespace inkcell::design {
namespace {

constexpr double kCorner = 20 * gen::kDegree;
constexpr double kSlightCorner = 10 * gen::kDegree;
constexpr double kNear_u = 2;

struct Corner {
  Point at;
  double angle = 0;
};

std::vector<Corner> corners_of(const gen::Outline& outline) {
  std::vector<Corner> corners;
  for (const gen::Contour& contour : outline.contours) {
    std::vector<gen::Segment> segments;
    for (const gen::Segment& segment : contour.segments) {
      if (length(gen::direction_at_start(segment)) > 0) {
        segments.push_back(segment);
      }
    }
    for (size_t i = 0; i < segments.size(); ++i) {
      const gen::Segment& next = segments[(i + 1) % segments.size()];
      const double angle = std::fabs(turn(gen::direction_at_end(segments[i]),
                                          gen::direction_at_start(next)));
      corners.push_back({next.p[0], angle});
    }
  }
  return corners;
}

bool has_near(const std::vector<Corner>& corners,
              const Point& at,
              double angle) {
  return std::any_of(corners.begin(), corners.end(), [&](const Corner& c) {
    return c.angle > angle && length(c.at - at) < kNear_u;
  });
}

}  // namespace

void CornerCensus::add(const CornerCensus& other) {
  source += other.source;
  found += other.found;
  false_ones += other.false_ones;
}

CornerCensus count_corners(const gen::Outline& source,
                           const gen::Outline& result) {
  const std::vector<Corner> truth = corners_of(gen::unite(source));
  const std::vector<Corner> made = corners_of(result);
  CornerCensus census;
  for (const Corner& corner : truth) {
    if (corner.angle > kCorner) {
      ++census.source;
      census.found += has_near(made, corner.at, kSlightCorner) ? 1u : 0u;
    }
  }
  for (const Corner& corner : made) {
    if (corner.angle > kCorner) {
      census.false_ones += has_near(truth, corner.at, kSlightCorner) ? 0u : 1u;
    }
  }
  return census;
}

}  // namespace inkcell::design
