// Reads the tables of section SHAP.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/shaping.hpp"

namespace inkcell::detail {

/// A table of programs.
struct ShapeProgram {
  uint32_t flags = 0;
  uint32_t first = 0;
  uint32_t substitutions = 0;
  uint32_t positions = 0;

  bool has(uint32_t flag) const noexcept { return (flags & flag) != 0; }
};

/// What a property row says of a character.
struct CharacterTraits {
  uint8_t joining = 0;
  uint8_t rank = 0;
  uint8_t mark = 0;
};

/// Reads numbers of SHAP. Safe with any bytes: what is not there is 0.
class ShapeReader {
 public:
  explicit ShapeReader(const ShapeTables& tables) noexcept : t_(tables) {}

  uint32_t get(uint32_t bit, uint32_t width) const noexcept {
    return read_bits(t_.bytes, bit, width);
  }
  uint32_t take(uint32_t& bit, uint32_t width) const noexcept {
    const uint32_t value = get(bit, width);
    bit += width;
    return value;
  }
  int32_t take_signed(uint32_t& bit) const noexcept {
    return static_cast<int16_t>(take(bit, 16));
  }
  /// A number of the header.
  uint32_t u8(uint32_t at) const noexcept { return get(8 * at, 8); }
  /// A width that is safe to shift by, even if it changed since it was checked.
  uint32_t bits_of(uint32_t at) const noexcept { return u8(at) & 31; }
  uint32_t u16(uint32_t at) const noexcept { return get(8 * at, 16); }
  uint32_t glyph_bits() const noexcept {
    return bits_of(format::shaping::kGlyphBits);
  }

  ShapeProgram program(uint32_t number) const noexcept;
  CharacterTraits traits(uint32_t code_point) const noexcept;
  uint32_t mirrored(uint32_t code_point) const noexcept;
  /// The letter with the mark of this number; 0: there is none.
  uint32_t composed(uint32_t letter, uint32_t mark) const noexcept;
  /// What a letter is composed of; false: of nothing.
  bool decompose(uint32_t composed,
                 uint32_t& letter,
                 uint32_t& mark) const noexcept;
  bool in_set(uint32_t set, uint32_t glyph) const noexcept;
  uint32_t row_of(uint32_t glyph) const noexcept;
  uint32_t row_bit(uint32_t row) const noexcept;

  const ShapeTables& t_;
};

}  // namespace inkcell::detail
