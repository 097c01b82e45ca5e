#include "bit_table.hpp"

#include "bytes.hpp"
#include "inkcell/format.hpp"

namespace inkcell {
namespace detail {
namespace {

bool widths_fit(const uint8_t* widths, uint32_t count, uint32_t most) noexcept {
  for (uint32_t i = 0; i < count; ++i) {
    if (widths[i] > most) {
      return false;
    }
  }
  return true;
}

}  // namespace

uint32_t read_bits(Span<const uint8_t> bytes,
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

bool BitTable::take(Span<const uint8_t>& rest,
                    uint32_t row_count,
                    uint32_t bits) noexcept {
  const uint32_t size = (row_count * bits + 7) / 8;
  if (size > rest.size) {
    return false;
  }
  bytes = {rest.data, size};
  rows = row_count;
  row_bits = bits;
  rest = {rest.data + size, rest.size - size};
  return true;
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

bool metrics_table(Span<const uint8_t> section,
                   uint32_t glyph_count,
                   BitTable& out) noexcept {
  namespace metrics = format::metrics;
  if (section.size < metrics::kBytes) {
    return false;
  }
  const uint8_t* widths = section.data + metrics::kColumnBits;
  if (!widths_fit(widths, metrics::kColumns, metrics::kMaxBits)) {
    return false;
  }
  uint32_t row_bits = 0;
  for (uint32_t i = 0; i < metrics::kColumns; ++i) {
    row_bits += widths[i];
  }
  Span<const uint8_t> rest = {section.data + metrics::kBytes,
                              section.size - metrics::kBytes};
  return out.take(rest, glyph_count, row_bits);
}

bool offsets_table(Span<const uint8_t> section,
                   uint32_t glyph_count,
                   BitTable& out) noexcept {
  namespace glyphs = format::glyphs;
  if (section.size < glyphs::kBytes) {
    return false;
  }
  const uint32_t width = section.data[glyphs::kOffsetBits];
  Span<const uint8_t> rest = {section.data + glyphs::kBytes,
                              section.size - glyphs::kBytes};
  return width <= format::bit_table::kMaxBits &&
         section.data[glyphs::kUnitLog2] <= glyphs::kMaxUnitLog2 &&
         out.take(rest, glyph_count + 1, width);
}

bool Kerning::open(Span<const uint8_t> section) noexcept {
  namespace kerning = format::kerning;
  if (section.size < kerning::kBytes) {
    return false;
  }
  const uint8_t* at = section.data;
  glyph_bits = at[kerning::kGlyphBits];
  left_bits = at[kerning::kLeftBits];
  right_bits = at[kerning::kRightBits];
  value_bits = at[kerning::kValueBits];
  const uint32_t start_bits = at[kerning::kStartBits];
  const uint32_t pair_count = load_u32(at + kerning::kPairs);
  left_classes = load_u16(at + kerning::kLeftClasses);
  right_classes = load_u16(at + kerning::kRightClasses);
  value_base = load_i16(at + kerning::kValueBase);
  const uint8_t widths[] = {glyph_bits, left_bits, right_bits, value_bits};
  if (!widths_fit(widths, 4, kerning::kMaxBits) ||
      start_bits > format::bit_table::kMaxBits ||
      pair_count > kerning::kMaxPairs) {
    return false;
  }
  Span<const uint8_t> rest = {at + kerning::kBytes,
                              section.size - kerning::kBytes};
  const uint32_t member_bits = uint32_t{glyph_bits} + left_bits + right_bits;
  const uint32_t pair_bits = uint32_t{right_bits} + value_bits;
  return members.take(rest, load_u16(at + kerning::kMembers), member_bits) &&
         row_starts.take(rest, uint32_t{left_classes} + 1, start_bits) &&
         pairs.take(rest, pair_count, pair_bits);
}

int32_t Kerning::value(uint32_t left_glyph,
                       uint32_t right_glyph) const noexcept {
  const uint32_t left = members.find(0, members.rows, glyph_bits, left_glyph);
  const uint32_t right = members.find(0, members.rows, glyph_bits, right_glyph);
  if (left == BitTable::kAbsent || right == BitTable::kAbsent) {
    return 0;
  }
  const uint32_t row = members.get(left, glyph_bits, left_bits);
  const uint32_t column =
      members.get(right, uint32_t{glyph_bits} + left_bits, right_bits);
  if (row == 0 || row > left_classes || column == 0) {
    return 0;
  }
  const uint32_t begin = row_starts.get(row - 1, 0, row_starts.row_bits);
  const uint32_t end = row_starts.get(row, 0, row_starts.row_bits);
  const uint32_t pair = pairs.find(begin, end < pairs.rows ? end : pairs.rows,
                                   right_bits, column);
  if (pair == BitTable::kAbsent) {
    return 0;
  }
  const uint32_t above_base = pairs.get(pair, right_bits, value_bits);
  return static_cast<int16_t>(static_cast<uint16_t>(value_base) + above_base);
}

}  // namespace detail
}  // namespace inkcell
