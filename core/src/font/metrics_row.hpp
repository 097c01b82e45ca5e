// Rows of METR: a glyph's advance and box.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "base/bytes.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {

// Takes a row of METR from left to right. Widths are read again, not kept:
// reading bits is safe with any.
class Font::MetricsRow {
 public:
  // `box_bits`: of the columns but for the advance, which is the first glyphs'.
  void set(const Span<const uint8_t>& section,
           uint32_t box_bits,
           uint32_t glyph) noexcept {
    section_ = &section;
    const uint32_t advances =
        detail::load_u16(section.data + format::metrics::kAdvances);
    advance_bits_ = section.data[format::metrics::kColumnBits];
    bit_ = 8 * format::metrics::kBytes + box_bits * glyph;
    if (glyph < advances) {
      bit_ += advance_bits_ * glyph;
    } else {
      bit_ += advance_bits_ * advances;
      advance_bits_ = 0;
    }
  }

  void skip_advance() noexcept { bit_ += advance_bits_; }

  // As take(0), with less stack.
  uint16_t advance() const noexcept {
    return static_cast<uint16_t>(
        detail::load_u16(section_->data + format::metrics::kBase) +
        detail::read_bits(*section_, bit_, advance_bits_));
  }

  // Modulo 2^16.
  uint16_t take(uint32_t column) noexcept {
    const uint32_t bits =
        column == 0 ? advance_bits_
                    : section_->data[format::metrics::kColumnBits + column];
    const uint32_t above_base = detail::read_bits(*section_, bit_, bits);
    bit_ += bits;
    return static_cast<uint16_t>(
        detail::load_u16(section_->data + format::metrics::kBase + 2 * column) +
        above_base);
  }

 private:
  const Span<const uint8_t>* section_;
  uint32_t bit_;
  uint32_t advance_bits_;
};

}  // namespace inkcell
