// The signed distance field of a glyph, and questions at any point.
//
// A glyph is a grid of square tiles, each the root of a quadtree whose leaves
// are cells. A cell is saturated (all outside or all inside), or holds nine
// distances and reconstructs the field bi-quadratically (Perry and Frisken,
// section 3.2, equations 1 to 3). Positions are in u (1/1024 em), y up, origin
// on the baseline; distances are positive inside the shape.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// The distance that a saturated cell reports, with the sign of its side, and
/// the largest magnitude that any query returns: 1024 u.
inline constexpr int32_t kSaturatedDistanceQ10 = 1024 << 10;

/// One glyph's cells, in ROM or RAM. Owns nothing: the bytes must outlive it.
/// A default-constructed field is empty: outside everywhere.
struct GlyphField {
  const uint8_t* references = nullptr;  // u16: tiles, then nodes
  const uint8_t* cells = nullptr;       // format::samples
  int16_t x0_u = 0;                     // lower left corner of the grid
  int16_t y0_u = 0;
  uint8_t tile_log2 = 0;  // tiles are 2^tile_log2 u wide
  uint8_t tiles_x = 0;
  uint8_t tiles_y = 0;
  uint16_t node_count = 0;
  uint16_t cell_count = 0;
  uint16_t band_u = 0;  // distances are good up to here; 0: not known
  /// Nothing is drawn farther from here than the filter reaches.
  InkBox ink;

  /// A view of the glyph record `record` (docs/FORMAT.md, "Glyph record"),
  /// which starts at a multiple of 2 bytes. Any content is safe afterwards.
  ///
  /// corrupt: the counts do not fit `record`, or the grid leaves +-15360 u.
  /// unsupported: the record is of another type. `out` is untouched unless the
  /// result is ok.
  static Status open(Span<const uint8_t> record, GlyphField& out) noexcept;

  constexpr int32_t x1_u() const noexcept {
    return x0_u + (tiles_x << tile_log2);
  }
  constexpr int32_t y1_u() const noexcept {
    return y0_u + (tiles_y << tile_log2);
  }
};

/// The bytes of a field's record; of a generated one, what it takes of its
/// buffer: what follows is free.
size_t record_bytes(const GlyphField& field) noexcept;

/// The field of a glyph of a font of fields, a view of the font; empty for a
/// glyph without ink. no_glyph: there is no glyph of this id. corrupt,
/// unsupported: as GlyphField::open. `out` is untouched unless the result is
/// ok.
Status read_field(const Font& font, uint16_t glyph, GlyphField& out) noexcept;

/// Signed distance at a point, in u. Outside the grid: saturated outside.
Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

/// The gradient of the distance, (d/dx, d/dy), y up. It points inwards: the
/// negative of the paper's equations 2 and 3. About unit length near an edge.
struct Gradient {
  Q2_14 x;
  Q2_14 y;
};

/// Gradient at a point; zero where the field is saturated. Each component is
/// clamped to just under +-2.
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
/// distance_at() and gradient_at() tell there, the gradient to 1/256 of its
/// unit. Beyond GlyphField::band_u, where those may be wrong: the lower bound
/// of the distance that the band and GlyphField::ink give, at most 1024 u.
FieldPoint point_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept;

}  // namespace inkcell
