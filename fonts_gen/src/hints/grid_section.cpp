#include "hints/grid_section.hpp"

#include <algorithm>

#include "base/bit_table_writer.hpp"
#include "base/bit_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace grid = format::grid;

int position_steps(int position_u) {
  return (position_u - grid::kPositionBase) / grid::kPositionStep;
}

void put_zone(const ZoneEdge& edge, BitWriter& bits) {
  bits.put(static_cast<int>(edge.zone), grid::kZoneBits);
  bits.put(edge.is_round ? 1 : 0, 1);
}

void put_edge(const EdgeHint& edge, BitWriter& bits) {
  bits.put(edge.zone ? 1 : 0, 1);
  if (edge.zone) {
    put_zone(*edge.zone, bits);
  } else {
    bits.put(position_steps(edge.position_u), grid::kPositionBits);
  }
}

void put_width(const std::optional<int>& width_u, BitWriter& bits) {
  bits.put(width_u ? 0 : 1, 1);
  if (width_u) {
    bits.put(*width_u / grid::kPositionStep, grid::kWidthBits);
  }
}

uint32_t kind_of(HeightHint::Kind kind) {
  switch (kind) {
    case HeightHint::Kind::bar:
      return grid::kBar;
    case HeightHint::Kind::serif:
      return grid::kSerif;
    case HeightHint::Kind::lone_edge:
      return grid::kLoneEdge;
    case HeightHint::Kind::free_end:
      break;
  }
  return grid::kFreeEnd;
}

void put_height(const HeightHint& hint, BitWriter& bits) {
  bits.put(static_cast<int>(kind_of(hint.kind)), grid::kHeightKindBits);
  switch (hint.kind) {
    case HeightHint::Kind::bar:
    case HeightHint::Kind::serif:
      bits.put(hint.is_top_edge ? 1 : 0, 1);
      put_edge(hint.edge, bits);
      put_width(hint.width_u, bits);
      return;
    case HeightHint::Kind::lone_edge:
      put_zone(*hint.edge.zone, bits);
      return;
    case HeightHint::Kind::free_end:
      bits.put(hint.rises ? 1 : 0, 1);
      bits.put(position_steps(hint.edge.position_u), grid::kPositionBits);
      return;
  }
}

void put_across(const AcrossHint& hint, BitWriter& bits) {
  const bool is_stem = hint.kind == AcrossHint::Kind::stem;
  bits.put(static_cast<int>(is_stem ? grid::kStem : grid::kFoot), 1);
  bits.put(position_steps(hint.position_u), grid::kPositionBits);
  if (is_stem) {
    put_width(hint.width_u, bits);
  }
}

}  // namespace

std::vector<uint8_t> hint_record(const GlyphHints& hints) {
  BitWriter bits;
  const bool has_insets = hints.left_inset_u != 0 || hints.right_inset_u != 0;
  bits.put(hints.is_symmetric ? 1 : 0, 1);
  bits.put(has_insets ? 1 : 0, 1);
  bits.put(static_cast<int>(hints.heights.size()), grid::kHeightCountBits);
  bits.put(static_cast<int>(hints.across.size()), grid::kAcrossCountBits);
  if (has_insets) {
    bits.put(hints.left_inset_u / grid::kPositionStep, grid::kInsetBits);
    bits.put(hints.right_inset_u / grid::kPositionStep, grid::kInsetBits);
  }
  for (const HeightHint& hint : hints.heights) {
    put_height(hint, bits);
  }
  for (const AcrossHint& hint : hints.across) {
    put_across(hint, bits);
  }
  return bits.take();
}

std::vector<uint8_t> grid_head(const FaceHints& face, unsigned offset_bits) {
  std::vector<uint8_t> out;
  const auto put = [&out](int byte) {
    out.push_back(static_cast<uint8_t>(byte));
  };
  const auto put_i16 = [&put](int value) {
    put(value & 0xff);
    put(value >> 8 & 0xff);
  };
  const auto width = [](int width_u) { return std::min(width_u, 255); };
  put(static_cast<int>(face.zones.size()));
  put(static_cast<int>((face.has_contrast ? grid::kContrast : 0) |
                       (face.has_few_bars ? grid::kFewBars : 0)));
  put(width(face.stem_width_u));
  put(width(face.bar_width_u));
  put(static_cast<int>(face.x_zone.value_or(grid::kNoZone)));
  put(static_cast<int>(offset_bits));
  put_i16(0);
  for (const HintZone& zone : face.zones) {
    put_i16(zone.flat_u);
    put(zone.overshoot_u & 0xff);
    put(zone.is_top ? static_cast<int>(grid::kTopZone) : 0);
  }
  return out;
}

std::vector<uint8_t> grid_section(const FontHints& hints) {
  if (hints.empty()) {
    return {};
  }
  std::vector<uint8_t> records;
  std::vector<uint32_t> ends = {0};
  for (const GlyphHints& glyph : hints.glyphs) {
    const std::vector<uint8_t> record = hint_record(glyph);
    records.insert(records.end(), record.begin(), record.end());
    ends.push_back(static_cast<uint32_t>(records.size()));
  }
  const unsigned offset_bits = width_of(ends.back());
  std::vector<uint8_t> out = grid_head(hints.face, offset_bits);
  BitTableWriter table(out);
  for (const uint32_t end : ends) {
    table.put(end, offset_bits);
  }
  out.insert(out.end(), records.begin(), records.end());
  return out;
}

}  // namespace inkcell::gen
