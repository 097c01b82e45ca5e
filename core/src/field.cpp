#include "inkcell/field.hpp"

#include "bytes.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace {

using detail::load_i16;
using detail::load_u16;

constexpr int32_t kOneQ14 = 1 << 14;

// The offsets of a cell as the paper numbers them, d1 to d9, d5 the centre.
struct Offsets {
  int32_t d[9];
};

Offsets load_offsets(const uint8_t* samples) noexcept {
  const uint8_t* at = samples + format::samples::kOffsets;
  Offsets offsets;
  for (int i = 0; i < 9; ++i) {
    offsets.d[i] = i == 4 ? 0 : static_cast<int8_t>(at[i < 4 ? i : i - 1]);
  }
  return offsets;
}

// Lagrange weights of the points 0, 1/2 and 1 at t, 0 <= t < 1. They sum to
// one exactly, so that a constant is reproduced exactly.
struct Weights {
  int32_t w1;
  int32_t w2;
  int32_t w3;
};

Weights lagrange_q14(int32_t t_q14) noexcept {
  const int32_t w2 = (t_q14 * (kOneQ14 - t_q14)) >> 12;
  const int32_t w3 = (t_q14 * (2 * t_q14 - kOneQ14)) >> 14;
  return {kOneQ14 - w2 - w3, w2, w3};
}

// Their derivatives: 4t - 3, 4 - 8t, 4t - 1.
Weights lagrange_slope_q14(int32_t t_q14) noexcept {
  return {4 * t_q14 - 3 * kOneQ14, 4 * kOneQ14 - 8 * t_q14,
          4 * t_q14 - kOneQ14};
}

int16_t clamp_i16(int32_t value) noexcept {
  if (value < INT16_MIN) {
    return INT16_MIN;
  }
  return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX : value);
}

// Sum of the nine offsets with weights in x and y. [quanta, Q6]
int32_t weigh_q6(const Offsets& o,
                 const Weights& x,
                 const Weights& y) noexcept {
  int32_t columns[3];
  for (int j = 0; j < 3; ++j) {
    columns[j] =
        (y.w1 * o.d[j] + y.w2 * o.d[3 + j] + y.w3 * o.d[6 + j] + 128) >> 8;
  }
  return (x.w1 * (columns[0] >> 2) + x.w2 * (columns[1] >> 2) +
          x.w3 * (columns[2] >> 2)) >>
         12;
}

bool in_grid(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  return x_u >= field.x0_u && x_u < field.x1_u() && y_u >= field.y0_u &&
         y_u < field.y1_u();
}

}  // namespace

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  namespace glyph = format::glyph;
  if (record.size < glyph::kBytes) {
    return Status::corrupt;
  }
  const uint8_t* at = record.data;
  if (at[glyph::kType] != glyph::kTypeSamples) {
    return Status::unsupported;
  }
  GlyphField field;
  field.tile_log2 = at[glyph::kTileLog2];
  field.x0_u = load_i16(at + glyph::kX0);
  field.y0_u = load_i16(at + glyph::kY0);
  field.tiles_x = at[glyph::kTilesX];
  field.tiles_y = at[glyph::kTilesY];
  field.node_count = load_u16(at + glyph::kNodeCount);
  field.cell_count = load_u16(at + glyph::kCellCount);
  if (field.tile_log2 > glyph::kMaxTileLog2) {
    return Status::corrupt;
  }
  if (field.x0_u < -glyph::kGridLimit || field.x1_u() > glyph::kGridLimit ||
      field.y0_u < -glyph::kGridLimit || field.y1_u() > glyph::kGridLimit) {
    return Status::corrupt;
  }
  const uint32_t tiles = static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  const uint32_t reference_bytes = 2 * (tiles + 4u * field.node_count);
  if (record.size < glyph::kBytes + reference_bytes +
                        format::samples::kBytes * field.cell_count) {
    return Status::corrupt;
  }
  field.references = at + glyph::kBytes;
  field.cells = field.references + reference_bytes;
  out = field;
  return Status::ok;
}

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
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

void SamplesRow::set_up(const uint8_t* samples,
                        uint8_t cell_size_log2,
                        int32_t y_q16) noexcept {
  const Offsets o = load_offsets(samples);
  const Weights w = lagrange_q14(y_q16 >> (cell_size_log2 + 2));
  int32_t v[3];
  for (int j = 0; j < 3; ++j) {
    v[j] = (w.w1 * o.d[j] + w.w2 * o.d[3 + j] + w.w3 * o.d[6 + j] + 128) >> 8;
  }
  a_q6 = v[0];
  b_q6 = 4 * v[1] - 3 * v[0] - v[2];
  c_q6 = 2 * (v[0] - 2 * v[1] + v[2]);
  centre_q10 = load_i16(samples + format::samples::kCentre) *
               (1 << (10 - format::samples::kCentreFraction));
  size_log2 = cell_size_log2;
}

Q22_10 samples_distance(const uint8_t* samples,
                        uint8_t size_log2,
                        int32_t x_q16,
                        int32_t y_q16) noexcept {
  SamplesRow row;
  row.set_up(samples, size_log2, y_q16);
  return Q22_10::from_raw(row.distance_q10(x_q16));
}

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  if (!in_grid(field, x.floor(), y.floor())) {
    return Q22_10::from_raw(-kSaturatedDistanceQ10);
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.samples == nullptr) {
    return Q22_10::from_raw(cell.inside ? kSaturatedDistanceQ10
                                        : -kSaturatedDistanceQ10);
  }
  return samples_distance(cell.samples, cell.size_log2,
                          x.raw - cell.x0_u * (1 << 16),
                          y.raw - cell.y0_u * (1 << 16));
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  Gradient gradient;
  if (!in_grid(field, x.floor(), y.floor())) {
    return gradient;
  }
  const Cell cell = locate(field, x.floor(), y.floor());
  if (cell.samples == nullptr) {
    return gradient;
  }
  const int shift = cell.size_log2 + 2;
  const int32_t tx = (x.raw - cell.x0_u * (1 << 16)) >> shift;
  const int32_t ty = (y.raw - cell.y0_u * (1 << 16)) >> shift;
  const Offsets o = load_offsets(cell.samples);
  // A quantum is 1/128 of the cell, and so is the slope's unit: Q6 quanta per
  // cell size are Q13 of pure slope.
  gradient.x.raw =
      clamp_i16(2 * weigh_q6(o, lagrange_slope_q14(tx), lagrange_q14(ty)));
  gradient.y.raw =
      clamp_i16(2 * weigh_q6(o, lagrange_q14(tx), lagrange_slope_q14(ty)));
  return gradient;
}

}  // namespace inkcell
