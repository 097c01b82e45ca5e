#include "inkcell/field/glyph_field.hpp"

#include "base/math.hpp"
#include "field_sampler.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

using detail::FieldPlace;
using detail::FieldSampler;
using detail::max;
using detail::min;

FieldPlace place_of(Q16_16 x, Q16_16 y) noexcept {
  return {x.raw, y.raw};
}

// Beyond what the cells know: the greater of the band and the distance to the
// box of the ink.
FieldPoint bound_at(const GlyphField& field,
                    Q16_16 x,
                    Q16_16 y,
                    bool is_inside) noexcept {
  // 1024 u and more are the same. [Q5 u]
  constexpr int32_t kMost = 1 << 15;
  const auto offset_q5 = [](int32_t at_q16, int32_t low_u, int32_t high_u) {
    const int32_t at = at_q16 >> 11;
    const int32_t offset = at < low_u * 32    ? low_u * 32 - at
                           : at > high_u * 32 ? high_u * 32 - at
                                              : 0;
    return min(max(offset, -kMost), kMost);
  };
  FieldPoint point;
  point.is_bound = true;
  int32_t distance_q5 = field.band_u * 32;
  if (!is_inside) {
    const int32_t right = offset_q5(x.raw, field.ink.x0_u, field.ink.x1_u);
    const int32_t up = offset_q5(y.raw, field.ink.y0_u, field.ink.y1_u);
    // 2^30 each, and twice that together.
    const auto away = static_cast<int32_t>(detail::root_of(
        static_cast<uint32_t>(right * right) + static_cast<uint32_t>(up * up)));
    if (away > 0) {
      point.gradient.x.raw = static_cast<int16_t>(right * (1 << 14) / away);
      point.gradient.y.raw = static_cast<int16_t>(up * (1 << 14) / away);
    }
    distance_q5 = max(distance_q5, away);
  }
  distance_q5 = min(distance_q5, kMost);
  point.distance.raw = (is_inside ? distance_q5 : -distance_q5) * 32;
  return point;
}

}  // namespace

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  namespace glyph = format::glyph;
  const uint8_t* const at = record.data;
  if (record.size == 0) {
    return Status::corrupt;
  }
  if (at[glyph::kType] != glyph::kTypeSamples) {
    return Status::unsupported;
  }
  if (record.size < glyph::kBytes ||
      reinterpret_cast<uintptr_t>(at) % format::glyphs::kRecordAlignment != 0) {
    return Status::corrupt;
  }
  GlyphField field;
  field.tile_log2 = at[glyph::kTileLog2];
  field.x0_u = detail::load_i16(at + glyph::kX0);
  field.y0_u = detail::load_i16(at + glyph::kY0);
  field.tiles_x = at[glyph::kTilesX];
  field.tiles_y = at[glyph::kTilesY];
  constexpr int32_t kLimit = glyph::kGridLimit;
  if (field.tile_log2 > glyph::kMaxTileLog2 || field.x0_u < -kLimit ||
      field.x1_u() > kLimit || field.y0_u < -kLimit || field.y1_u() > kLimit) {
    return Status::corrupt;
  }
  field.node_count = detail::load_u16(at + glyph::kNodeCount);
  field.cell_count = detail::load_u16(at + glyph::kCellCount);
  field.references = at + glyph::kBytes;
  field.cells = field.references + 2 * detail::FieldTree{field}.tile_count() +
                8u * field.node_count;
  if (record.size < record_bytes(field)) {
    return Status::corrupt;
  }
  out = field;
  return Status::ok;
}

size_t record_bytes(const GlyphField& field) noexcept {
  return field.references == nullptr
             ? 0
             : static_cast<size_t>(field.cells - field.references) +
                   format::glyph::kBytes +
                   size_t{format::samples::kBytes} * field.cell_count;
}

Status read_field(const Font& font, uint16_t glyph, GlyphField& out) noexcept {
  if (glyph >= font.glyph_count()) {
    return Status::no_glyph;
  }
  const Span<const uint8_t> record = font.record(glyph);
  if (record.size == 0) {
    out = {};
    return Status::ok;
  }
  INKCELL_TRY(GlyphField::open(record, out));
  out.ink = font.ink_box(glyph);
  return Status::ok;
}

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  return Q22_10::from_raw(FieldSampler(field).distance_q10(place_of(x, y)));
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  return FieldSampler(field).gradient(place_of(x, y));
}

FieldPoint point_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  FieldSampler sampler(field);
  const FieldPoint point = sampler.point(place_of(x, y));
  if (sampler.leaf().samples == nullptr) {
    return bound_at(field, x, y, sampler.leaf().is_inside);
  }
  const bool is_far = field.band_u != 0 &&
                      detail::abs(point.distance.raw) > field.band_u * 1024;
  return is_far ? bound_at(field, x, y, point.distance.raw > 0) : point;
}

}  // namespace inkcell
