#include "inkcell/layers/verify.hpp"

#include "base/bit_table.hpp"
#include "inkcell/format/rom.hpp"
#include "layer_table.hpp"

namespace inkcell {

namespace {

bool has_glyph(const Font& font, uint32_t glyph) noexcept {
  return font.page_of(glyph) != nullptr;
}

}  // namespace

Status verify_layers(const Font& font, const StoredLayers* stored) noexcept {
  namespace head = format::layers;
  const detail::LayerTable table(font, stored);
  if (table.bytes == 0) {
    return Status::ok;
  }
  constexpr uint32_t kMaxBits = format::metrics::kMaxBits;
  if (table.bytes < head::kBytes || table.glyphs == 0 ||
      (table.palettes == 0) != (table.colours == 0) ||
      table.glyph_bits > kMaxBits || table.colour_bits > kMaxBits ||
      table.start_bits > format::bit_table::kMaxBits) {
    return Status::corrupt;
  }
  const Span<const uint8_t> section = {nullptr, table.bytes};
  const uint32_t header_bytes =
      head::kBytes + head::kColourBytes * table.colours * table.palettes;
  const uint32_t row_bits = table.glyph_bits + table.start_bits;
  const uint32_t rows_bits = (table.glyphs + 1) * row_bits;
  if (!detail::bits_fit(section, header_bytes, rows_bits)) {
    return Status::corrupt;
  }
  const uint32_t layers = table.start_at(table.glyphs);
  const uint32_t layer_bits = table.glyph_bits + table.colour_bits;
  // At most 2^25 layers of 32 bits.
  if (!detail::bits_fit(section, header_bytes,
                        rows_bits + layers * layer_bits)) {
    return Status::corrupt;
  }
  uint32_t start = 0;
  for (uint32_t row = 0; row != table.glyphs; ++row) {
    const uint32_t glyph = table.glyph_at(row);
    const uint32_t end = table.start_at(row + 1);
    if (table.start_at(row) != start || end <= start ||
        end - start > head::kMaxLayers || !has_glyph(font, glyph) ||
        (row != 0 && glyph <= table.glyph_at(row - 1))) {
      return Status::corrupt;
    }
    for (; start != end; ++start) {
      const detail::Layer layer = table.layer(start);
      if (!has_glyph(font, layer.glyph) ||
          layer.colour > table.colours + head::kMaxFaint) {
        return Status::corrupt;
      }
    }
  }
  return Status::ok;
}

}  // namespace inkcell
