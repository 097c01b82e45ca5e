#include "inkcell/layers/verify.hpp"

#include "inkcell/format/rom.hpp"
#include "layer_table.hpp"

namespace inkcell {

Status verify_layers(const Font& font) noexcept {
  namespace head = format::layers;
  const detail::LayerTable table(font);
  if (table.bytes.size == 0) {
    return Status::ok;
  }
  constexpr uint32_t kMaxBits = format::metrics::kMaxBits;
  if (table.bytes.size < head::kBytes || table.glyphs == 0 ||
      (table.palettes == 0) != (table.colours == 0) ||
      table.glyph_bits > kMaxBits || table.colour_bits > kMaxBits ||
      table.start_bits > format::bit_table::kMaxBits) {
    return Status::corrupt;
  }
  const uint32_t header_bytes =
      head::kBytes + head::kColourBytes * table.colours * table.palettes;
  const uint32_t row_bits = table.glyph_bits + table.start_bits;
  const uint32_t rows_bits = (table.glyphs + 1) * row_bits;
  if (!detail::bits_fit(table.bytes, header_bytes, rows_bits)) {
    return Status::corrupt;
  }
  const detail::BitTable rows = table.rows();
  const uint32_t layers =
      rows.get(table.glyphs, table.glyph_bits, table.start_bits);
  const uint32_t layer_bits = table.glyph_bits + table.colour_bits;
  // At most 2^25 layers of 32 bits.
  if (!detail::bits_fit(table.bytes, header_bytes,
                        rows_bits + layers * layer_bits)) {
    return Status::corrupt;
  }
  uint32_t start = 0;
  for (uint32_t row = 0; row != table.glyphs; ++row) {
    const uint32_t glyph = rows.get(row, 0, table.glyph_bits);
    const uint32_t end = rows.get(row + 1, table.glyph_bits, table.start_bits);
    if (rows.get(row, table.glyph_bits, table.start_bits) != start ||
        end <= start || end - start > head::kMaxLayers ||
        glyph >= font.glyph_count() ||
        (row != 0 && glyph <= rows.get(row - 1, 0, table.glyph_bits))) {
      return Status::corrupt;
    }
    for (; start != end; ++start) {
      const detail::Layer layer = table.layer(start);
      if (layer.glyph >= font.glyph_count() ||
          layer.colour > table.colours + head::kMaxFaint) {
        return Status::corrupt;
      }
    }
  }
  return Status::ok;
}

}  // namespace inkcell
