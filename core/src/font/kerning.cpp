#include "font/kerning.hpp"

#include "base/bytes.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

bool Kerning::open(const Span<const uint8_t>& section) noexcept {
  namespace kerning = format::kerning;
  if (section.size < kerning::kBytes) {
    return false;
  }
  const uint8_t* at = section.data;
  pair_count = load_u32(at + kerning::kPairs);
  member_count = load_u16(at + kerning::kMembers);
  left_classes = load_u16(at + kerning::kLeftClasses);
  glyph_bits = at[kerning::kGlyphBits];
  left_bits = at[kerning::kLeftBits];
  right_bits = at[kerning::kRightBits];
  value_bits = at[kerning::kValueBits];
  members = {&section, 8 * kerning::kBytes,
             glyph_bits + left_bits + right_bits};
  row_starts = {&section, members.first_bit + member_count * members.row_bits,
                at[kerning::kStartBits]};
  pairs = {&section,
           row_starts.first_bit + (left_classes + 1u) * row_starts.row_bits,
           right_bits + value_bits};
  // No sum of these passes 32 bits, whatever the widths.
  return pair_count <= kerning::kMaxPairs &&
         bits_fit(section, 0, pairs.first_bit + pair_count * pairs.row_bits);
}

}  // namespace detail

int32_t Font::kerning(uint16_t left, uint16_t right) const noexcept {
  using detail::BitTable;
  detail::Kerning kerning;
  if (left >= glyph_count_ || right >= glyph_count_) {
    return pages_ != nullptr ? pages_->kerning(*pages_, left, right) : 0;
  }
  if (!kerning.open(kerning_table())) {
    return 0;
  }
  const auto member = [&kerning](uint32_t glyph) noexcept {
    return kerning.members.find(0, kerning.member_count, kerning.glyph_bits,
                                glyph);
  };
  // Most glyphs of a text kern with nothing on their right.
  const uint32_t left_member = member(left);
  if (left_member == BitTable::kAbsent) {
    return 0;
  }
  const uint32_t row = kerning.left_class(left_member);
  if (row == 0 || row > kerning.left_classes) {
    return 0;
  }
  const uint32_t right_member = member(right);
  if (right_member == BitTable::kAbsent) {
    return 0;
  }
  const uint32_t column = kerning.right_class(right_member);
  const uint32_t end = kerning.row_start(row);
  const uint32_t pair =
      kerning.pairs.find(kerning.row_start(row - 1),
                         end < kerning.pair_count ? end : kerning.pair_count,
                         kerning.right_bits, column);
  if (pair == BitTable::kAbsent) {
    return 0;
  }
  const uint32_t base =
      detail::load_u16(kerning_table().data + format::kerning::kValueBase);
  return static_cast<int16_t>(
      base + kerning.pairs.get(pair, kerning.right_bits, kerning.value_bits));
}

}  // namespace inkcell
