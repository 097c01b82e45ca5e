// Distances and gradients at points that lie close to each other.
//
// What painters are made of: any number of points to a pixel, on rows with any
// step, upright or turned. The cell of the last point is kept,
// and its fields as they are at the glyph's origin, from where a point takes
// two products a field, four if it is bent.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/render.hpp"
#include "inkcell/text_style.hpp"
#include "place/position.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// A place on the screen relative to another. [px, Q10]
struct ScreenOffset {
  int32_t right_q10;
  int32_t up_q10;
};

inline FieldPosition moved(const FieldPosition& at,
                           const FieldPosition& by) noexcept {
  // In u, too, far from any cell it may wrap.
  const auto sum = [](int32_t a, int32_t b) noexcept {
    return wrapped(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
  };
  return {sum(at.x_q16, by.x_q16), sum(at.y_q16, by.y_q16), at.x_q20 + by.x_q20,
          at.y_q20 + by.y_q20};
}

inline FieldPosition moved_back(const FieldPosition& at,
                                const FieldPosition& by) noexcept {
  return moved(at, {-by.x_q16, -by.y_q16, 0u - by.x_q20, 0u - by.y_q20});
}

// A way of so many px. [Q10]
inline FieldPosition scaled(const GlyphStep& step, int32_t way_q10) noexcept {
  const auto part = [way_q10](int32_t whole) noexcept {
    return static_cast<int32_t>((int64_t{whole} * way_q10) >> 10);
  };
  return {part(step.x_q16), part(step.y_q16),
          static_cast<uint32_t>(part(step.x_q20)),
          static_cast<uint32_t>(part(step.y_q20))};
}

// From a pixel to the next one on its right.
inline FieldPosition pixel_step(const TextStyle& style) noexcept {
  const GlyphStep& right = style.right();
  return {right.x_q16, right.y_q16, static_cast<uint32_t>(right.x_q20),
          static_cast<uint32_t>(right.y_q20)};
}

// Where the point lies that is `offset` away from the centre of pixel (x, y).
// From here pixel_step() leads to the same point of the next pixels, exactly:
// no picture depends on where a row begins.
FieldPosition sample_position(const TextStyle& style,
                              const FinePoint& origin,
                              int32_t x,
                              int32_t y,
                              ScreenOffset offset) noexcept;

// The pixels that a painter may touch.
Rect painted_box(const GlyphField& field,
                 const TextStyle& style,
                 const FinePoint& origin,
                 const Sink& sink) noexcept;

// A gradient as the screen shows it. [Q14] A unit vector where cells are made
// of fields, about that where they are made of samples, 0 if saturated.
struct ScreenGradient {
  int16_t right_q14;
  int16_t up_q14;
};

// What lies around a point: a radius on the screen, and what it is at the most
// along the axes of the glyph.
struct Surroundings {
  int32_t radius_q10;  // [px]
  int32_t x_q16;       // [u]
  int32_t y_q16;
};

class PointWalk {
 public:
  // `reach_q22` as fields_distance_q10 takes it: reach_of(filter), or kNoReach
  // where distances matter beyond the ramp.
  PointWalk(const GlyphField& field,
            const TextStyle& style,
            int32_t reach_q22) noexcept
      : field_(field),
        style_(style),
        reach_q22_(reach_q22),
        saturated_q10_(style.to_px_q10(-kSaturatedDistanceQ10)) {}

  // What distance_row says of a pixel whose centre is here, but that distances
  // of fields are not clamped to 32 px. [px, Q10]
  int32_t distance_q10(const FieldPosition& at) noexcept;

  // The same at a point close to the last one. Of fields by those of its cell,
  // which go on beyond it: half the cost, and nearly as true.
  int32_t near_q10(const FieldPosition& at) noexcept {
    return !is_saturated_ && is_of_fields() ? fields_q10(at) : distance_q10(at);
  }

  ScreenGradient gradient(const FieldPosition& at) noexcept;

  // Whether the last point lay in a cell that is saturated, or in none.
  bool is_saturated() const noexcept { return is_saturated_; }

  // The width of that cell: 1 u beyond the grid. [log2, u]
  uint32_t cell_log2() const noexcept { return size_log2_; }

  // Whether the field is known to be a plane, or saturated, all around the last
  // point, `at`.
  bool is_plane_around(const FieldPosition& at,
                       const Surroundings& around) const noexcept;

 private:
  // Whether the last point's cell has fields, if it is not saturated.
  bool is_of_fields() const noexcept {
    return INKCELL_EDGE_CELLS != 0 &&
           (INKCELL_SAMPLE_CELLS == 0 || samples_ == nullptr);
  }
  bool are_fields_plane(const FieldPosition& at,
                        int32_t radius_q10) const noexcept;
  bool are_samples_plane(int32_t radius_q10) const noexcept;
  void go_to(const FieldPosition& at) noexcept;
  int32_t fields_q10(const FieldPosition& at) const noexcept;
  int32_t samples_q10(const FieldPosition& at) noexcept;

  const GlyphField& field_;
  const TextStyle& style_;
  int32_t reach_q22_;
  // A point of the cell, from the grid's corner: at first one outside of it.
  uint32_t x_u_ = UINT32_MAX;
  uint32_t y_u_ = UINT32_MAX;
  uint32_t size_log2_ = 0;
  bool is_saturated_ = true;
  int32_t saturated_q10_;  // [px]
  FieldTerms terms_;       // at the origin
  const uint8_t* samples_ = nullptr;
  SamplesRow row_;
  int32_t row_y_q16_ = INT32_MIN;  // where row_ is set up
};

}  // namespace detail
}  // namespace inkcell
