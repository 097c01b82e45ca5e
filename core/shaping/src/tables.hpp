// Reads the tables of section SHAP.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/shaping.hpp"

namespace inkcell::detail {

/// The place of a number of the header: those of 16 bits come first.
constexpr uint32_t number_of(uint32_t at) noexcept {
  constexpr uint32_t kFirstByte = format::shaping::kPrograms;
  return at < kFirstByte ? at / 2 : at - kFirstByte / 2;
}
static_assert(number_of(format::shaping::kNumbersEnd) == ShapeTables::kNumbers);

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

/// In the order of the section.
enum ShapeTable : uint32_t {
  kScriptTable,
  kProgramTable,
  kEntryTable,
  kSpanTable,
  kCharacterTable,
  kPropertyTable,
  kMarkTable,
  kCompositionTable,
  kMirrorTable,
  kLookupTable,
  kSetTable,
  kGlyphTable,
  kRowTable,
  kDataTable,
};
static_assert(kDataTable + 1 == ShapeTables::kTables);

/// Reads numbers of SHAP, one after the other. Safe with any bytes: what is not
/// there is 0.
class ShapeReader {
 public:
  explicit ShapeReader(const ShapeTables& tables) noexcept : t_(tables) {}

  uint32_t get(uint32_t bit, uint32_t width) const noexcept;
  /// Of one bit, for long searches.
  bool has_bit(uint32_t bit) const noexcept {
    return bit / 8 < t_.bytes.size &&
           (t_.bytes.data[bit / 8] >> bit % 8 & 1) != 0;
  }
  void seek(ShapeTable table, uint32_t row) noexcept;
  uint32_t take(uint32_t width) noexcept;
  int32_t take_signed() noexcept { return static_cast<int16_t>(take(16)); }
  /// Looks for the first of the next `count` rows that begins with `key`; they
  /// ascend by it. True: what follows in the row is next.
  bool find(uint32_t row_bits,
            uint32_t count,
            uint32_t key_bits,
            uint32_t key) noexcept;
  /// A number of the header, as it was when the section was opened.
  uint32_t header(uint32_t at) const noexcept {
    return t_.numbers[number_of(at)];
  }
  uint32_t glyph_bits() const noexcept {
    return header(format::shaping::kGlyphBits);
  }

  ShapeProgram program(uint32_t number) noexcept;
  CharacterTraits traits(uint32_t code_point) noexcept;
  uint32_t mirrored(uint32_t code_point) noexcept;
  /// The letter with the mark of this number; 0: there is none.
  uint32_t composed(uint32_t letter, uint32_t mark) noexcept;
  /// What a letter is composed of; false: of nothing.
  bool decompose(uint32_t composed, uint32_t& letter, uint32_t& mark) noexcept;
  bool in_set(uint32_t set, uint32_t glyph) noexcept;

  const ShapeTables& t_;
  uint32_t at_ = 0;  // [bit]
};

}  // namespace inkcell::detail
