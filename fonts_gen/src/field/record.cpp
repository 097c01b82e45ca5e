#include "field/record.hpp"

#include "inkcell/format/rom.hpp"

namespace inkcell::gen {

Bytes field_record(const SampleTree& field) {
  Bytes out;
  put_u8(out, format::glyph::kTypeSamples);
  put_u8(out, static_cast<unsigned>(field.tile_log2));
  put_i16(out, field.x0_u);
  put_i16(out, field.y0_u);
  put_u8(out, static_cast<unsigned>(field.tiles_x));
  put_u8(out, static_cast<unsigned>(field.tiles_y));
  put_u16(out, static_cast<unsigned>(field.node_count()));
  put_u16(out, static_cast<unsigned>(field.cells.size()));
  for (const uint16_t reference : field.references) {
    put_u16(out, reference);
  }
  for (const SampleCell& cell : field.cells) {
    out.insert(out.end(), cell.begin(), cell.end());
  }
  return out;
}

}  // namespace inkcell::gen
