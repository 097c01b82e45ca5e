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

/// 1 draws cells of primitives; 0, the default, leaves them out of the library:
/// fonts and glyphs made of them are unsupported.
#ifndef INKCELL_EDGE_CELLS
#  define INKCELL_EDGE_CELLS 0
#endif

/// Cells of samples, likewise.
#ifndef INKCELL_SAMPLE_CELLS
#  define INKCELL_SAMPLE_CELLS 0
#endif

/// 0 leaves out outlines, which are drawn by default.
#ifndef INKCELL_OUTLINES
#  define INKCELL_OUTLINES 1
#endif

#if !INKCELL_EDGE_CELLS && !INKCELL_SAMPLE_CELLS && !INKCELL_OUTLINES
#  error "one coding must be left to draw"
#endif

namespace inkcell {
namespace detail {
inline constexpr bool kHasCells =
    INKCELL_EDGE_CELLS != 0 || INKCELL_SAMPLE_CELLS != 0;
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
  uint16_t band_u = 0;      // distances are good up to here; 0: not known
  /// Nothing is drawn farther from here than the filter reaches.
  InkBox ink;

  /// A view of the glyph record `record` (docs/FORMAT.md, "Glyph record"),
  /// which starts at a multiple of 2 bytes. Any content is safe afterwards.
  ///
  /// corrupt: the counts do not fit `record`, or the grid leaves +-15360 u,
  /// +-1984 u with cells of primitives.
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

/// Signed distance at a point, in u. Outside the grid: saturated outside.
///
/// Cells of primitives are evaluated as distance_row does at 1024 px/em, where
/// a px is a u: the position is rounded to 1/256 px, and from there the
/// distance is that of the equations in docs/FORMAT.md to 1/1024 px for planes,
/// 1/80 px for bent ones (|w| <= 256 u), and 1/128 of the distance from a
/// rounded vertex.
Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

/// The gradient of the distance, (d/dx, d/dy), y up. It points inwards: the
/// negative of the paper's equations 2 and 3. About unit length near an edge.
struct Gradient {
  Q2_14 x;
  Q2_14 y;
};

/// Gradient at a point; zero where the field is saturated. Of a cell of samples
/// each component is clamped to just under +-2; of a cell of primitives it is a
/// unit vector, the normal of the field that decides or the direction of a
/// vertex.
Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

/// What simulations ask for at a point.
struct FieldPoint {
  Q22_10 distance;    // [u] positive inside
  Gradient gradient;  // inwards, y up
  /// The point lies beyond the band, in a saturated cell or beyond the grid:
  /// the edge is at least so far away. Outside, the gradient then leads to the
  /// box of the ink; inside it is 0.
  bool is_bound = false;
};

/// Distance and gradient at a point by one descent of the tree: what
/// distance_at() and gradient_at() tell there, the gradient of samples to 1/256
/// of its unit. Beyond GlyphField::band_u, where those may be wrong: the lower
/// bound of the distance that the band and GlyphField::ink give, at most
/// 1024 u.
FieldPoint point_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

}  // namespace inkcell
