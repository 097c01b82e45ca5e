// The shape of a rigid glyph: distances, points on its edge, mass and inertia.
//
//   int8_t samples[40 * 48];
//   BodyPoint points[64];
//   DistanceGrid grid(samples, 40, 48, 0);
//   INKCELL_TRY(grid.paint(font, glyph, size, origin));
//   BodyShape shape;
//   INKCELL_TRY(shape.make(grid, points));
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell::simulation {

/// A point on the edge, relative to the centre of mass. [1/32 px, y down]
struct BodyPoint {
  int16_t x_q5 = 0;
  int16_t y_q5 = 0;
};

/// Made once from a grid; any number of bodies can share it. Refers to the
/// samples and points, which must outlive it.
class BodyShape {
 public:
  /// The largest side of a grid [px], so that points fit 16 bits.
  static constexpr int32_t kMostSidePx = 512;

  /// Measures a grid and spreads points over its edges: corners first, then as
  /// close together as `room` allows, at least 1.5 sample sides apart. A grid
  /// of one sample a pixel places corners to 0.3 px; points 2 px apart are
  /// good.
  ///
  /// bad_argument: the grid has no ink, or a side is longer than kMostSidePx.
  /// buffer_small: `room` holds fewer than 8 points. In both cases the shape is
  /// unchanged.
  Status make(const motion::DistanceGrid& grid, Span<BodyPoint> room) noexcept;

  const motion::DistanceGrid& grid() const noexcept { return grid_; }
  Span<const BodyPoint> points() const noexcept { return points_; }
  /// The centre of mass. [px from the grid's upper left corner]
  Q16_16 centre_x() const noexcept { return centre_x_; }
  Q16_16 centre_y() const noexcept { return centre_y_; }
  /// The mass: the area of the ink, at least 1. [px^2]
  int32_t area() const noexcept { return area_; }
  /// The square of the radius of gyration: the moment of inertia over the mass.
  /// [px^2, Q8] At least 1/4.
  int32_t gyration_q8() const noexcept { return gyration_q8_; }
  /// The greatest distance of a point from the centre of mass. [px]
  int32_t radius() const noexcept { return radius_; }
  /// 1 / area [Q30], 1 / gyration [Q20], 1 / radius [Q23]: dividing in each
  /// push takes a third of a step.
  int32_t per_area_q30() const noexcept { return per_area_q30_; }
  int32_t per_gyration_q20() const noexcept { return per_gyration_q20_; }
  int32_t per_radius_q23() const noexcept { return per_radius_q23_; }
  /// Half of the mean width of its strokes. [px, Q10]
  int32_t depth_q10() const noexcept { return depth_q10_; }
  /// The length of edge that a point stands for, half of it at corners, whose
  /// points are the first. [px, Q5]
  int32_t spacing_q5() const noexcept { return spacing_q5_; }
  size_t corner_count() const noexcept { return corner_count_; }
  /// Points are in groups of this many that are next to each other.
  size_t group_size() const noexcept { return group_size_; }
  /// An upper bound of the distance of a group's points from its first. [px]
  int32_t reach_of(size_t group) const noexcept { return reach_[group]; }
  /// A lower bound of the distance from the grid's border to the shape. Added
  /// to distances outside of the grid. [px, Q10]
  int32_t margin_q10() const noexcept { return margin_q10_; }

 private:
  bool weigh() noexcept;
  void measure() noexcept;
  size_t spread(int32_t spacing_q5, Span<BodyPoint> room) noexcept;
  void group() noexcept;
  bool find_edge_point(int32_t column,
                       int32_t row,
                       BodyPoint& out,
                       bool& is_corner) const noexcept;

  motion::DistanceGrid grid_;
  Span<const BodyPoint> points_;
  Q16_16 centre_x_;
  Q16_16 centre_y_;
  int32_t area_ = 1;
  int32_t gyration_q8_ = 256;
  int32_t radius_ = 0;
  int32_t per_area_q30_ = 1 << 30;
  int32_t per_gyration_q20_ = 1 << 20;
  int32_t per_radius_q23_ = 1 << 23;
  int32_t depth_q10_ = 0;
  int32_t margin_q10_ = 0;
  int32_t spacing_q5_ = 0;
  size_t corner_count_ = 0;
  static constexpr size_t kMostGroups = 16;
  size_t group_size_ = 1;
  uint16_t reach_[kMostGroups] = {};
};

}  // namespace inkcell::simulation
