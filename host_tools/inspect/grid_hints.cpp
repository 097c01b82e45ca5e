#include "grid_hints.hpp"

#include <algorithm>
#include <cstddef>

#include "bit_reader.hpp"
#include "bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::tools {
namespace {

namespace grid = format::grid;

int read_position(BitReader& bits) {
  return grid::kPositionBase +
         grid::kPositionStep * static_cast<int>(bits.read(grid::kPositionBits));
}

int read_width(BitReader& bits, int standard_u) {
  return bits.read(1) != 0 ? standard_u
                           : grid::kPositionStep *
                                 static_cast<int>(bits.read(grid::kWidthBits));
}

// The height of an edge in a zone.
int read_zone(BitReader& bits, const GridHints& font, HeightHint& hint) {
  const uint32_t zone = bits.read(grid::kZoneBits);
  const bool is_round = bits.read(1) != 0;
  if (zone >= font.zones.size()) {
    return 0;
  }
  hint.zone = static_cast<int>(zone);
  return font.zones[zone].flat_u +
         (is_round ? font.zones[zone].overshoot_u : 0);
}

HeightHint read_height(BitReader& bits, const GridHints& font) {
  HeightHint hint;
  hint.kind = static_cast<HeightHint::Kind>(bits.read(grid::kHeightKindBits));
  if (hint.kind == HeightHint::Kind::free_end) {
    hint.rises = bits.read(1) != 0;
    hint.low_u = read_position(bits);
    hint.high_u = hint.low_u;
    return hint;
  }
  if (hint.kind == HeightHint::Kind::edge) {
    hint.low_u = read_zone(bits, font, hint);
    hint.high_u = hint.low_u;
    return hint;
  }
  const bool is_top = bits.read(1) != 0;
  const int edge =
      bits.read(1) != 0 ? read_zone(bits, font, hint) : read_position(bits);
  const int width = read_width(bits, font.bar_width_u);
  hint.low_u = is_top ? edge - width : edge;
  hint.high_u = hint.low_u + width;
  return hint;
}

AcrossHint read_across(BitReader& bits, const GridHints& font) {
  AcrossHint hint;
  hint.is_foot = bits.read(1) == grid::kFoot;
  hint.left_u = read_position(bits);
  hint.right_u =
      hint.left_u + (hint.is_foot ? 0 : read_width(bits, font.stem_width_u));
  return hint;
}

GlyphHints read_glyph(Span<const uint8_t> record, const GridHints& font) {
  BitReader bits(record, 0);
  GlyphHints glyph;
  glyph.is_symmetric = bits.read(1) != 0;
  const bool has_insets = bits.read(1) != 0;
  const uint32_t heights = bits.read(grid::kHeightCountBits);
  const uint32_t across = bits.read(grid::kAcrossCountBits);
  if (has_insets) {
    const auto read_inset = [&bits] {
      return grid::kPositionStep *
             static_cast<int>(bits.read(grid::kInsetBits));
    };
    glyph.left_inset_u = read_inset();
    glyph.right_inset_u = read_inset();
  }
  for (uint32_t i = 0; i < heights; ++i) {
    glyph.heights.push_back(read_height(bits, font));
  }
  for (uint32_t i = 0; i < across; ++i) {
    glyph.across.push_back(read_across(bits, font));
  }
  return glyph;
}

// Number `index` of a bit table of the container, the lowest bits first.
uint32_t table_number(Span<const uint8_t> table, size_t index, uint32_t width) {
  uint32_t value = 0;
  for (uint32_t bit = 0; bit < width; ++bit) {
    const size_t at = index * width + bit;
    const uint32_t byte = at / 8 < table.size ? table.data[at / 8] : 0;
    value |= (byte >> at % 8 & 1) << bit;
  }
  return value;
}

void read_zones(Span<const uint8_t> section, GridHints& hints) {
  const size_t count = std::min<size_t>(
      section[grid::kZones], (section.size - grid::kBytes) / grid::kZoneBytes);
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* zone = section.data + grid::kBytes + i * grid::kZoneBytes;
    hints.zones.push_back(
        {static_cast<int16_t>(read_u16(zone + grid::kZoneFlat)),
         static_cast<int8_t>(zone[grid::kZoneOvershoot]),
         (zone[grid::kZoneFlags] & grid::kTopZone) != 0});
  }
}

}  // namespace

GridHints grid_hints(const Font& font) {
  GridHints hints;
  const Span<const uint8_t> section = font.section(format::section::kGrid);
  if (section.size < grid::kBytes) {
    return hints;
  }
  hints.is_there = true;
  hints.has_contrast = (section[grid::kFlags] & grid::kContrast) != 0;
  hints.has_few_bars = (section[grid::kFlags] & grid::kFewBars) != 0;
  hints.stem_width_u = section[grid::kStemWidth];
  hints.bar_width_u = section[grid::kBarWidth];
  read_zones(section, hints);
  if (section[grid::kXZone] < hints.zones.size()) {
    hints.x_zone = section[grid::kXZone];
  }
  const size_t table_at = grid::kBytes + hints.zones.size() * grid::kZoneBytes;
  const Span<const uint8_t> table = {section.data + table_at,
                                     section.size - table_at};
  const uint32_t width =
      std::min<uint32_t>(section[grid::kOffsetBits], grid::kMaxOffsetBits);
  const size_t glyphs = font.glyph_count();
  const size_t records_at = ((glyphs + 1) * width + 7) / 8;
  for (size_t i = 0; i < glyphs; ++i) {
    const size_t begin = records_at + table_number(table, i, width);
    const size_t end = records_at + table_number(table, i + 1, width);
    const bool is_inside = begin <= end && end <= table.size;
    const Span<const uint8_t> record = {table.data + (is_inside ? begin : 0),
                                        is_inside ? end - begin : 0};
    hints.glyphs.push_back(read_glyph(record, hints));
  }
  return hints;
}

const char* kind_name(HeightHint::Kind kind) {
  switch (kind) {
    case HeightHint::Kind::bar:
      return "bar";
    case HeightHint::Kind::serif:
      return "serif";
    case HeightHint::Kind::edge:
      return "edge";
    case HeightHint::Kind::free_end:
      break;
  }
  return "free end";
}

}  // namespace inkcell::tools
