#include "grid_hints.hpp"

#include <algorithm>
#include <cstddef>

#include "bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::tools {
namespace {

namespace grid = format::grid;

// Reads the last bits of a record, from its last byte on.
class HintReader {
 public:
  HintReader(Span<const uint8_t> record,
             Span<const uint8_t> section,
             const GridHints& font)
      : record_(record), section_(section), font_(font) {}

  GlyphHints read() {
    GlyphHints glyph;
    const uint32_t head = number(grid::kHeads);
    glyph.is_symmetric = (head & grid::kSymmetric) != 0;
    if ((head & grid::kHasInsets) != 0) {
      const auto inset = [this] {
        return grid::kPositionStep * static_cast<int>(bits(grid::kInsetBits));
      };
      glyph.left_inset_u = inset();
      glyph.right_inset_u = inset();
    }
    uint32_t at = uint32_t{section_[grid::kFirstY]} << grid::kFirstShift;
    uint32_t count = head >> grid::kHeightCountShift & grid::kHeightCountMask;
    for (; count != 0; --count) {
      glyph.heights.push_back(height(at));
      at = position_of(glyph.heights.back().low_u);
    }
    at = uint32_t{section_[grid::kFirstX]} << grid::kFirstShift;
    for (count = head & grid::kStemCountMask; count != 0; --count) {
      StemHint stem;
      stem.left_u = position(grid::kGapsX, at);
      stem.right_u = stem.left_u + width(grid::kWidthsX, font_.stem_width_u);
      at = position_of(stem.right_u);
      glyph.stems.push_back(stem);
    }
    return glyph;
  }

 private:
  static uint32_t position_of(int at_u) {
    return static_cast<uint32_t>(at_u - grid::kPositionBase) >> 1;
  }

  // Numbers begin with their lowest bit.
  uint32_t peek(int count) const {
    uint32_t value = 0;
    for (int i = 0; i < count; ++i) {
      const size_t at = bit_ + static_cast<size_t>(i);
      if (at / 8 < record_.size) {
        value |= (record_[record_.size - 1 - at / 8] >> at % 8 & 1u) << i;
      }
    }
    return value;
  }
  uint32_t bits(int count) {
    const uint32_t value = peek(count);
    bit_ += static_cast<size_t>(count);
    return value;
  }
  uint32_t number(uint32_t table) {
    const int code_bits = section_[grid::kCodeBits];
    const size_t at = grid::kBytes + font_.zones.size() * grid::kZoneBytes +
                      2 * ((size_t{table} << code_bits) + peek(code_bits));
    const uint32_t entry =
        at + 2 <= section_.size ? read_u16(section_.data + at) : 0u;
    bit_ += entry & grid::kLengthMask;
    return (entry >> grid::kBaseShift) +
           bits(
               static_cast<int>(entry >> grid::kExtraShift & grid::kExtraMask));
  }
  int position(uint32_t table, uint32_t at) {
    return grid::kPositionBase +
           grid::kPositionStep *
               static_cast<int>((at + number(table)) & grid::kPositionMask);
  }
  int width(uint32_t table, int standard_u) {
    const uint32_t stored = number(table) & grid::kWidthMask;
    return stored == 0 ? standard_u
                       : grid::kPositionStep * static_cast<int>(stored);
  }

  HeightHint height(uint32_t at) {
    HeightHint hint;
    const uint32_t word = number(grid::kHeights);
    hint.kind = static_cast<HeightHint::Kind>(word >> grid::kKindShift &
                                              grid::kKindMask);
    const bool is_top = (word & grid::kTop) != 0;
    const uint32_t zone = word >> grid::kZoneShift & grid::kZoneMask;
    int edge_u = 0;
    if (zone == 0) {
      edge_u = position(grid::kGapsY, at);
    } else if (zone <= font_.zones.size()) {
      hint.zone = static_cast<int>(zone - 1);
      edge_u =
          font_.zones[zone - 1].flat_u +
          ((word & grid::kRound) != 0 ? font_.zones[zone - 1].overshoot_u : 0);
    }
    const bool is_stroke = hint.kind == HeightHint::Kind::bar ||
                           hint.kind == HeightHint::Kind::serif;
    const int thick = is_stroke ? width(grid::kWidthsY, font_.bar_width_u) : 0;
    hint.low_u = is_top ? edge_u - thick : edge_u;
    hint.high_u = hint.low_u + thick;
    hint.rises = hint.kind == HeightHint::Kind::free_end && is_top;
    return hint;
  }

  Span<const uint8_t> record_;
  Span<const uint8_t> section_;
  const GridHints& font_;
  size_t bit_ = 0;
};

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
  for (uint32_t i = 0; i < font.glyph_count(); ++i) {
    const Span<const uint8_t> record = font.record(static_cast<uint16_t>(i));
    hints.glyphs.push_back(record.size == 0 ||
                                   section[grid::kCodeBits] > grid::kMaxCodeBits
                               ? GlyphHints()
                               : HintReader(record, section, hints).read());
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
