#include "base/bit_table.hpp"

#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {

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
  return read_bits(*bytes, first_bit + row * row_bits + bit, width);
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

}  // namespace inkcell::detail
