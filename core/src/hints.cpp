#include "inkcell/hints.hpp"

#include "bit_table.hpp"
#include "bytes.hpp"
#include "hint_bytes.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace {

namespace hints = format::hints;

}  // namespace

Status Hints::open(const Font& font, Hints& out) noexcept {
  Hints read;
  read.section_ = font.section(format::section::kHints);
  if (read.section_.size == 0) {
    out = read;
    return Status::ok;
  }
  if (read.section_.size < hints::kBytes) {
    return Status::corrupt;
  }
  const uint8_t* at = read.section_.data;
  read.glyph_count_ = font.glyph_count();
  read.level_count_ = at[hints::kLevels];
  read.zone_count_ = at[hints::kZones];
  read.start_bits_ = at[hints::kStartBits];
  read.count_bits_ = at[hints::kCountBits];
  read.stem_bits_ = at[hints::kStemBits];
  read.gap_bits_ = at[hints::kGapBits];
  read.stem_base_u_ = detail::load_i16(at + hints::kStemBase);
  read.stem_width_u_ = at[hints::kStemWidth];
  read.row_bits_ = static_cast<uint16_t>(read.start_bits_ + read.count_bits_ +
                                         read.stem_bits_ + read.gap_bits_ + 1);
  read.rows_ = hints::kBytes + 2u * read.level_count_ + read.zone_count_;
  const uint32_t row_bits = uint32_t{read.row_bits_} * read.glyph_count_;
  read.lists_ = read.rows_ + (row_bits + 7) / 8;
  if (read.level_count_ > hints::kMaxLevels ||
      read.zone_count_ > hints::kMaxZones ||
      read.start_bits_ > hints::kMaxStartBits ||
      read.count_bits_ > hints::kMaxCountBits ||
      read.stem_bits_ > hints::kMaxStemBits ||
      read.gap_bits_ > hints::kMaxStemBits ||
      read.lists_ > read.section_.size) {
    return Status::corrupt;
  }
  out = read;
  return Status::ok;
}

HintLevel Hints::level(uint32_t i) const noexcept {
  return detail::hint_level(section_.data + hints::kBytes, i);
}

HintZone Hints::zone(uint32_t i) const noexcept {
  const uint32_t byte = section_[hints::kBytes + 2u * level_count_ + i];
  const uint32_t of = byte & hints::kLevelMask;
  return {of < level_count_ ? level(of).height_u : 0,
          (byte & hints::kBottomZone) != 0};
}

bool Hints::edges(uint32_t glyph, Span<const uint8_t>& out) const noexcept {
  out = {};
  if (glyph >= glyph_count_) {
    return false;
  }
  // Both numbers at once: 24 bits at the most.
  const uint32_t both =
      detail::read_bits({section_.data, lists_}, 8 * rows_ + glyph * row_bits_,
                        uint32_t{start_bits_} + count_bits_);
  const uint32_t start = both & ((uint32_t{1} << start_bits_) - 1);
  const uint32_t count = both >> start_bits_;
  const size_t room = section_.size - lists_;
  if (start > room || count > room - start) {
    return false;
  }
  out = {section_.data + lists_ + start, count};
  return true;
}

HintStems Hints::stems(uint32_t glyph) const noexcept {
  HintStems stems;
  if (glyph >= glyph_count_) {
    return stems;
  }
  // All three numbers at once: 25 bits at the most.
  const uint32_t all = detail::read_bits(
      {section_.data, lists_},
      8 * rows_ + glyph * row_bits_ + start_bits_ + count_bits_,
      uint32_t{stem_bits_} + gap_bits_ + 1);
  const uint32_t stem = all & ~(~uint32_t{0} << stem_bits_);
  const uint32_t rest = all >> stem_bits_;
  const uint32_t gap = rest & ~(~uint32_t{0} << gap_bits_);
  if (stem != 0) {
    const uint32_t third = rest >> gap_bits_;
    constexpr auto kStep = static_cast<int32_t>(hints::kStemStep);
    stems.first_u = stem_base_u_ + static_cast<int32_t>(stem) * kStep;
    stems.gap_u = static_cast<int32_t>(gap) * kStep;
    stems.count = static_cast<uint8_t>(gap == 0 ? 1 : 2 + third);
  }
  return stems;
}

HintEdge Hints::edge(uint8_t byte) noexcept {
  return detail::hint_edge(byte);
}

}  // namespace inkcell
