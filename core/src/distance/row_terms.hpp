// Fields along rows of points: set up once, then followed by addition, exact
// modulo 2^32, so that no point depends on where a row or a band of them
// begins.
#pragma once

#include <stdint.h>

#include "cells/field_cell.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// A field of a row: where its record lies, plus 1 if it is an arc.
inline uintptr_t arc_bit(const uint8_t* field) noexcept {
  return reinterpret_cast<uintptr_t>(field) & 1;
}

// A line at a point, with the leaf's sign, and what leads to the points to the
// right and further down.
struct LineTerm {
  uint32_t plane_q22;
  uint32_t step_q22;  // a px to the right
  uint32_t down_q14;  // for each px down

  LineTerm() = default;
  __attribute__((always_inline)) LineTerm(const uint8_t* record,
                                          PixelPlace at,
                                          const FieldScale& scale,
                                          int32_t sign) noexcept {
    namespace layout = format::edges;
    const int32_t nx = load_i16(record + layout::kNormalX);
    const int32_t ny = load_i16(record + layout::kNormalY);
    const uint32_t plane =
        times(nx, at.x_q8) + times(ny, at.y_q8) +
        times(load_i16(record + layout::kOffset), scale.size_q8);
    plane_q22 = static_cast<uint32_t>(with_sign(wrapped(plane), sign));
    step_q22 = times(nx, static_cast<uint32_t>(with_sign(1 << 8, sign)));
    down_q14 = static_cast<uint32_t>(with_sign(ny, sign));
  }

  __attribute__((always_inline)) int32_t value(int32_t,
                                               int32_t) const noexcept {
    return wrapped(plane_q22);
  }

  __attribute__((always_inline)) void go_on(uint32_t count = 1) noexcept {
    plane_q22 += count * step_q22;
  }
  __attribute__((always_inline)) void go_down(uint32_t way_q8) noexcept {
    plane_q22 -= way_q8 * down_q14;
  }

  // Whether it is the same in all rows.
  bool is_steady() const noexcept { return down_q14 == 0; }
};

// The same of an arc, or of a line that is followed like one. It takes a sign
// as LineTerm does, but leaves it to value().
struct ArcTerm {
  LineTerm plane;
  uint32_t along_q22;  // it and `bend` as in FieldTerm
  uint32_t along_step_q22;
  uint32_t along_down_q14;
  int32_t bend;

  ArcTerm() = default;
  __attribute__((always_inline)) ArcTerm(const uint8_t* field,
                                         PixelPlace at,
                                         const FieldScale& scale,
                                         int32_t) noexcept
      : ArcTerm(field - arc_bit(field), arc_bit(field) != 0, at, scale) {}

  // The same of a record.
  __attribute__((always_inline)) ArcTerm(const uint8_t* record,
                                         bool is_arc,
                                         PixelPlace at,
                                         const FieldScale& scale) noexcept
      : plane(record, at, scale, 0) {
    namespace layout = format::edges;
    if (is_arc) {
      const int32_t nx = load_i16(record + layout::kNormalX);
      const int32_t ny = load_i16(record + layout::kNormalY);
      along_q22 = times(nx, at.y_q8) - times(ny, at.x_q8) + (1 << 13) +
                  times(load_i16(record + layout::kAlong), scale.size_q8);
      along_step_q22 = static_cast<uint32_t>(ny) << 8;
      along_down_q14 = static_cast<uint32_t>(nx);
      bend =
          (load_i16(record + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
    } else {
      along_q22 = along_step_q22 = along_down_q14 = 0;
      bend = 0;
    }
  }

  // FieldTerm::along_q8 and slope_q15.
  __attribute__((always_inline)) uint32_t along_q8() const noexcept {
    return static_cast<uint32_t>(wrapped(along_q22) >> 14);
  }
  __attribute__((always_inline)) int32_t slope_q15(
      int32_t bend_shift) const noexcept {
    return wrapped(times(bend, along_q8())) >> bend_shift;
  }

  // FieldTerm::value_q22.
  __attribute__((always_inline)) int32_t value(int32_t bend_shift,
                                               int32_t sign) const noexcept {
    const int32_t sag_q22 =
        wrapped(times(slope_q15(bend_shift), along_q8())) >> 1;
    return with_sign(wrapped(plane.plane_q22 + static_cast<uint32_t>(sag_q22)),
                     sign);
  }

  __attribute__((always_inline)) void go_on(uint32_t count = 1) noexcept {
    plane.go_on(count);
    along_q22 -= count * along_step_q22;
  }
  __attribute__((always_inline)) void go_down(uint32_t way_q8) noexcept {
    plane.go_down(way_q8);
    along_q22 -= way_q8 * along_down_q14;
  }

  bool is_steady() const noexcept { return false; }  // or not worth a look
};

}  // namespace detail
}  // namespace inkcell
