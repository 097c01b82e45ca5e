#include "bit_table.hpp"

#include "bytes.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace detail {

uint32_t read_last_bits(Span<const uint8_t> bytes,
                        uint32_t bit,
                        uint32_t width) noexcept {
  const uint32_t first = bit / 8;
  const uint32_t shift = bit % 8;
  const uint32_t count = (shift + width + 7) / 8;
  if (width > format::bit_table::kMaxBits || first > bytes.size ||
      count > bytes.size - first) {
    return 0;
  }
  uint32_t read = 0;
  for (uint32_t i = 0; i < count; ++i) {
    read |= uint32_t{bytes[first + i]} << (8 * i);
  }
  return read >> shift & ((uint32_t{1} << width) - 1);
}

bool bits_fit(Span<const uint8_t> section,
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
  const Span<const uint8_t> bytes = {at + kerning::kBytes,
                                     section.size - kerning::kBytes};
  members = {bytes, 0, uint32_t{glyph_bits} + left_bits + right_bits};
  row_starts = {bytes, member_count * members.row_bits,
                at[kerning::kStartBits]};
  pairs = {bytes,
           row_starts.first_bit + (left_classes + 1u) * row_starts.row_bits,
           uint32_t{right_bits} + value_bits};
  // No sum of these passes 32 bits, whatever the widths.
  return pair_count <= kerning::kMaxPairs &&
         bits_fit(section, kerning::kBytes,
                  pairs.first_bit + pair_count * pairs.row_bits);
}

}  // namespace detail
}  // namespace inkcell
