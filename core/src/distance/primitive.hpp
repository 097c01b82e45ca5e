// The value and the gradient of a primitive at a point.
//
// All is computed in px of some size, in 32 bits modulo 2^32. The products of a
// value may wrap; their sum is right again because within a cell distances and
// w stay within +-512 u, k w^2 within +-256 u, which is no more in px, and k w
// within +-2. Bytes that break this give wrong numbers, never undefined ones.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "base/modular.hpp"
#include "cells/leaf.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/text_style.hpp"
#include "place/pixel_place.hpp"

namespace inkcell {
namespace detail {

// From the numbers of a record to px.
struct FieldScale {
  uint32_t size_q8;  // px to the em
  int32_t bend_q14;  // 2^(bend_shift - 5) over the px to the em: 1 to 2
  // 5 and the log2 of the first power of two, in px, that holds an em.
  int32_t bend_shift;
};

// An em of 1024 px: a px is a u.
inline constexpr FieldScale kScaleOfUnits = {1024 << 8, 1 << 14, 15};

inline FieldScale scale_of(const TextStyle& style) noexcept {
  return {static_cast<uint32_t>(style.size().raw) << 2, style.bend_q14(),
          style.bend_shift()};
}

struct Vector {
  int32_t x;
  int32_t y;
};

// The normal of a primitive, given its record. [Q14]
inline Vector normal_of(const uint8_t* record) noexcept {
  return {load_i16(record + format::edges::kNormalX),
          load_i16(record + format::edges::kNormalY)};
}

// n.p + c, with the leaf's sign.
struct LineValue {
  int32_t nx_q14;
  int32_t ny_q14;
  uint32_t offset_q22;

  LineValue() = default;
  __attribute__((always_inline)) LineValue(const uint8_t* record,
                                           const FieldScale& scale,
                                           int32_t sign) noexcept {
    const Vector normal_q14 = normal_of(record);
    nx_q14 = with_sign(normal_q14.x, sign);
    ny_q14 = with_sign(normal_q14.y, sign);
    offset_q22 =
        times(with_sign(load_i16(record + format::edges::kOffset), sign),
              scale.size_q8);
  }

  __attribute__((always_inline)) uint32_t plane_q22(
      const PixelPlace& at) const noexcept {
    return times(nx_q14, at.x_q8) + times(ny_q14, at.y_q8) + offset_q22;
  }
  __attribute__((always_inline)) int32_t at(const PixelPlace& at,
                                            int32_t,
                                            int32_t) const noexcept {
    return wrapped(plane_q22(at));
  }

  // Whether it is the same in all rows.
  bool is_steady() const noexcept { return ny_q14 == 0; }
};

// n.p + c + k w^2, w = n x p + cw; of a line k is 0. It leaves the sign to
// at().
struct ArcValue {
  LineValue plane;
  uint32_t along_q22;  // w at the origin, and half of what is cut off
  // K 2^(bend_shift - 2) / size, K = k in 2^-19 / u: divided by the size but
  // for a power of two. [Q3]
  int32_t bend;

  ArcValue() = default;
  __attribute__((always_inline))
  ArcValue(PrimitiveRef primitive, const FieldScale& scale, int32_t) noexcept
      : plane(record_of(primitive), scale, 0), along_q22(0), bend(0) {
    namespace layout = format::edges;
    if (arc_bit(primitive) != 0) {
      const uint8_t* const record = primitive - 1;
      along_q22 =
          (1 << 13) + times(load_i16(record + layout::kAlong), scale.size_q8);
      bend =
          (load_i16(record + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
    }
  }

  // w. [px]
  __attribute__((always_inline)) uint32_t along_at(
      const PixelPlace& at) const noexcept {
    return along_q22 + times(plane.nx_q14, at.y_q8) -
           times(plane.ny_q14, at.x_q8);
  }
  __attribute__((always_inline)) uint32_t along_q8(
      const PixelPlace& at) const noexcept {
    return static_cast<uint32_t>(wrapped(along_at(at)) >> 14);
  }
  // k w, half the slope along the primitive that the bend adds.
  __attribute__((always_inline)) int32_t slope_q15(
      uint32_t along_q8, int32_t bend_shift) const noexcept {
    return wrapped(times(bend, along_q8)) >> bend_shift;
  }
  // The value, given its plane and w. [px]
  __attribute__((always_inline)) int32_t value_of(uint32_t plane_q22,
                                                  uint32_t along_q8,
                                                  int32_t bend_shift,
                                                  int32_t sign) const noexcept {
    const int32_t sag_q22 =
        wrapped(times(slope_q15(along_q8, bend_shift), along_q8)) >> 1;
    return with_sign(wrapped(plane_q22 + static_cast<uint32_t>(sag_q22)), sign);
  }
  __attribute__((always_inline)) int32_t at(const PixelPlace& at,
                                            int32_t bend_shift,
                                            int32_t sign) const noexcept {
    return value_of(plane.plane_q22(at), along_q8(at), bend_shift, sign);
  }
  // The gradient: n + 2 k w (-ny, nx). [Q14]
  Vector gradient_q14(const PixelPlace& at, int32_t bend_shift) const noexcept {
    const Vector n = {plane.nx_q14, plane.ny_q14};
    if (bend == 0) {
      return n;
    }
    const auto slope =
        static_cast<uint32_t>(slope_q15(along_q8(at), bend_shift));
    return {n.x - (wrapped(times(n.y, slope)) >> 14),
            n.y + (wrapped(times(n.x, slope)) >> 14)};
  }

  bool is_steady() const noexcept { return false; }  // or not worth a look
};

// A primitive along a row of points, a px apart: followed by addition, exact
// modulo 2^32.
struct LineRow {
  uint32_t plane_q22;
  uint32_t step_q22;

  __attribute__((always_inline)) void begin(const LineValue& line,
                                            const PixelPlace& at) noexcept {
    plane_q22 = line.plane_q22(at);
    step_q22 = static_cast<uint32_t>(line.nx_q14) << 8;
  }
  __attribute__((always_inline)) int32_t value(const LineValue&,
                                               int32_t,
                                               int32_t) const noexcept {
    return wrapped(plane_q22);
  }
  __attribute__((always_inline)) void advance(uint32_t count) noexcept {
    plane_q22 += count * step_q22;
  }
  // A px down.
  __attribute__((always_inline)) void go_down(const LineValue& line) noexcept {
    plane_q22 -= static_cast<uint32_t>(line.ny_q14) << 8;
  }
};

struct ArcRow {
  LineRow plane;
  uint32_t along_q22;
  uint32_t step_q22;

  __attribute__((always_inline)) void begin(const ArcValue& arc,
                                            const PixelPlace& at) noexcept {
    plane.begin(arc.plane, at);
    along_q22 = arc.along_at(at);
    step_q22 = static_cast<uint32_t>(arc.plane.ny_q14) << 8;
  }
  __attribute__((always_inline)) int32_t value(const ArcValue& arc,
                                               int32_t bend_shift,
                                               int32_t sign) const noexcept {
    return arc.value_of(plane.plane_q22,
                        static_cast<uint32_t>(wrapped(along_q22) >> 14),
                        bend_shift, sign);
  }
  __attribute__((always_inline)) void advance(uint32_t count) noexcept {
    plane.advance(count);
    along_q22 -= count * step_q22;
  }
  __attribute__((always_inline)) void go_down(const ArcValue& arc) noexcept {
    plane.go_down(arc.plane);
    along_q22 -= static_cast<uint32_t>(arc.plane.nx_q14) << 8;
  }
};

}  // namespace detail
}  // namespace inkcell
