#include "base/bit_table.hpp"

#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

uint32_t read_any_bits(const Span<const uint8_t>& bytes,
                       uint32_t bit,
                       uint32_t width) noexcept {
  if (bytes.size < 4 || width - 1 >= format::bit_table::kMaxBits) {
    return 0;
  }
  // Four bytes hold any number: those from its first one on, or the last ones.
  const uint32_t last = static_cast<uint32_t>(bytes.size) - 4;
  const uint32_t first = bit / 8 < last ? bit / 8 : last;
  const uint32_t shift = bit - 8 * first;
  if (shift > 32 - width) {
    return 0;
  }
  return load_any_u32(bytes.data + first) >> shift & ~(~uint32_t{0} << width);
}

bool bits_fit(const Span<const uint8_t>& section,
              uint32_t header_bytes,
              uint32_t bits) noexcept {
  return section.size >= header_bytes &&
         (bits + 7) / 8 <= section.size - header_bytes;
}

uint32_t BitTable::get(uint32_t row,
                       uint32_t bit,
                       uint32_t width) const noexcept {
  return read_bits(bytes, first_bit + row * row_bits + bit, width);
}

uint32_t BitTable::find(uint32_t begin,
                        uint32_t end,
                        uint32_t key_bits,
                        uint32_t key) const noexcept {
  // Invariant: the row, if there is one, is at begin <= i < end.
  while (begin < end) {
    const uint32_t middle = begin + (end - begin) / 2;
    const uint32_t found = get(middle, 0, key_bits);
    if (found == key) {
      return middle;
    }
    if (found < key) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return kAbsent;
}

bool Kerning::open(Span<const uint8_t> section) noexcept {
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
  members = {section, 8 * kerning::kBytes,
             uint32_t{glyph_bits} + left_bits + right_bits};
  row_starts = {section, members.first_bit + member_count * members.row_bits,
                at[kerning::kStartBits]};
  pairs = {section,
           row_starts.first_bit + (left_classes + 1u) * row_starts.row_bits,
           uint32_t{right_bits} + value_bits};
  // No sum of these passes 32 bits, whatever the widths.
  return pair_count <= kerning::kMaxPairs &&
         bits_fit(section, 0, pairs.first_bit + pair_count * pairs.row_bits);
}

}  // namespace detail
}  // namespace inkcell
