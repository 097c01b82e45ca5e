#include "rom/layer_section.hpp"

#include <algorithm>

#include "base/bit_table_writer.hpp"
#include "base/byte_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {

Bytes layers_section(const RomLayers& layers) {
  Bytes out;
  if (layers.glyphs.empty()) {
    return out;
  }
  const size_t colours = layers.palettes[0].size();
  size_t glyph = layers.glyphs.back().glyph;
  size_t colour = 0;
  size_t count = 0;
  for (const RomLayers::Glyph& of : layers.glyphs) {
    count += of.layers.size();
    for (const RomLayers::Layer& layer : of.layers) {
      glyph = std::max(glyph, layer.glyph);
      colour = std::max(colour, layer.colour);
    }
  }
  const auto width = [](size_t most) {
    return width_of(static_cast<uint32_t>(most));
  };
  const auto put = [](BitTableWriter& table, size_t value, unsigned bits) {
    table.put(static_cast<uint32_t>(value), bits);
  };
  const unsigned glyph_bits = width(glyph);
  const unsigned colour_bits = width(colour);
  const unsigned start_bits = width(count);
  put_u16(out, static_cast<unsigned>(layers.glyphs.size()));
  put_u16(out, static_cast<unsigned>(colours));
  put_u8(out, colours == 0 ? 0 : static_cast<unsigned>(layers.palettes.size()));
  put_u8(out, glyph_bits);
  put_u8(out, colour_bits);
  put_u8(out, start_bits);
  for (const std::vector<Paint>& palette : layers.palettes) {
    for (const Paint& paint : palette) {
      for (const unsigned channel :
           {paint.red, paint.green, paint.blue, paint.opacity}) {
        put_u8(out, channel);
      }
    }
  }
  BitTableWriter table(out);
  size_t start = 0;
  for (const RomLayers::Glyph& of : layers.glyphs) {
    put(table, of.glyph, glyph_bits);
    put(table, start, start_bits);
    start += of.layers.size();
  }
  put(table, 0, glyph_bits);
  put(table, start, start_bits);
  for (const RomLayers::Glyph& of : layers.glyphs) {
    for (const RomLayers::Layer& layer : of.layers) {
      put(table, layer.glyph, glyph_bits);
      put(table, layer.colour, colour_bits);
    }
  }
  return out;
}

}  // namespace inkcell::gen
