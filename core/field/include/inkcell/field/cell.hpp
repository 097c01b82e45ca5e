// The leaves of a glyph's quadtree, and cells of nine samples evaluated as the
// device does it: for the generator and for tools.
#pragma once

#include <stdint.h>

#include "inkcell/field/glyph_field.hpp"
#include "inkcell/fixed.hpp"

namespace inkcell {

/// A leaf of the quadtree, as `locate` finds it.
struct Cell {
  const uint8_t* samples = nullptr;  // format::samples; null: saturated
  int32_t x0_u = 0;                  // lower left corner
  int32_t y0_u = 0;
  uint8_t size_log2 = 0;  // the cell is 2^size_log2 u wide, 1..2048 u
  bool inside = false;    // the side of a saturated cell

  constexpr bool is_saturated() const noexcept { return samples == nullptr; }
};

/// The cell that holds the point (x_u, y_u), which must lie in the grid:
/// x0_u <= x_u < x1_u(), likewise y. Follows the bits of the coordinates down
/// the tree without comparing them (Frisken and Perry 2003): at most tile_log2
/// steps, whatever the bytes say.
Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept;

/// The field of one cell along one row: a parabola in x.
///
/// Equation 1 is evaluated with the three columns first, so that a row costs
/// one set-up per cell and two products per pixel:
///
///   distance = centre + a + X (b + c X),   X = position in the cell, 0..1
struct SamplesRow {
  int32_t a_q6 = 0;  // in quanta of 1/128 cell size
  int32_t b_q6 = 0;
  int32_t c_q6 = 0;
  int32_t centre_q10 = 0;  // [u]
  uint8_t size_log2 = 0;

  /// Sets the row up at height `y_q16` above the cell's lower edge
  /// (u, 0 <= y_q16 < 2^(16 + size_log2)).
  void set_up(const uint8_t* samples,
              uint8_t cell_size_log2,
              int32_t y_q16) noexcept;

  /// The distance at `x_q16` from the cell's left edge (u, 0 <= x_q16 <
  /// 2^(16 + size_log2)). [u, Q10] Differs from equation 1 in real numbers by
  /// at most samples_error_bound_q10(size_log2).
  int32_t distance_q10(int32_t x_q16) const noexcept {
    // |c| X and the slope of every chord of the parabola stay below 1.35e9 for
    // any bytes: columns are at most 10240, b and c at most 8 columns, X <
    // 2^14.
    const int32_t x_q14 = x_q16 >> (size_log2 + 2);
    const int32_t f_q6 =
        a_q6 + ((x_q14 * (b_q6 + ((c_q6 * x_q14) >> 14))) >> 14);
    return centre_q10 + (size_log2 >= 3 ? f_q6 * (1 << (size_log2 - 3))
                                        : f_q6 >> (3 - size_log2));
  }
};

/// The distance of a nine-sample cell at one point: SamplesRow in one step.
Q22_10 samples_distance(const uint8_t* samples,
                        uint8_t size_log2,
                        int32_t x_q16,
                        int32_t y_q16) noexcept;

/// How far SamplesRow may be from equation 1 in real numbers, whatever the
/// bytes: a quarter of a quantum (positions are cut to 1/16384 of the cell,
/// weights rounded to 14 bits, columns and parabola to 1/64 quantum), and
/// 1/1024 u for the last shift. Where the slope stays below 2, as in every
/// distance field, half of that. [u, Q10]
constexpr int32_t samples_error_bound_q10(uint8_t size_log2) noexcept {
  return (2 << size_log2) + 1;
}

}  // namespace inkcell
