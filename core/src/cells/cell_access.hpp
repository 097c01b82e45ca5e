// Finding and reading cells, inline for the loops that do little else.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/field.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

// Lagrange weights of the points 0, 1/2 and 1 at t, 0 <= t < 1. They sum to
// one exactly, so that a constant is reproduced exactly.
struct Weights {
  int32_t w1;
  int32_t w2;
  int32_t w3;
};

inline Weights lagrange_q14(int32_t t_q14) noexcept {
  constexpr int32_t kOne = 1 << 14;
  const int32_t w2 = (t_q14 * (kOne - t_q14)) >> 12;
  const int32_t w3 = (t_q14 * (2 * t_q14 - kOne)) >> 14;
  return {kOne - w2 - w3, w2, w3};
}

// The three columns of a cell at the height that `w` stands for. [1/64 quantum]
struct Columns {
  int32_t v1;
  int32_t v2;
  int32_t v3;
};

inline Columns columns_q6(const uint8_t* samples, const Weights& w) noexcept {
  const uint8_t* at = samples + format::samples::kOffsets;
  const auto offset = [at](int i) noexcept {
    return static_cast<int32_t>(static_cast<int8_t>(at[i]));
  };
  return {(w.w1 * offset(0) + w.w2 * offset(3) + w.w3 * offset(5) + 128) >> 8,
          (w.w1 * offset(1) + w.w3 * offset(6) + 128) >> 8,
          (w.w1 * offset(2) + w.w2 * offset(4) + w.w3 * offset(7) + 128) >> 8};
}

// The distance at a cell's centre. [u]
inline int32_t centre_q10(const uint8_t* samples) noexcept {
  return load_i16(samples + format::samples::kCentre) *
         (1 << (10 - format::samples::kCentreFraction));
}

// SamplesRow::set_up.
inline void set_up_row(SamplesRow& row,
                       const uint8_t* samples,
                       uint8_t size_log2,
                       int32_t y_q16) noexcept {
  const Columns c = columns_q6(samples, lagrange_q14(y_q16 >> (size_log2 + 2)));
  row.a_q6 = c.v1;
  row.b_q6 = 4 * c.v2 - 3 * c.v1 - c.v3;
  row.c_q6 = 2 * (c.v1 - 2 * c.v2 + c.v3);
  row.centre_q10 = centre_q10(samples);
  row.size_log2 = size_log2;
}

// Whether a glyph is made of cells of primitives. An empty one may be of any
// kind.
inline bool has_fields(const GlyphField& field) noexcept {
  return INKCELL_EDGE_CELLS != 0 &&
         (INKCELL_SAMPLE_CELLS == 0 || field.kind != GlyphField::Kind::samples);
}

inline bool in_grid(const GlyphField& field,
                    int32_t x_u,
                    int32_t y_u) noexcept {
  return x_u >= field.x0_u && x_u < field.x1_u() && y_u >= field.y0_u &&
         y_u < field.y1_u();
}

// The quadtrees of a glyph of samples, for those who go through all of it.
struct SamplesTree {
  const GlyphField& field;

  uint32_t tile(uint32_t number) const noexcept {
    return load_u16(field.references + 2 * number);
  }
  bool is_node(uint32_t reference) const noexcept {
    return reference - format::glyph::kFirstNode < field.node_count &&
           reference < format::glyph::kCellFlag;
  }
  uint32_t child(uint32_t node, uint32_t number) const noexcept {
    return tile(static_cast<uint32_t>(field.tiles_x) * field.tiles_y +
                4 * (node - format::glyph::kFirstNode) + number);
  }
  // Of a cell; null if the leaf is saturated.
  const uint8_t* samples(uint32_t reference) const noexcept {
    const uint32_t index = reference & ~uint32_t{format::glyph::kCellFlag};
    return reference >= format::glyph::kCellFlag && index < field.cell_count
               ? field.cells + format::samples::kBytes * index
               : nullptr;
  }
};

// inkcell::locate for cells of samples.
inline Cell locate_cell(const GlyphField& field,
                        int32_t x_u,
                        int32_t y_u) noexcept {
  const uint32_t x = static_cast<uint32_t>(x_u - field.x0_u);
  const uint32_t y = static_cast<uint32_t>(y_u - field.y0_u);
  uint32_t log2 = field.tile_log2;
  const uint32_t tile = (y >> log2) * field.tiles_x + (x >> log2);
  const uint32_t tiles = static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  uint32_t reference = load_u16(field.references + 2 * tile);

  // Invariant: the current square is 2^log2 u wide and holds the point. Each
  // step spends one bit of the coordinates, so the loop ends.
  while (reference >= format::glyph::kFirstNode &&
         reference < format::glyph::kCellFlag) {
    const uint32_t node = reference - format::glyph::kFirstNode;
    if (node >= field.node_count || log2 == 0) {
      reference = format::glyph::kOutside;
      break;
    }
    --log2;
    const uint32_t child = ((y >> log2) & 1) * 2 + ((x >> log2) & 1);
    reference = load_u16(field.references + 2 * (tiles + 4 * node + child));
  }

  Cell cell;
  cell.size_log2 = static_cast<uint8_t>(log2);
  cell.x0_u = field.x0_u + static_cast<int32_t>((x >> log2) << log2);
  cell.y0_u = field.y0_u + static_cast<int32_t>((y >> log2) << log2);
  const uint32_t index = reference & ~uint32_t{format::glyph::kCellFlag};
  if (reference < format::glyph::kCellFlag) {
    cell.inside = reference == format::glyph::kInside;
  } else if (index < field.cell_count) {
    cell.samples = field.cells + format::samples::kBytes * index;
  }
  return cell;
}

// inkcell::distance_at for cells of samples. [u, Q16 -> Q10]
int32_t samples_distance_q10(const GlyphField& field,
                             int32_t x_q16,
                             int32_t y_q16) noexcept;

// inkcell::gradient_at for a point in a cell of samples.
Gradient samples_gradient(const Cell& cell, Q16_16 x, Q16_16 y) noexcept;

}  // namespace detail
}  // namespace inkcell
