// A font whose A has layers, written bit by bit, independently of the
// generator.
#pragma once

#include <stdint.h>

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/canvas_colour.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outline_record.hpp"
#include "strike_font.hpp"

namespace layer_font {

using inkcell::Font;
using inkcell::LayerColour;
using inkcell::Span;
namespace colr = inkcell::format::layers;

/// A layer as the section has it.
struct Row {
  uint32_t glyph;
  uint32_t colour;
};

/// Section COLR, written number by number: the layers of one glyph.
class LayerWriter {
 public:
  LayerWriter(uint32_t glyph,
              Span<const LayerColour> palettes,
              uint32_t colours,
              Span<const Row> rows) {
    uint8_t* const at = bytes_;
    font_builder::put_u16(at + colr::kGlyphs, 1);
    font_builder::put_u16(at + colr::kColours, colours);
    at[colr::kPalettes] =
        static_cast<uint8_t>(colours == 0 ? 0 : palettes.size / colours);
    at[colr::kGlyphBits] = 5;
    at[colr::kColourBits] = 9;
    at[colr::kStartBits] = 7;
    size_ = colr::kBytes;
    for (const LayerColour& colour : palettes) {
      const uint8_t channels[] = {colour.red, colour.green, colour.blue,
                                  colour.opacity};
      for (const uint8_t channel : channels) {
        bytes_[size_++] = channel;
      }
    }
    bit_ = 8 * size_;
    put(glyph, 5);
    put(0, 7);
    put(0, 5);
    put(static_cast<uint32_t>(rows.size), 7);
    for (const Row& row : rows) {
      put(row.glyph, 5);
      put(row.colour, 9);
    }
    size_ = (bit_ + 7) / 8;
  }

  Span<const uint8_t> bytes() const { return {bytes_, size_}; }

 private:
  void put(uint32_t value, uint32_t width) {
    for (; width != 0; --width, value >>= 1, ++bit_) {
      bytes_[bit_ / 8] |= static_cast<uint8_t>((value & 1) << bit_ % 8);
    }
  }

  alignas(4) uint8_t bytes_[256] = {};
  size_t size_ = 0;
  size_t bit_ = 0;
};

inline constexpr LayerColour kPalettes[] = {
    {255, 200, 0, 255}, {0, 60, 200, 128}, {9, 8, 7, 255}, {40, 50, 60, 255}};
inline constexpr uint32_t kColours = 2;
inline constexpr uint16_t kDisc = 1;
inline constexpr uint16_t kEll = 3;
inline constexpr uint16_t kLeaf = 5;

/// A disc, half a leaf over it, and an L in the colour of text, which is also
// there with an opacity of 100.
inline constexpr Row kRows[] = {
    {kDisc, 0}, {kLeaf, 1}, {kEll, kColours}, {kLeaf, kColours + 155}};

alignas(4) inline uint8_t rom[outline_record::kSampleFontBytes + 512];

/// The sample font, whose A has layers; the one of the call before is gone.
inline Font font_with(Span<const uint8_t> section) {
  size_t size = outline_record::build_sample_font(rom);
  if (section.size != 0) {
    size = strike_font::add_section({rom, sizeof rom}, size,
                                    inkcell::format::section::kLayers, section);
  }
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font;
}
inline Font font_with(Span<const Row> rows) {
  return font_with(LayerWriter(kDisc, kPalettes, kColours, rows).bytes());
}

}  // namespace layer_font
