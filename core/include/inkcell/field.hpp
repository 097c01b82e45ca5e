// Signed distance and gradient of one glyph: the view that everything draws.
//
// A glyph is a grid of square tiles, each the root of a quadtree whose leaves
// are cells. A cell is saturated (all outside or all inside), or is made of one
// to three second-order fields, or holds nine distances and reconstructs the
// field bi-quadratically (Perry and Frisken, section 3.2, equations 1 to 3).
// Positions are in u (1/1024 em), y up, origin
// on the baseline; distances are positive inside the shape.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

/// 0 leaves cells of fields out of the library: glyphs made of them are
/// unsupported.
#ifndef INKCELL_FIELD_CELLS
#  define INKCELL_FIELD_CELLS 1
#endif

/// 0 leaves out cells of samples, likewise.
#ifndef INKCELL_SAMPLE_CELLS
#  define INKCELL_SAMPLE_CELLS 1
#endif

/// 0 leaves out outlines, likewise.
#ifndef INKCELL_OUTLINES
#  define INKCELL_OUTLINES 1
#endif

#if !INKCELL_FIELD_CELLS && !INKCELL_SAMPLE_CELLS && !INKCELL_OUTLINES
#  error "one coding must be left to draw"
#endif

namespace inkcell {
namespace detail {
inline constexpr bool kHasCells =
    INKCELL_FIELD_CELLS != 0 || INKCELL_SAMPLE_CELLS != 0;
inline constexpr bool kHasOutlines = INKCELL_OUTLINES != 0;
}  // namespace detail

/// The distance that a saturated cell reports, with the sign of its side, and
/// the largest magnitude that any query returns: 1024 u.
inline constexpr int32_t kSaturatedDistanceQ10 = 1024 << 10;

/// The box of a glyph's ink. [u] By default all of the plane.
struct InkBox {
  static constexpr int16_t kFar = 16384;

  int16_t x0_u = -kFar;
  int16_t y0_u = -kFar;
  int16_t x1_u = kFar;
  int16_t y1_u = kFar;
};

/// One glyph's cells, in ROM or RAM. Owns nothing: the bytes must outlive it.
/// A default-constructed field is empty: outside everywhere.
struct GlyphField {
  enum class Kind : uint8_t { samples, narrow_fields, linked_fields };

  const uint8_t* references = nullptr;  // tiles, then nodes; u8 if narrow
  const uint8_t* cells = nullptr;  // of samples; or arcs, lines; or the heap
  int16_t x0_u = 0;                // lower left corner of the grid
  int16_t y0_u = 0;
  uint8_t tile_log2 = 0;  // tiles are 2^tile_log2 u wide
  uint8_t tiles_x = 0;
  uint8_t tiles_y = 0;
  Kind kind = Kind::samples;
  uint16_t node_count = 0;
  uint16_t cell_count = 0;  // of samples
  uint16_t arc_count = 0;   // fields are numbered: arcs, then lines
  uint16_t line_count = 0;
  uint16_t pair_count = 0;
  uint16_t triple_count = 0;
  uint16_t heap_units = 0;  // of 2 bytes, where fields are linked
  /// Nothing is drawn farther from here than the filter reaches.
  InkBox ink;

  /// A view of the glyph record `record` (docs/FORMAT.md, "Glyph record"),
  /// which starts at a multiple of 2 bytes. Any content is safe afterwards.
  ///
  /// corrupt: the counts do not fit `record`, or the grid leaves +-15360 u,
  /// +-1984 u with cells of fields.
  /// unsupported: the record is of a type that this build does not know.
  /// `out` is untouched unless the result is ok.
  static Status open(Span<const uint8_t> record, GlyphField& out) noexcept;

  constexpr int32_t x1_u() const noexcept {
    return x0_u + (tiles_x << tile_log2);
  }
  constexpr int32_t y1_u() const noexcept {
    return y0_u + (tiles_y << tile_log2);
  }
};

/// How the fields of a cell make one distance. Where a result is that of a
/// convex vertex, it is the distance to the vertex (docs/FORMAT.md).
enum class FieldOperator : uint8_t {
  least = 0,              // min(f0, f1) or min(f0, f1, f2); a single field
  greatest = 1,           // max(f0, f1) or max(f0, f1, f2)
  least_of_greater = 2,   // min(f0, max(f1, f2))
  greatest_of_lesser = 3  // max(f0, min(f1, f2))
};

/// A leaf of the quadtree, as `locate` finds it. Saturated unless it has
/// samples or fields.
struct Cell {
  const uint8_t* samples = nullptr;  // format::samples
  int32_t x0_u = 0;                  // lower left corner
  int32_t y0_u = 0;
  // Existing fields, `field_count` of them: where they lie behind
  // GlyphField::cells in units of 2 bytes, with format::linked::kArcField.
  uint16_t fields[3] = {};
  uint8_t field_count = 0;
  FieldOperator op = FieldOperator::least;
  uint8_t size_log2 = 0;  // the cell is 2^size_log2 u wide, 1..2048 u
  bool inside = false;    // the side of a saturated cell

  constexpr bool is_saturated() const noexcept {
    return samples == nullptr && field_count == 0;
  }
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
    return to_u_q10(a_q6 + ((x_q14 * (b_q6 + ((c_q6 * x_q14) >> 14))) >> 14));
  }

  /// What distance_q10 never leaves on this row, both ends included. [u, Q10]
  struct Bounds {
    int32_t low;
    int32_t high;
  };

  Bounds bounds_q10() const noexcept {
    // Between its ends a and a + b + c the parabola hangs from their chord by
    // c X (X - 1), at most a quarter of c; two roundings take up to 2/64 more.
    const int32_t end_q6 = a_q6 + b_q6 + c_q6;
    const int32_t least = a_q6 < end_q6 ? a_q6 : end_q6;
    const int32_t most = a_q6 < end_q6 ? end_q6 : a_q6;
    const int32_t sag = c_q6 >> 2;
    return {to_u_q10(least - 3 - (sag > 0 ? sag : 0)),
            to_u_q10(most - (sag < 0 ? sag : 0))};
  }

 private:
  int32_t to_u_q10(int32_t f_q6) const noexcept {
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

/// Signed distance at a point, in u. Outside the grid: saturated outside.
///
/// Cells of fields are evaluated as distance_row does at 1024 px/em, where a px
/// is a u: the position is rounded to 1/256 px, and from there the distance is
/// that of the equations in docs/FORMAT.md to 1/1024 px for planes, 1/80 px
/// for bent ones (|w| <= 256 u), and 1/128 of the distance from a rounded
/// vertex.
Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

/// The gradient of the distance, (d/dx, d/dy), y up. It points inwards: the
/// negative of the paper's equations 2 and 3. About unit length near an edge.
struct Gradient {
  Q2_14 x;
  Q2_14 y;
};

/// Gradient at a point; zero where the field is saturated. Of a cell of samples
/// each component is clamped to just under +-2; of a cell of fields it is a
/// unit vector, the normal of the field that decides or the direction of a
/// vertex.
Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

}  // namespace inkcell
