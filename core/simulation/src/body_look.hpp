// The points of a body in the distances of another, and the candidates for
// contacts that they make. For body_contacts.cpp only.
#pragma once

#include <stdint.h>

#include "inkcell/simulation/bodies.hpp"
#include "inkcell/simulation/body_contacts.hpp"
#include "limits.hpp"

namespace inkcell::simulation {

// A candidate for a contact, from the first body's centre. [px, Q8] The normal
// is not normalised yet. [Q13]
struct Touch {
  int32_t id;
  int32_t distance_q10;
  int32_t x;
  int32_t y;
  int32_t nx;
  int32_t ny;
  int32_t along;  // position across the line between the centres
};

// While contacts are sought, the entries after them hold candidates, so that
// the stack need not: soft_q10 is the id, below 0 if unused.
inline void keep(BodyContact& kept,
                 const Touch& touch,
                 bool is_better) noexcept {
  if (kept.soft_q10 < 0 || is_better) {
    kept.soft_q10 = touch.id;
    kept.gap_q10 = touch.distance_q10;
    kept.first_normal = touch.x;
    kept.first_tangent = touch.y;
    kept.nx = touch.nx;
    kept.ny = touch.ny;
    kept.second_normal = touch.along;
  }
}

// Not inline, to keep the candidate out of its callers' frames.
__attribute__((noinline)) inline void add_touch(BodyContact* kept,
                                                const Touch& touch,
                                                int32_t hard_q10,
                                                bool faces) noexcept {
  // Points that touch hard carry the body: the outermost of them are kept
  // rather than those of a soft rim.
  const bool is_hard = touch.distance_q10 > hard_q10;
  const auto is_kept = [&](const BodyContact& other, int32_t along,
                           int32_t other_along) {
    const bool is_other_hard = other.gap_q10 > hard_q10;
    return is_hard == is_other_hard ? along < other_along : is_hard;
  };
  keep(kept[0], touch, is_kept(kept[0], touch.along, kept[0].second_normal));
  keep(kept[1], touch, is_kept(kept[1], -touch.along, -kept[1].second_normal));
  BodyContact& deep = kept[faces ? 2 : 3];
  keep(deep, touch, touch.distance_q10 > deep.gap_q10);
}

// (x, y), y down, rotated; the sum of products fits 32 bits in Q14.
inline int32_t turned_x(const Turn& turn, int32_t x, int32_t y) noexcept {
  return turn.cosine * x + turn.sine * y;
}
inline int32_t turned_y(const Turn& turn, int32_t x, int32_t y) noexcept {
  return turn.cosine * y - turn.sine * x;
}

// Sums over the points of a body.
struct Sums {
  int32_t most;         // the greatest distance inside of the other [px, Q10]
  bool is_drawn;        // the members below are wanted
  int32_t lost_q6 = 0;  // of distances inside of the other [px]
  int32_t room_q9 = 0;  // of shares of a bulge
  int32_t outside = 0;  // the points there [1/2]

  // Points at most this far inside, that neither touch nor are bulged.
  void skip(int32_t most_q10, int32_t count, int32_t corners) noexcept {
    most = max(most, most_q10);
    outside += 2 * count - corners;
  }

  // Points at corners are closer together: each counts half.
  void add(int32_t distance_q10, bool is_corner, int32_t scale_log2) noexcept {
    const uint32_t half = is_corner ? 1 : 0;
    most = max(most, distance_q10);
    if (!is_drawn) {
      return;
    }
    if (distance_q10 > 0) {
      lost_q6 += distance_q10 >> (4 + half);
    } else {
      outside += is_corner ? 1 : 2;
      room_q9 += bulge_share(distance_q10, scale_log2) >> (1 + half);
    }
  }
};

// Looks up the points of `from` in the distances of `into`.
struct Look {
  const Body* from;
  const Body* into;
  int32_t x_between;  // from the second's centre to the first's [px, Q8]
  int32_t y_between;
  bool is_first;      // `from` is the first body of the pair
  int32_t hard_q10;   // distances above it touch hard [px]
  BodyContact* kept;  // the candidates; null: no memory

  __attribute__((noinline)) void add(int32_t id,
                                     const BodyPoint& point,
                                     const GridPoint& here) const noexcept {
    const Turn turn = turn_of(from->angle());
    Touch touch;
    touch.id = id;
    touch.distance_q10 = here.distance_q10;
    touch.x = turned_x(turn, point.x_q5, point.y_q5) >> 11;
    touch.y = turned_y(turn, point.x_q5, point.y_q5) >> 11;
    if (!is_first) {
      touch.x -= x_between;
      touch.y -= y_between;
    }
    const Turn of_field = turn_of(into->angle());
    int32_t nx = turned_x(of_field, here.x_slope_q13, here.y_slope_q13) >> 14;
    int32_t ny = turned_y(of_field, here.x_slope_q13, here.y_slope_q13) >> 14;
    touch.nx = is_first ? -nx : nx;
    touch.ny = is_first ? -ny : ny;
    touch.along =
        (touch.x >> 4) * (y_between >> 4) - (touch.y >> 4) * (x_between >> 4);
    const bool faces = (touch.nx >> 2) * (x_between >> 4) +
                           (touch.ny >> 2) * (y_between >> 4) >=
                       0;
    add_touch(kept, touch, hard_q10, faces);
  }

  // Keeps touches, and adds to `sums`.
  void find(Sums& sums) const noexcept {
    const BodyShape& shape = *into->shape;
    const DistanceGrid& grid = shape.grid();
    const ShapeField field(shape);
    const Turn of_into = turn_of(into->angle());
    const Turn back = {of_into.cosine, -of_into.sine};
    const Turn both = turn_of(Angle::from_raw(
        static_cast<uint16_t>(from->angle().raw - into->angle().raw)));
    // Between centres, below 1100 px. [Q5]
    const int32_t dx = is_first ? x_between >> 3 : -x_between >> 3;
    const int32_t dy = is_first ? y_between >> 3 : -y_between >> 3;
    // In `into`, from the centre of its grid's first sample. [px, Q16]
    const int32_t half = 32768 << grid.scale_log2();
    const int32_t x0 =
        (turned_x(back, dx, dy) >> 3) + shape.centre_x().raw - half;
    const int32_t y0 =
        (turned_y(back, dx, dy) >> 3) + shape.centre_y().raw - half;
    const int32_t nearest = field.at(x0, y0) + (from->shape->radius() << 10);
    if (nearest <= -(4096 << grid.scale_log2())) {
      sums.most = max(sums.most, nearest);
      return;
    }
    const BodyShape& own = *from->shape;
    const auto corners = static_cast<int32_t>(own.corner_count());
    const auto count = static_cast<int32_t>(own.points().size);
    const auto size = static_cast<int32_t>(own.group_size());
    const int32_t far = -(4096 << grid.scale_log2());  // nothing is bulged
    const int32_t least = kept == nullptr ? INT32_MAX : min(hard_q10, 0);
    const int32_t first_id = is_first ? 1 : (1 << 16) + 1;
    const BodyPoint* const points = own.points().data;
    int32_t group_end = 0;
    for (int32_t i = 0; i < count; ++i) {
      const int32_t x =
          x0 + (turned_x(both, points[i].x_q5, points[i].y_q5) >> 3);
      const int32_t y =
          y0 + (turned_y(both, points[i].x_q5, points[i].y_q5) >> 3);
      const int32_t distance = field.at(x, y);
      if (i == group_end) {
        group_end = min(i + size, count);
        const int32_t most =
            distance + (own.reach_of(static_cast<size_t>(i / size)) << 10);
        if (most <= far || (!sums.is_drawn && most <= min(sums.most, least))) {
          sums.skip(most, group_end - i, clamp(corners - i, 0, group_end - i));
          i = group_end - 1;
          continue;
        }
      }
      sums.add(distance, i < corners, grid.scale_log2());
      if (distance > least) {
        add(first_id + i, points[i],
            probe(grid, Q16_16::from_raw(x + half),
                  Q16_16::from_raw(y + half)));
      }
    }
  }
};

}  // namespace inkcell::simulation
