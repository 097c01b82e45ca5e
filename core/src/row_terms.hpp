// Fields along a row of points: set up once, then followed by addition, exact
// modulo 2^32, so that no point depends on where a row begins.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "inkcell/filter.hpp"

// 0: one loop for all cells, instead of loops for one, two and three fields, of
// lines and of arcs.
#ifndef INKCELL_FAST_ROWS
#  define INKCELL_FAST_ROWS 1
#endif

namespace inkcell {
namespace detail {

inline constexpr bool kFastRows = INKCELL_FAST_ROWS != 0;

// A field of a row: where its record lies, plus 1 if it is an arc.
inline uintptr_t arc_bit(const uint8_t* field) noexcept {
  return reinterpret_cast<uintptr_t>(field) & 1;
}

// A line at a point of a row, with the leaf's sign, and what leads to the next
// point, a px to the right.
struct LineTerm {
  uint32_t plane_q22;
  uint32_t step_q22;

  LineTerm() = default;
  __attribute__((always_inline)) LineTerm(const uint8_t* record,
                                          PixelPlace at,
                                          const FieldScale& scale,
                                          int32_t sign) noexcept {
    namespace layout = format::fields;
    const int32_t nx = load_i16(record + layout::kNormalX);
    const uint32_t plane =
        times(nx, at.x_q8) +
        times(load_i16(record + layout::kNormalY), at.y_q8) +
        times(load_i16(record + layout::kOffset), scale.size_q8);
    plane_q22 = static_cast<uint32_t>(with_sign(wrapped(plane), sign));
    step_q22 = static_cast<uint32_t>(with_sign(nx, sign)) << 8;
  }

  int32_t value(int32_t, int32_t) const noexcept { return wrapped(plane_q22); }

  void go_on() noexcept { plane_q22 += step_q22; }
};

// The same of an arc, or of a line that is followed like one.
struct ArcTerm {
  LineTerm plane;
  uint32_t along_q22 = 0;  // these three as in FieldTerm
  uint32_t along_step_q22 = 0;
  int32_t bend = 0;

  ArcTerm() = default;
  __attribute__((always_inline)) ArcTerm(const uint8_t* field,
                                         PixelPlace at,
                                         const FieldScale& scale,
                                         int32_t sign) noexcept
      : plane(field - arc_bit(field), at, scale, sign) {
    namespace layout = format::fields;
    if (arc_bit(field) != 0) {
      const uint8_t* const record = field - 1;
      const int32_t ny = load_i16(record + layout::kNormalY);
      along_q22 = times(load_i16(record + layout::kNormalX), at.y_q8) -
                  times(ny, at.x_q8) + (1 << 13) +
                  times(load_i16(record + layout::kAlong), scale.size_q8);
      along_step_q22 = static_cast<uint32_t>(ny) << 8;
      bend =
          (load_i16(record + layout::kBend) * scale.bend_q14 + (1 << 10)) >> 11;
    }
  }

  // FieldTerm::slope_q15; `bend_shift` is bend_log2 + 5.
  int32_t slope_q15(int32_t bend_shift) const noexcept {
    return wrapped(times(bend, along_q8())) >> bend_shift;
  }

  // FieldTerm::value_q22.
  __attribute__((always_inline)) int32_t value(int32_t bend_shift,
                                               int32_t sign) const noexcept {
    const int32_t sag_q22 =
        wrapped(times(slope_q15(bend_shift), along_q8())) >> 1;
    return wrapped(plane.plane_q22 +
                   static_cast<uint32_t>(with_sign(sag_q22, sign)));
  }

  void go_on() noexcept {
    plane.go_on();
    along_q22 -= along_step_q22;
  }

 private:
  uint32_t along_q8() const noexcept {
    return static_cast<uint32_t>(wrapped(along_q22) >> 14);
  }
};

// What turns distances into coverage: Filter, as inner loops read it.
struct CoverageRamp {
  int32_t low_q22;     // the least distance that is not transparent [px]
  uint32_t width_q22;  // from there to the least that is opaque
  uint32_t scale;      // entries per 1/1024 px, as in Filter
  const uint8_t* table;

  explicit CoverageRamp(const Filter& filter) noexcept
      : low_q22((filter.outside_q10 + 1) * (1 << 12)),
        width_q22(
            static_cast<uint32_t>(filter.inside_q10 - filter.outside_q10 - 1)
            << 12),
        scale(filter.scale),
        table(filter.table) {}

  // Filter::coverage.
  __attribute__((always_inline)) uint8_t operator()(
      int32_t distance_q22) const noexcept {
    const uint32_t way =
        static_cast<uint32_t>(distance_q22) - static_cast<uint32_t>(low_q22);
    if (way < width_q22) {
      return table[static_cast<uint8_t>(((way >> 12) + 1) * scale >> 14)];
    }
    return distance_q22 < low_q22 ? 0 : 255;
  }
};

}  // namespace detail
}  // namespace inkcell
