// Fields at any points of a leaf: set up once, then evaluated at each for
// itself.
#pragma once

#include <stdint.h>

#include "cells/field_cell.hpp"
#include "distance/row_terms.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// A line at any point, with the leaf's sign.
struct LineAt {
  int32_t nx_q14;
  int32_t ny_q14;
  uint32_t offset_q22;

  LineAt() = default;

  __attribute__((always_inline)) LineAt(const uint8_t* record,
                                        const FieldScale& scale,
                                        int32_t sign) noexcept {
    namespace layout = format::edges;
    nx_q14 = with_sign(load_i16(record + layout::kNormalX), sign);
    ny_q14 = with_sign(load_i16(record + layout::kNormalY), sign);
    offset_q22 = times(with_sign(load_i16(record + layout::kOffset), sign),
                       scale.size_q8);
  }

  __attribute__((always_inline)) uint32_t plane_q22(
      const PixelPlace& at) const noexcept {
    return times(nx_q14, at.x_q8) + times(ny_q14, at.y_q8) + offset_q22;
  }
  __attribute__((always_inline)) int32_t value(const PixelPlace& at,
                                               int32_t,
                                               int32_t) const noexcept {
    return wrapped(plane_q22(at));
  }
};

// The same of an arc, or of a line that is treated like one. It takes a sign as
// LineAt does, but leaves it to value().
struct ArcAt {
  LineAt plane;
  uint32_t along_q22;  // of the origin; it and `bend` as in FieldTerm
  int32_t bend;

  ArcAt() = default;
  __attribute__((always_inline))
  ArcAt(const uint8_t* field, const FieldScale& scale, int32_t) noexcept
      : plane(field - arc_bit(field), scale, 0), along_q22(0), bend(0) {
    namespace layout = format::edges;
    if (arc_bit(field) != 0) {
      const uint8_t* const record = field - 1;
      along_q22 =
          (1 << 13) + times(load_i16(record + layout::kAlong), scale.size_q8);
      bend =
          (load_i16(record + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
    }
  }

  __attribute__((always_inline)) int32_t value(const PixelPlace& at,
                                               int32_t bend_shift,
                                               int32_t sign) const noexcept {
    const auto along_q8 =
        static_cast<uint32_t>(wrapped(along_q22 + times(plane.nx_q14, at.y_q8) -
                                      times(plane.ny_q14, at.x_q8)) >>
                              14);
    const int32_t slope_q15 = wrapped(times(bend, along_q8)) >> bend_shift;
    const int32_t sag_q22 = wrapped(times(slope_q15, along_q8)) >> 1;
    return with_sign(
        wrapped(plane.plane_q22(at) + static_cast<uint32_t>(sag_q22)), sign);
  }
};

// A point that goes along the rows of a leaf.
class Pen {
 public:
  Pen(const TextStyle& style, uint32_t x_q20, uint32_t y_q20) noexcept
      : x_q20_(x_q20),
        y_q20_(y_q20),
        right_x_q20_(static_cast<uint32_t>(style.right().x_q20)),
        right_y_q20_(static_cast<uint32_t>(style.right().y_q20)) {}

  __attribute__((always_inline)) PixelPlace place() const noexcept {
    return {q8_of(x_q20_), q8_of(y_q20_)};
  }
  __attribute__((always_inline)) void go_on(uint32_t count) noexcept {
    x_q20_ += count * right_x_q20_;
    y_q20_ += count * right_y_q20_;
  }
  void go_down(const TextStyle& style) noexcept {
    x_q20_ -= static_cast<uint32_t>(style.up().x_q20);
    y_q20_ -= static_cast<uint32_t>(style.up().y_q20);
  }

 private:
  uint32_t x_q20_;
  uint32_t y_q20_;
  uint32_t right_x_q20_;
  uint32_t right_y_q20_;
};

}  // namespace detail
}  // namespace inkcell
