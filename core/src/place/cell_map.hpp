// From samples on the screen to places in a glyph of cells.
#pragma once

#include <stdint.h>

#include "inkcell/field.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "place/pixel_place.hpp"
#include "place/position.hpp"

namespace inkcell {
namespace detail {

// A place in the glyph, in the two units that it takes to find a leaf and to
// evaluate it: from the grid's corner [u] and from the origin [px], y up. Both
// modulo 2^32.
struct GlyphPoint {
  uint32_t x_q16;
  uint32_t y_q16;
  uint32_t x_q20;
  uint32_t y_q20;

  void advance(const GlyphStep& step, uint32_t count = 1) noexcept {
    x_q16 += times(step.x_q16, count);
    y_q16 += times(step.y_q16, count);
    x_q20 += times(step.x_q20, count);
    y_q20 += times(step.y_q20, count);
  }
  PixelPlace place() const noexcept { return {q8_of(x_q20), q8_of(y_q20)}; }
};

// Where a grid begins. [u]
inline uint32_t corner_q16(int32_t corner_u) noexcept {
  return static_cast<uint32_t>(corner_u) << 16;
}

inline bool is_in_grid(const GlyphField& field, const GlyphPoint& at) noexcept {
  return at.x_q16 >> 16 < uint32_t{field.tiles_x} << field.tile_log2 &&
         at.y_q16 >> 16 < uint32_t{field.tiles_y} << field.tile_log2;
}

inline bool is_grid_empty(const GlyphField& field) noexcept {
  return field.tiles_x == 0 || field.tiles_y == 0;
}

// The nearest place in a grid that is not empty. [u]
inline uint32_t in_grid(uint32_t place_q16,
                        uint32_t tiles,
                        uint32_t log2) noexcept {
  const uint32_t end_q16 = tiles << (log2 + 16);
  return place_q16 < end_q16    ? place_q16
         : place_q16 >> 31 != 0 ? 0
                                : end_q16 - 1;
}
inline GlyphPoint in_grid(const GlyphField& field,
                          const GlyphPoint& at) noexcept {
  return {in_grid(at.x_q16, field.tiles_x, field.tile_log2),
          in_grid(at.y_q16, field.tiles_y, field.tile_log2), at.x_q20,
          at.y_q20};
}

// Where the centre of a sample lies, given the steps between samples and the
// origin. [samples, y down] False: it is farther from the origin than 2^15 u,
// and may be taken for one in the grid.
bool find_point(const GlyphField& field,
                const GlyphStep& right,
                const GlyphStep& up,
                const FinePoint& origin,
                int32_t x,
                int32_t y,
                GlyphPoint& out) noexcept;

// One affine map from samples to the glyph: upright, turned, mirrored and
// stretched differ in its steps only. Linear with whole steps, so that no
// picture depends on where a row, a strip or a window begins.
struct CellMap {
  // Nothing shows that is farther from the ink than `reach_u_q10`. [u]
  // Samples up to `its_beyond_u` from a grid that is not empty may show, too.
  CellMap(const GlyphField& glyph,
          const TextStyle& its_style,
          const Placed& placed,
          int32_t its_reach_u_q10,
          int32_t its_beyond_u = 0) noexcept
      : field(glyph),
        style(its_style),
        right(its_style.right()),
        up(its_style.up()),
        x_q10(placed.x_q10),
        y_q10(placed.y_q10),
        reach_u_q10(its_reach_u_q10),
        beyond_u(is_grid_empty(glyph) ? 0 : its_beyond_u) {}

  bool find(int32_t x, int32_t y, GlyphPoint& out) const noexcept {
    return find_point(field, right, up, {x_q10, y_q10}, x, y, out);
  }

  uint32_t size_q6() const noexcept {
    return static_cast<uint32_t>(style.size().raw);
  }

  const GlyphField& field;
  const TextStyle& style;
  const GlyphStep& right;  // from a sample to the next one
  const GlyphStep& up;
  int32_t x_q10;  // the origin [samples, y down]
  int32_t y_q10;
  int32_t reach_u_q10;
  int32_t beyond_u;
  // Samples of the window that may show, and where the upper left one lies: set
  // by CellRaster::clip.
  Rect samples;
  GlyphPoint first;
  bool is_near;  // find() is true of all of them
};

// What may show: the grid, but no farther from the ink than it reaches. [u]
Rect limits_of(const CellMap& map) noexcept;

// Leaves of the window's samples those whose centres lie in the limits of an
// upright map. False: none.
bool clip_upright(CellMap& map, const Rect& window) noexcept;

// Leaves of the window's samples those in the box around the limits.
bool clip_slanted(CellMap& map, const Rect& window) noexcept;

}  // namespace detail
}  // namespace inkcell
