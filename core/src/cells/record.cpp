#include "cells/record.hpp"

#include "base/bytes.hpp"
#include "cells/leaf_reader.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {

// Not inline: what is read goes to its place at once.
__attribute__((noinline)) Status detail::read_record(
    Span<const uint8_t> record, GlyphField& field) noexcept {
  namespace glyph = format::glyph;
  namespace edges = format::edges;
  namespace linked = format::linked;
  using Kind = GlyphField::Kind;
  const uint8_t* const at = record.data;
  if (record.size == 0) {
    return Status::corrupt;
  }
  const bool of_fields = at[glyph::kType] == glyph::kTypeEdges;
  if (of_fields ? INKCELL_EDGE_CELLS == 0
                : INKCELL_SAMPLE_CELLS == 0 ||
                      at[glyph::kType] != glyph::kTypeSamples) {
    return Status::unsupported;
  }
  if (record.size < linked::kBytes ||
      reinterpret_cast<uintptr_t>(at) % format::glyphs::kRecordAlignment != 0) {
    return Status::corrupt;
  }
  uint32_t log2 = at[glyph::kTileLog2];
  uint32_t bytes = glyph::kBytes;
  int32_t grid_limit = glyph::kGridLimit;
  if (of_fields) {
    field.kind = Kind::narrow_fields;
    bytes = edges::kBytes;
    grid_limit = edges::kGridLimit;
    if ((log2 & linked::kFlag) != 0) {
      field.kind = Kind::linked_fields;
      bytes = linked::kBytes;
      log2 -= linked::kFlag;
    }
  }
  field.tile_log2 = static_cast<uint8_t>(log2);
  field.x0_u = detail::load_i16(at + glyph::kX0);
  field.y0_u = detail::load_i16(at + glyph::kY0);
  field.tiles_x = at[glyph::kTilesX];
  field.tiles_y = at[glyph::kTilesY];
  if (record.size < bytes || log2 > glyph::kMaxTileLog2 ||
      field.x0_u < -grid_limit || field.x1_u() > grid_limit ||
      field.y0_u < -grid_limit || field.y1_u() > grid_limit) {
    return Status::corrupt;
  }
  // Of what follows the header: cells first where they are fields.
  field.cells = at + bytes;
  const uint32_t tiles = static_cast<uint32_t>(field.tiles_x) * field.tiles_y;
  const uint16_t first_count = detail::load_u16(at + glyph::kNodeCount);
  uint32_t reference_bytes = tiles + 4u * first_count;
  if (field.kind == Kind::linked_fields) {
    field.heap_units = first_count;
    if (tiles > first_count || first_count > linked::kMaxUnits) {
      return Status::corrupt;
    }
    reference_bytes = 2u * first_count;
  } else {
    field.node_count = first_count;
    if (detail::has_fields(field)) {
      field.arc_count = detail::load_u16(at + edges::kArcCount);
      field.line_count = detail::load_u16(at + edges::kLineCount);
      field.pair_count = detail::load_u16(at + edges::kPairCount);
      field.triple_count = detail::load_u16(at + edges::kTripleCount);
      bytes += edges::kArcBytes * field.arc_count +
               edges::kLineBytes * field.line_count +
               edges::kPairUnits * field.pair_count +
               edges::kTripleUnits * field.triple_count;
    }
  }
  field.references = at + bytes;
  if (!detail::has_fields(field)) {
    reference_bytes *= 2;
    field.cell_count = detail::load_u16(at + glyph::kCellCount);
    field.cells += reference_bytes;
    bytes += format::samples::kBytes * field.cell_count;
  }
  return record.size < bytes + reference_bytes ? Status::corrupt : Status::ok;
}

Status GlyphField::open(Span<const uint8_t> record, GlyphField& out) noexcept {
  GlyphField field;
  INKCELL_TRY(detail::read_record(record, field));
  out = field;
  return Status::ok;
}

}  // namespace inkcell
