#include "tables.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {

// A table: how many rows it has, and how wide they are.
struct TableKind {
  uint8_t count;      // the number that says so
  uint8_t bits;       // of a row, and those that numbers say
  uint8_t widths[3];  // which; 0: none
};

constexpr uint8_t in_header(uint32_t number) noexcept {
  return static_cast<uint8_t>(number_of(number));
}

// In their order.
constexpr TableKind kTableKinds[] = {
    {in_header(shap::kScripts), shap::kScriptRow, {}},
    {in_header(shap::kPrograms), shap::kProgramRow, {}},
    {in_header(shap::kEntries),
     shap::kMaskBits + 1,
     {in_header(shap::kLookupBits)}},
    {in_header(shap::kSpans), shap::kSpanRow, {}},
    {in_header(shap::kCharacters), 0, {in_header(shap::kPropertyBits)}},
    {in_header(shap::kProperties),
     shap::kJoiningBits,
     {in_header(shap::kRankBits), in_header(shap::kMarkBits)}},
    {in_header(shap::kMarks), 16, {}},
    {in_header(shap::kCompositions),
     0,
     {in_header(shap::kMarkBits), in_header(shap::kLetterBits),
      in_header(shap::kLetterBits)}},
    {in_header(shap::kMirrors), 32, {}},
    {in_header(shap::kLookups),
     shap::kTypeBits + shap::kSkipBits + 16,
     {in_header(shap::kSetBits), in_header(shap::kOffsetBits)}},
    {in_header(shap::kSets), 0, {in_header(shap::kOffsetBits)}},
    {in_header(shap::kGlyphs), 0, {in_header(shap::kRowBits)}},
    {in_header(shap::kRows), shap::kClassBits, {in_header(shap::kTopLookups)}}};
static_assert(sizeof kTableKinds / sizeof kTableKinds[0] == kDataTable);

}  // namespace

bool ShapeTables::open(Span<const uint8_t> section) noexcept {
  if (section.size < shap::kHeaderBits / 8 + 1 || section.size >= 1u << 28) {
    return false;
  }
  bytes = section;
  uint32_t bit = 0;
  uint32_t width = 16;
  for (uint16_t& number : numbers) {
    if (bit == 8 * shap::kPrograms) {
      width = 8;
    } else if (bit == 8 * shap::kWidths) {
      width = shap::kWidthBits;
    }
    number = static_cast<uint16_t>(read_bits(section, bit, width));
    bit += width;
  }
  if (numbers[number_of(shap::kRows)] > shap::kMaxRows) {
    return false;
  }
  // Every row is below 2^8 bits but those of glyphs, 2^17 bits, which are at
  // most 2^8; every count is below 2^16: no sum passes 32 bits.
  uint32_t* begin = begins;
  uint16_t* row = row_bits;
  for (const TableKind& kind : kTableKinds) {
    uint32_t bits = kind.bits;
    for (const uint8_t number : kind.widths) {
      bits += number == 0 ? 0u : numbers[number];
    }
    *begin++ = bit;
    *row++ = static_cast<uint16_t>(bits);
    bit += numbers[kind.count] * bits;
  }
  *begin = bit;
  return bit <= static_cast<uint32_t>(section.size) * 8;
}

uint32_t ShapeReader::get(uint32_t bit, uint32_t width) const noexcept {
  return read_bits(t_.bytes, bit, width);
}

void ShapeReader::seek(ShapeTable table, uint32_t row) noexcept {
  at_ = t_.begins[table] + row * t_.row_bits[table];
}

uint32_t ShapeReader::take(uint32_t width) noexcept {
  const uint32_t bit = at_;
  at_ = bit + width;
  return get(bit, width);
}

bool ShapeReader::find(uint32_t row_bits,
                       uint32_t count,
                       uint32_t key_bits,
                       uint32_t key) noexcept {
  const uint32_t first = at_;
  uint32_t begin = 0;
  for (uint32_t end = count; begin < end;) {
    const uint32_t middle = begin + (end - begin) / 2;
    if (get(first + middle * row_bits, key_bits) < key) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  at_ = first + begin * row_bits;
  return take(key_bits) == key && begin < count;
}

ShapeProgram ShapeReader::program(uint32_t number) noexcept {
  seek(kProgramTable, number);
  at_ += 4 * 16;
  ShapeProgram program;
  program.flags = take(8);
  program.first = take(16);
  program.substitutions = take(8);
  program.positions = take(8);
  return program;
}

CharacterTraits ShapeReader::traits(uint32_t code_point) noexcept {
  CharacterTraits traits;
  for (uint32_t i = header(shap::kSpans); i-- != 0;) {
    seek(kSpanTable, i);
    const uint32_t place = code_point - take(shap::kCodeBits);
    if (place < take(shap::kCountBits)) {
      seek(kCharacterTable, take(shap::kCountBits) + place);
      seek(kPropertyTable, take(header(shap::kPropertyBits)));
      traits.joining = static_cast<uint8_t>(take(shap::kJoiningBits));
      traits.rank = static_cast<uint8_t>(take(header(shap::kRankBits)));
      traits.mark = static_cast<uint8_t>(take(header(shap::kMarkBits)));
      break;
    }
  }
  return traits;
}

uint32_t ShapeReader::mirrored(uint32_t code_point) noexcept {
  seek(kMirrorTable, 0);
  return find(32, header(shap::kMirrors), 16, code_point) ? take(16)
                                                          : code_point;
}

uint32_t ShapeReader::composed(uint32_t letter, uint32_t mark) noexcept {
  const uint32_t mark_bits = header(shap::kMarkBits);
  const uint32_t letter_bits = header(shap::kLetterBits);
  seek(kCompositionTable, 0);
  return letter >> letter_bits == 0 &&
                 find(mark_bits + 2 * letter_bits, header(shap::kCompositions),
                      mark_bits + letter_bits, mark | letter << mark_bits)
             ? take(letter_bits)
             : 0;
}

bool ShapeReader::decompose(uint32_t composed,
                            uint32_t& letter,
                            uint32_t& mark) noexcept {
  const uint32_t letter_bits = header(shap::kLetterBits);
  for (uint32_t i = 0; i < header(shap::kCompositions); ++i) {
    seek(kCompositionTable, i);
    mark = take(header(shap::kMarkBits));
    letter = take(letter_bits);
    if (take(letter_bits) == composed) {
      return true;
    }
  }
  return false;
}

// A set is a list of glyphs, or a bit for each of a span.
bool ShapeReader::in_set(uint32_t set, uint32_t glyph) noexcept {
  const uint32_t width = glyph_bits();
  seek(kSetTable, set);
  at_ = t_.begins[kDataTable] + take(header(shap::kOffsetBits));
  const bool is_list = take(1) != 0;
  const uint32_t first = take(width);
  if (is_list) {
    return find(width, first, width, glyph);
  }
  const uint32_t place = glyph - first;
  return place <= take(width) && has_bit(at_ + place);
}

}  // namespace inkcell::detail
