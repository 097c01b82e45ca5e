#include "tables.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

bool ShapeTables::open(Span<const uint8_t> section) noexcept {
  if (section.size < shap::kBytes || section.size >= 1u << 28) {
    return false;
  }
  bytes = section;
  const ShapeReader reader(*this);
  const uint32_t glyph_bits = reader.u8(shap::kGlyphBits);
  const uint32_t letter_bits = reader.u8(shap::kLetterBits);
  const uint32_t mark_bits = reader.u8(shap::kMarkBits);
  const uint32_t rank_bits = reader.u8(shap::kRankBits);
  const uint32_t offset_bits = reader.u8(shap::kOffsetBits);
  const uint32_t property_bits = reader.u8(shap::kPropertyBits);
  const uint32_t lookup_bits = reader.u8(shap::kLookupBits);
  const uint32_t set_bits = reader.u8(shap::kSetBits);
  const uint32_t row_bits = reader.u8(shap::kRowBits);
  if (glyph_bits > 16 || letter_bits > 16 || mark_bits > 8 || rank_bits > 8 ||
      offset_bits > format::bit_table::kMaxBits || property_bits > 8 ||
      lookup_bits > 16 || set_bits > 16 || row_bits > 8) {
    return false;
  }
  // Every row is below 2^17 bits and every count below 2^16, so a sum can only
  // pass 32 bits after it has passed the section.
  const uint32_t end = static_cast<uint32_t>(section.size) * 8;
  uint32_t bit = 8 * shap::kBytes;
  bool fits = true;
  const auto place = [&](uint32_t& table, uint32_t count, uint32_t row) {
    table = bit;
    fits = fits && (row == 0 || count <= (end - bit) / row);
    bit += fits ? count * row : 0;
  };
  place(scripts, reader.u8(shap::kScripts), shap::kScriptRow);
  place(programs, reader.u8(shap::kPrograms), shap::kProgramRow);
  place(entries, reader.u16(shap::kEntries), lookup_bits + shap::kMaskBits + 1);
  place(spans, reader.u8(shap::kSpans), shap::kSpanRow);
  place(characters, reader.u16(shap::kCharacters), property_bits);
  place(properties, reader.u8(shap::kProperties),
        shap::kJoiningBits + rank_bits + mark_bits);
  place(marks, reader.u8(shap::kMarks), 16);
  place(compositions, reader.u16(shap::kCompositions),
        mark_bits + 2 * letter_bits);
  place(mirrors, reader.u8(shap::kMirrors), 32);
  place(lookups, reader.u16(shap::kLookups),
        shap::kTypeBits + shap::kSkipBits + set_bits + 16 + offset_bits);
  place(sets, reader.u16(shap::kSets), offset_bits);
  place(glyph_rows, reader.u16(shap::kGlyphs), row_bits);
  place(rows, reader.u16(shap::kRows),
        shap::kClassBits + reader.u16(shap::kTopLookups));
  data = bit;
  return fits;
}

ShapeProgram ShapeReader::program(uint32_t number) const noexcept {
  uint32_t bit = t_.programs + number * shap::kProgramRow + 4 * 16;
  ShapeProgram program;
  program.flags = take(bit, 8);
  program.first = take(bit, 16);
  program.substitutions = take(bit, 8);
  program.positions = take(bit, 8);
  return program;
}

CharacterTraits ShapeReader::traits(uint32_t code_point) const noexcept {
  CharacterTraits traits;
  const uint32_t spans = u8(shap::kSpans);
  for (uint32_t i = 0; i < spans; ++i) {
    uint32_t bit = t_.spans + i * shap::kSpanRow;
    const uint32_t place = code_point - take(bit, shap::kCodeBits);
    const uint32_t count = take(bit, shap::kCountBits);
    if (place >= count) {
      continue;
    }
    const uint32_t rank_bits = bits_of(shap::kRankBits);
    const uint32_t mark_bits = bits_of(shap::kMarkBits);
    const uint32_t property_bits = bits_of(shap::kPropertyBits);
    const uint32_t property = get(
        t_.characters + (get(bit, shap::kCountBits) + place) * property_bits,
        property_bits);
    bit =
        t_.properties + property * (shap::kJoiningBits + rank_bits + mark_bits);
    traits.joining = static_cast<uint8_t>(take(bit, shap::kJoiningBits));
    traits.rank = static_cast<uint8_t>(take(bit, rank_bits));
    traits.mark = static_cast<uint8_t>(take(bit, mark_bits));
    break;
  }
  return traits;
}

uint32_t ShapeReader::mirrored(uint32_t code_point) const noexcept {
  const uint32_t count = u8(shap::kMirrors);
  for (uint32_t i = 0; i < count; ++i) {
    if (get(t_.mirrors + 32 * i, 16) == code_point) {
      return get(t_.mirrors + 32 * i + 16, 16);
    }
  }
  return code_point;
}

uint32_t ShapeReader::composed(uint32_t letter, uint32_t mark) const noexcept {
  const uint32_t mark_bits = bits_of(shap::kMarkBits);
  const uint32_t letter_bits = bits_of(shap::kLetterBits);
  const BitTable table = {&t_.bytes, t_.compositions,
                          mark_bits + 2 * letter_bits};
  if (letter >> letter_bits != 0) {
    return 0;
  }
  const uint32_t row =
      table.find(0, u16(shap::kCompositions), mark_bits + letter_bits,
                 mark | letter << mark_bits);
  return row == BitTable::kAbsent
             ? 0
             : table.get(row, mark_bits + letter_bits, letter_bits);
}

bool ShapeReader::decompose(uint32_t composed,
                            uint32_t& letter,
                            uint32_t& mark) const noexcept {
  const uint32_t mark_bits = bits_of(shap::kMarkBits);
  const uint32_t letter_bits = bits_of(shap::kLetterBits);
  const uint32_t count = u16(shap::kCompositions);
  uint32_t bit = t_.compositions;
  for (uint32_t i = 0; i < count; ++i) {
    if (get(bit + mark_bits + letter_bits, letter_bits) == composed) {
      mark = get(bit, mark_bits);
      letter = get(bit + mark_bits, letter_bits);
      return true;
    }
    bit += mark_bits + 2 * letter_bits;
  }
  return false;
}

// A set is a list of glyphs, or a bit for each of a span.
bool ShapeReader::in_set(uint32_t set, uint32_t glyph) const noexcept {
  const uint32_t width = glyph_bits();
  const uint32_t offset_bits = bits_of(shap::kOffsetBits);
  uint32_t bit = t_.data + get(t_.sets + set * offset_bits, offset_bits);
  const bool is_list = take(bit, 1) != 0;
  const uint32_t first = take(bit, width);
  if (is_list) {
    const BitTable list = {&t_.bytes, bit, width};
    return set < u16(shap::kSets) &&
           list.find(0, first, width, glyph) != BitTable::kAbsent;
  }
  const uint32_t extra = take(bit, width);
  return set < u16(shap::kSets) && glyph - first <= extra &&
         get(bit + (glyph - first), 1) != 0;
}

uint32_t ShapeReader::row_of(uint32_t glyph) const noexcept {
  const uint32_t row_bits = bits_of(shap::kRowBits);
  return glyph < u16(shap::kGlyphs)
             ? get(t_.glyph_rows + glyph * row_bits, row_bits)
             : 0;
}

uint32_t ShapeReader::row_bit(uint32_t row) const noexcept {
  return t_.rows + row * (shap::kClassBits + u16(shap::kTopLookups));
}

}  // namespace inkcell::detail
