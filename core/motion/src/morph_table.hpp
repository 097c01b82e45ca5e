// The table of section MORP (docs/FORMAT.md).
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace inkcell::motion {

// The pairs of a font. Safe on any bytes: what lies outside is 0.
class MorphTable {
 public:
  explicit MorphTable(const Font& font) noexcept
      : section_(font.section(format::section::kMorphs)) {
    if (section_.size < format::morphs::kBytes) {
      return;
    }
    glyph_bits_ = section_.data[format::morphs::kGlyphBits];
    offset_bits_ = section_.data[format::morphs::kOffsetBits];
    row_bits_ = 2 * glyph_bits_ + offset_bits_;
    const uint32_t count =
        detail::load_u16(section_.data + format::morphs::kPairs);
    if (glyph_bits_ <= format::morphs::kMaxGlyphBits &&
        detail::bits_fit(section_, format::morphs::kBytes, count * row_bits_)) {
      count_ = count;
    }
  }

  // Empty: there is none.
  Span<const uint8_t> find(uint32_t first, uint32_t second) const noexcept {
    const uint32_t end = rows_up_to(first, second);
    return end != 0 && first_of(end - 1) == first &&
                   second_of(end - 1) == second
               ? record(end - 1)
               : Span<const uint8_t>();
  }

  // The second master of a glyph; the glyph itself: there is none.
  uint16_t master_of(uint16_t glyph) const noexcept {
    const uint32_t end = rows_up_to(glyph, 0xffff);
    if (end == 0 || first_of(end - 1) != glyph) {
      return glyph;
    }
    // Masters have the highest ids, so they are the last partners.
    const uint32_t masters =
        detail::load_u16(section_.data + format::morphs::kMasters);
    const uint32_t last = second_of(end - 1);
    return masters == 0 || last < masters ? glyph : static_cast<uint16_t>(last);
  }

 private:
  // How many rows are at or before a pair.
  uint32_t rows_up_to(uint32_t first, uint32_t second) const noexcept {
    uint32_t begin = 0;
    uint32_t end = count_;
    while (begin < end) {
      const uint32_t middle = (begin + end) / 2;
      const uint32_t a = first_of(middle);
      if (a < first || (a == first && second_of(middle) <= second)) {
        begin = middle + 1;
      } else {
        end = middle;
      }
    }
    return begin;
  }

  uint32_t first_of(uint32_t row) const noexcept {
    return number(row, 0, glyph_bits_);
  }
  uint32_t second_of(uint32_t row) const noexcept {
    return number(row, glyph_bits_, glyph_bits_);
  }
  uint32_t number(uint32_t row, uint32_t bit, uint32_t width) const noexcept {
    return detail::read_bits(
        section_, 8 * format::morphs::kBytes + row * row_bits_ + bit, width);
  }
  // From the end of the table. [bytes]
  uint32_t offset(uint32_t row) const noexcept {
    return number(row, 2 * glyph_bits_, offset_bits_);
  }
  Span<const uint8_t> record(uint32_t row) const noexcept {
    const uint32_t table =
        format::morphs::kBytes + (count_ * row_bits_ + 7) / 8;
    const auto size = static_cast<uint32_t>(section_.size) - table;
    const uint32_t begin = offset(row);
    const uint32_t end = row + 1 == count_ ? size : offset(row + 1);
    if (begin >= end || end > size) {
      return {};
    }
    return {section_.data + table + begin, end - begin};
  }

  Span<const uint8_t> section_;
  uint32_t count_ = 0;
  uint32_t glyph_bits_ = 0;
  uint32_t offset_bits_ = 0;
  uint32_t row_bits_ = 0;
};

}  // namespace inkcell::motion
