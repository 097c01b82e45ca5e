#include "source/font_layers.hpp"

#include <hb-ot.h>

#include <vector>

#include "inkcell/format/rom.hpp"
#include "source/glyph_reader.hpp"

namespace inkcell::gen {
namespace {

constexpr unsigned kOfText = 0xffff;  // a colour that is that of the text

std::vector<hb_color_t> first_palette(hb_face_t* face) {
  unsigned count = hb_ot_color_palette_get_colors(face, 0, 0, nullptr, nullptr);
  std::vector<hb_color_t> colours(count);
  hb_ot_color_palette_get_colors(face, 0, 0, &count, colours.data());
  return colours;
}

}  // namespace

void read_layers(const FontFile& file, SourceGlyph& glyph, Warnings& warnings) {
  const unsigned count = hb_ot_color_glyph_get_layers(
      file.hb_face(), glyph.source, 0, nullptr, nullptr);
  if (count == 0) {
    return;
  }
  unsigned read = count;
  std::vector<hb_ot_color_layer_t> layers(count);
  hb_ot_color_glyph_get_layers(file.hb_face(), glyph.source, 0, &read,
                               layers.data());
  const std::vector<hb_color_t> colours = first_palette(file.hb_face());
  for (const hb_ot_color_layer_t& layer : layers) {
    PaintedOutline painted;
    if (layer.color_index == kOfText) {
      painted.paint.is_ink = true;
    } else if (layer.color_index < colours.size()) {
      const hb_color_t colour = colours[layer.color_index];
      // Bytes, from the highest: blue, green, red, alpha.
      painted.paint = {static_cast<uint8_t>(colour >> 8),
                       static_cast<uint8_t>(colour >> 16),
                       static_cast<uint8_t>(colour >> 24),
                       static_cast<uint8_t>(colour), false};
    } else {
      file.refuse(glyph.name() + ": a layer has colour " +
                  std::to_string(layer.color_index) + " of a palette of " +
                  std::to_string(colours.size()) + "; " +
                  glyph.remedy("repair table COLR"));
    }
    SourceGlyph part;
    part.file_name = glyph.file_name;
    part.source = layer.glyph;
    read_glyph(file, part, warnings);
    painted.outline = std::move(part.outline);
    if (!painted.outline.contours.empty()) {
      glyph.painted.push_back(std::move(painted));
    }
  }
}

}  // namespace inkcell::gen
