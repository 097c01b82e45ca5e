#include "distance/point_walk.hpp"

#include "cells/cell_access.hpp"
#include "cells/field_cell.hpp"

namespace inkcell {
namespace detail {
namespace {

// A term set up at the origin, at a point. [px, Q8]
FieldTerm term_at(const FieldTerm& origin,
                  uint32_t x_q8,
                  uint32_t y_q8) noexcept {
  FieldTerm term = origin;
  term.plane_q22 += times(term.nx_q14, x_q8) + times(term.ny_q14, y_q8);
  if (term.bend != 0) {
    term.along_q22 += times(term.nx_q14, y_q8) - times(term.ny_q14, x_q8);
  }
  return term;
}

FieldTerms terms_at(const FieldTerms& origin,
                    const FieldPosition& at) noexcept {
  const uint32_t x_q8 = q8_of(at.x_q20);
  const uint32_t y_q8 = q8_of(at.y_q20);
  FieldTerms terms;
  terms.count = origin.count;
  terms.op = origin.op;
  for (uint32_t i = 0; i < origin.count; ++i) {
    terms.term[i] = term_at(origin.term[i], x_q8, y_q8);
  }
  return terms;
}

// Two components below 2 times a sine and a cosine.
int16_t turned_q14(int32_t a_q14,
                   Fixed<int32_t, 30> p,
                   int32_t b_q14,
                   Fixed<int32_t, 30> q) noexcept {
  const int32_t sum = a_q14 * (p.raw >> 16) + b_q14 * (q.raw >> 16);
  const int32_t rounded = sum >> 14;
  return static_cast<int16_t>(rounded > INT16_MAX   ? INT16_MAX
                              : rounded < INT16_MIN ? INT16_MIN
                                                    : rounded);
}

}  // namespace

FieldPosition sample_position(const TextStyle& style,
                              const FinePoint& origin,
                              int32_t x,
                              int32_t y,
                              ScreenOffset offset) noexcept {
  const FinePoint from = {origin.x_q10 - offset.right_q10,
                          origin.y_q10 + offset.up_q10};
  if (!style.is_upright()) {
    // Not clamped: rows of the largest grids begin 2^15 u and more away, where
    // positions wrap, but into no grid as far as painters reach, some 30 px.
    const GlyphWay way(style, ScreenWay(from, x, y));
    return {wrapped(static_cast<uint32_t>(way.x_q16)),
            wrapped(static_cast<uint32_t>(way.y_q16)), way.x_q20, way.y_q20};
  }
  return position_of(style, from, x, y);
}

Rect painted_box(const GlyphField& field,
                 const TextStyle& style,
                 const FinePoint& origin,
                 const Sink& sink) noexcept {
  return intersect(field_box(field, style, origin), sink.window);
}

void PointWalk::go_to(const FieldPosition& at) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  const uint32_t x = static_cast<uint32_t>(x_u - field_.x0_u);
  const uint32_t y = static_cast<uint32_t>(y_u - field_.y0_u);
  if (((x ^ x_u_) | (y ^ y_u_)) >> size_log2_ == 0) {
    return;
  }
  Cell cell;
  if (in_grid(field_, x_u, y_u)) {
    cell = locate(field_, x_u, y_u);
  }
  x_u_ = x;
  y_u_ = y;
  size_log2_ = cell.size_log2;  // 0 beyond the grid
  is_saturated_ = cell.is_saturated();
  samples_ = cell.samples;
  row_y_q16_ = INT32_MIN;
  if (is_saturated_) {
    saturated_q10_ = style_.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                                  : -kSaturatedDistanceQ10);
  } else if (is_of_fields()) {
    set_up_terms(terms_, field_, cell, 0, 0, scale_of(style_));
  }
}

int32_t PointWalk::fields_q10(const FieldPosition& at) const noexcept {
  const int32_t bend_shift = style_.bend_shift();
  if (terms_.count == 1) {
    return term_at(terms_.term[0], q8_of(at.x_q20), q8_of(at.y_q20))
               .value_q22(bend_shift) >>
           12;
  }
  return combine_q22(terms_at(terms_, at), bend_shift, reach_q22_) >> 12;
}

int32_t PointWalk::samples_q10(const FieldPosition& at) noexcept {
  // The cell's lower left corner, from the grid's.
  const auto corner_q16 = [this](uint32_t place) noexcept {
    return static_cast<int32_t>((place >> size_log2_) << (size_log2_ + 16));
  };
  const int32_t y_q16 = at.y_q16 - field_.y0_u * (1 << 16) - corner_q16(y_u_);
  if (y_q16 != row_y_q16_) {
    set_up_row(row_, samples_, static_cast<uint8_t>(size_log2_), y_q16);
    row_y_q16_ = y_q16;
  }
  return style_.to_px_q10(
      row_.distance_q10(at.x_q16 - field_.x0_u * (1 << 16) - corner_q16(x_u_)));
}

// A field that is bent by no more than 1/32 px, or several of which the same
// one decides everywhere: each changes by no more than the radius.
bool PointWalk::are_fields_plane(const FieldPosition& at,
                                 int32_t radius_q10) const noexcept {
  constexpr int32_t kMaxSagQ22 = 1 << 17;
  const int32_t bend_shift = style_.bend_shift();
  if (terms_.count == 1) {
    const int32_t radius_q8 = radius_q10 >> 2;
    const int32_t slope_q15 = (terms_.term[0].bend * radius_q8) >> bend_shift;
    const int32_t sag_q22 = (slope_q15 * radius_q8) >> 1;
    return sag_q22 < kMaxSagQ22 && sag_q22 > -kMaxSagQ22;
  }
  const FieldTerms terms = terms_at(terms_, at);
  int64_t value[3];
  for (uint32_t i = 0; i < terms.count; ++i) {
    value[i] = terms.term[i].value_q22(bend_shift);
  }
  const int64_t apart = int64_t{radius_q10} << 13;
  const auto differ = [&value, apart](uint32_t i, uint32_t j) noexcept {
    const int64_t difference = value[i] - value[j];
    return difference >= apart || difference <= -apart;
  };
  if (terms.count == 2) {
    return differ(0, 1);
  }
  if (terms.op >= Csg::intersection_of_union) {
    return differ(0, 1) && differ(0, 2) && differ(1, 2);
  }
  uint32_t first = 0;
  for (uint32_t i = 1; i < 3; ++i) {
    const bool is_less = value[i] < value[first];
    first = is_less == (terms.op == Csg::intersection) ? i : first;
  }
  return differ(first, (first + 1) % 3) && differ(first, (first + 2) % 3);
}

// Nine samples that lie on a plane: where they do not, their second differences
// over the cell shrink with the square of the way that is asked for.
bool PointWalk::are_samples_plane(int32_t radius_q10) const noexcept {
  constexpr int32_t kMaxSagQ10 = 1 << 5;
  const int32_t cell_q10 = style_.to_px_q10(int32_t{1} << (10 + size_log2_));
  if (cell_q10 <= 2 * radius_q10) {
    return false;
  }
  const uint8_t* const at = samples_ + format::samples::kOffsets;
  const auto offset = [at](int32_t place) noexcept {
    // The centre, the fifth of nine, is not stored: it is 0.
    return place == 4 ? 0
                      : int32_t{static_cast<int8_t>(
                            at[place < 4 ? place : place - 1])};
  };
  int32_t most = 0;
  for (int32_t i = 0; i < 3; ++i) {
    const int32_t second[] = {
        offset(3 * i) + offset(3 * i + 2) - 2 * offset(3 * i + 1),
        offset(i) + offset(i + 6) - 2 * offset(i + 3)};
    for (const int32_t difference : second) {
      const int32_t size = difference < 0 ? -difference : difference;
      most = size > most ? size : most;
    }
  }
  // Quanta are 1/128 of the cell; the differences are those of half a cell.
  const int64_t sag_q10 = (int64_t{most} * cell_q10) >> 8;
  const int64_t part_q10 = (int64_t{radius_q10} << 11) / cell_q10;
  return (sag_q10 * part_q10 * part_q10) >> 20 < kMaxSagQ10;
}

bool PointWalk::is_plane_around(const FieldPosition& at,
                                const Surroundings& around) const noexcept {
  // Beyond the grid a cell has no room for anything.
  const uint32_t side = uint32_t{1} << (size_log2_ + 16);
  const auto has_room = [side](uint32_t place_q16, int32_t room_q16) noexcept {
    const uint32_t room = static_cast<uint32_t>(room_q16);
    place_q16 &= side - 1;
    return place_q16 >= room && place_q16 + room < side;
  };
  const auto from = [](int32_t place_q16, int32_t corner_u) noexcept {
    return static_cast<uint32_t>(place_q16) -
           (static_cast<uint32_t>(corner_u) << 16);
  };
  if (!has_room(from(at.x_q16, field_.x0_u), around.x_q16) ||
      !has_room(from(at.y_q16, field_.y0_u), around.y_q16)) {
    return false;
  }
  if (is_saturated_) {
    return true;
  }
  return is_of_fields() ? are_fields_plane(at, around.radius_q10)
                        : are_samples_plane(around.radius_q10);
}

int32_t PointWalk::distance_q10(const FieldPosition& at) noexcept {
  go_to(at);
  if (is_saturated_) {
    return saturated_q10_;
  }
  return is_of_fields() ? fields_q10(at) : samples_q10(at);
}

ScreenGradient PointWalk::gradient(const FieldPosition& at) noexcept {
  go_to(at);
  if (is_saturated_) {
    return {0, 0};
  }
  Gradient gradient;
  if (is_of_fields()) {
    gradient = combined_gradient(terms_at(terms_, at), style_.bend_shift());
  } else {
    gradient = gradient_at(field_, Q16_16::from_raw(at.x_q16),
                           Q16_16::from_raw(at.y_q16));
  }
  if (style_.is_upright()) {
    return {gradient.x.raw, gradient.y.raw};
  }
  const Direction turn = style_.direction();
  const Fixed<int32_t, 30> minus_sine =
      Fixed<int32_t, 30>::from_raw(-turn.sine.raw);
  return {turned_q14(gradient.x.raw, turn.cosine, gradient.y.raw, minus_sine),
          turned_q14(gradient.x.raw, turn.sine, gradient.y.raw, turn.cosine)};
}

}  // namespace detail
}  // namespace inkcell
