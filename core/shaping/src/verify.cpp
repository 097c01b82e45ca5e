// Over 400 lines: one reader, with a function for each table.
#include "inkcell/shaping/verify.hpp"

#include "tables.hpp"

namespace inkcell {
namespace {

namespace shap = format::shaping;

class ShapeVerifier : detail::ShapeReader {
 public:
  ShapeVerifier(const detail::ShapeTables& tables,
                uint32_t glyph_count) noexcept
      : ShapeReader(tables),
        end_(static_cast<uint32_t>(tables.bytes.size) * 8),
        glyph_count_(glyph_count),
        sets_(header(shap::kSets)),
        lookups_(header(shap::kLookups)),
        width_(glyph_bits()),
        set_bits_(header(shap::kSetBits)),
        lookup_bits_(header(shap::kLookupBits)),
        offset_bits_(header(shap::kOffsetBits)) {}

  // Not inline, for its stack.
  __attribute__((noinline)) bool is_whole() const noexcept {
    return are_widths() && are_programs() && are_characters() &&
           are_compositions() && are_glyphs() && are_sets() && are_lookups();
  }

 private:
  struct Row {
    uint32_t bits;     // of a row, which begins with a glyph
    bool is_repeated;  // whether rows may follow of the same glyph
  };

  bool fits(uint32_t bit, uint32_t count, uint32_t row_bits) const noexcept {
    return bit <= end_ && (row_bits == 0 || count <= (end_ - bit) / row_bits);
  }

  uint32_t row(detail::ShapeTable table, uint32_t i) const noexcept {
    return t_.begins[table] + i * t_.row_bits[table];
  }
  uint32_t data() const noexcept { return t_.begins[detail::kDataTable]; }
  uint32_t take(uint32_t& bit, uint32_t width) const noexcept {
    bit += width;
    return get(bit - width, width);
  }

  bool are_widths() const noexcept;
  bool are_programs() const noexcept;
  bool are_characters() const noexcept;
  bool are_compositions() const noexcept;
  bool are_glyphs() const noexcept;
  bool are_sets() const noexcept;
  bool is_set(uint32_t bit) const noexcept;
  bool are_lookups() const noexcept;
  bool is_lookup(uint32_t type, uint32_t bit, uint32_t count) const noexcept;
  bool do_ascend(uint32_t bit, uint32_t count, Row row) const noexcept;
  bool do_exist(uint32_t bit, uint32_t count, uint32_t row) const noexcept;
  bool are_sequences(uint32_t bit, uint32_t count) const noexcept;
  bool are_ligatures(uint32_t bit, uint32_t count) const noexcept;
  bool are_rules(uint32_t bit, uint32_t count) const noexcept;
  bool are_adjustments(uint32_t bit, uint32_t count) const noexcept;
  bool are_pairs(uint32_t bit, uint32_t count) const noexcept;
  bool are_anchors(uint32_t bit, uint32_t count, uint32_t more) const noexcept;
  bool name_sets(uint32_t& bit, uint32_t count) const noexcept;

  uint32_t end_;
  uint32_t glyph_count_;
  uint32_t sets_;
  uint32_t lookups_;
  uint32_t width_;
  uint32_t set_bits_;
  uint32_t lookup_bits_;
  uint32_t offset_bits_;
};

bool ShapeVerifier::are_widths() const noexcept {
  // Of glyphs, ranks, marks, letters, offsets, properties, lookups, sets, rows.
  static constexpr uint8_t kMost[] = {
      16, 8, 8, 16, format::bit_table::kMaxBits, 8, 16, 16, 8};
  for (uint32_t i = 0; i < sizeof kMost; ++i) {
    if (header(shap::kWidths + i) > kMost[i]) {
      return false;
    }
  }
  return true;
}

bool ShapeVerifier::are_programs() const noexcept {
  const uint32_t programs = header(shap::kPrograms);
  uint32_t next = 0;
  for (uint32_t i = 0; i < header(shap::kScripts); ++i) {
    uint32_t bit = row(detail::kScriptTable, i);
    const uint32_t first = take(bit, shap::kCodeBits);
    const uint32_t extra = take(bit, shap::kCodeBits);
    if (first < next || first + extra > 0x10ffff || get(bit, 8) >= programs) {
      return false;
    }
    next = first + extra + 1;
  }
  const uint32_t entries = header(shap::kEntries);
  for (uint32_t i = 0; i < programs; ++i) {
    uint32_t bit = row(detail::kProgramTable, i) + 4 * 16 + 8;
    const uint32_t first = take(bit, 16);
    if (first + take(bit, 8) + get(bit, 8) > entries) {
      return false;
    }
  }
  for (uint32_t i = 0; i < entries; ++i) {
    uint32_t bit = row(detail::kEntryTable, i);
    const uint32_t lookup = take(bit, lookup_bits_);
    const uint32_t end = get(bit, shap::kMaskBits) != 0
                             ? header(shap::kTopLookups)
                             : shap::kOrderLast + 1;
    if (lookup >= end) {
      return false;
    }
  }
  return header(shap::kTopLookups) <= lookups_ &&
         header(shap::kSteps) <= shap::kMaxSteps;
}

bool ShapeVerifier::are_characters() const noexcept {
  const uint32_t characters = header(shap::kCharacters);
  const uint32_t properties = header(shap::kProperties);
  const uint32_t property_bits = header(shap::kPropertyBits);
  const uint32_t rank_bits = header(shap::kRankBits);
  const uint32_t mark_bits = header(shap::kMarkBits);
  uint32_t next = 0;
  uint32_t start = 0;
  for (uint32_t i = 0; i < header(shap::kSpans); ++i) {
    uint32_t bit = row(detail::kSpanTable, i);
    const uint32_t first = take(bit, shap::kCodeBits);
    const uint32_t count = take(bit, shap::kCountBits);
    if (first < next || count == 0 || first + count > 0x110000 ||
        get(bit, shap::kCountBits) != start) {
      return false;
    }
    next = first + count;
    start += count;
  }
  for (uint32_t i = 0; i < characters; ++i) {
    if (get(row(detail::kCharacterTable, i), property_bits) >= properties) {
      return false;
    }
  }
  for (uint32_t i = 0; i < properties; ++i) {
    const uint32_t before = shap::kJoiningBits + rank_bits;
    if (get(row(detail::kPropertyTable, i) + before, mark_bits) >
        header(shap::kMarks)) {
      return false;
    }
  }
  return start == characters;
}

bool ShapeVerifier::are_compositions() const noexcept {
  const uint32_t mark_bits = header(shap::kMarkBits);
  const uint32_t letter_bits = header(shap::kLetterBits);
  const uint32_t key_bits = mark_bits + letter_bits;
  uint32_t last = 0;
  for (uint32_t i = 0; i < header(shap::kCompositions); ++i) {
    const uint32_t bit = row(detail::kCompositionTable, i);
    const uint32_t key = get(bit, key_bits);
    const uint32_t mark = get(bit, mark_bits);
    if ((i != 0 && key <= last) || mark == 0 || mark > header(shap::kMarks)) {
      return false;
    }
    last = key;
  }
  for (uint32_t i = 1; i < header(shap::kMirrors); ++i) {
    const uint32_t bit = row(detail::kMirrorTable, i);
    if (get(bit, 16) <= get(bit - 32, 16)) {
      return false;
    }
  }
  return key_bits <= format::bit_table::kMaxBits;
}

bool ShapeVerifier::are_glyphs() const noexcept {
  const uint32_t glyphs = header(shap::kGlyphs);
  const uint32_t rows = header(shap::kRows);
  const uint32_t row_bits = header(shap::kRowBits);
  for (uint32_t i = 0; i < glyphs; ++i) {
    if (get(row(detail::kGlyphTable, i), row_bits) >= rows) {
      return false;
    }
  }
  return glyphs <= glyph_count_ && rows != 0;
}

bool ShapeVerifier::do_ascend(uint32_t bit,
                              uint32_t count,
                              Row row) const noexcept {
  if (!fits(bit, count, row.bits)) {
    return false;
  }
  uint32_t last = 0;
  for (uint32_t i = 0; i < count; ++i, bit += row.bits) {
    const uint32_t glyph = get(bit, width_);
    const bool ascends =
        i == 0 || glyph > last || (row.is_repeated && glyph == last);
    if (!ascends || glyph >= glyph_count_) {
      return false;
    }
    last = glyph;
  }
  return true;
}

// Glyphs in any order, in rows that fit.
bool ShapeVerifier::do_exist(uint32_t bit,
                             uint32_t count,
                             uint32_t row) const noexcept {
  for (; count != 0; --count, bit += row) {
    if (get(bit, width_) >= glyph_count_) {
      return false;
    }
  }
  return true;
}

bool ShapeVerifier::are_sets() const noexcept {
  for (uint32_t i = 0; i < sets_; ++i) {
    if (!is_set(data() + get(row(detail::kSetTable, i), offset_bits_))) {
      return false;
    }
  }
  return true;
}

bool ShapeVerifier::is_set(uint32_t bit) const noexcept {
  if (!fits(bit, 1 + width_, 1)) {
    return false;
  }
  const bool is_list = take(bit, 1) != 0;
  const uint32_t first = take(bit, width_);
  if (is_list) {
    return do_ascend(bit, first, {width_, false});
  }
  const uint32_t extra = get(bit, width_);
  return first + extra < glyph_count_ && fits(bit, width_ + extra + 1, 1);
}

bool ShapeVerifier::are_lookups() const noexcept {
  for (uint32_t i = 0; i < lookups_; ++i) {
    uint32_t bit = row(detail::kLookupTable, i);
    const uint32_t type = take(bit, shap::kTypeBits);
    bit += shap::kSkipBits;
    const uint32_t filter = take(bit, set_bits_);
    const uint32_t count = take(bit, 16);
    const uint32_t offset = get(bit, offset_bits_);
    if (filter > sets_ || !is_lookup(type, data() + offset, count)) {
      return false;
    }
  }
  return true;
}

bool ShapeVerifier::is_lookup(uint32_t type,
                              uint32_t bit,
                              uint32_t count) const noexcept {
  if (!fits(bit, 0, 0)) {
    return false;
  }
  switch (type) {
    case 0:
      return count == 0;
    case shap::kSingle:
      return do_ascend(bit, count, {2 * width_, false}) &&
             do_exist(bit + width_, count, 2 * width_);
    case shap::kMultiple:
      return are_sequences(bit, count);
    case shap::kLigatures:
      return are_ligatures(bit, count);
    case shap::kContext:
    case shap::kReverse:
    case shap::kPositionContext:
      return are_rules(bit, count);
    case shap::kAdjust:
      return are_adjustments(bit, count);
    case shap::kPairs:
      return are_pairs(bit, count);
    case shap::kCursive:
      return are_anchors(bit + 16, count, 5);
    case shap::kMarkToBase:
    case shap::kMarkToLigature:
    case shap::kMarkToMark:
      return are_anchors(bit, count, 0);
    default:
      return false;
  }
}

bool ShapeVerifier::are_sequences(uint32_t bit, uint32_t count) const noexcept {
  const uint32_t start_bits = take(bit, 5);
  const uint32_t row_bits = width_ + start_bits;
  if (start_bits > format::bit_table::kMaxBits ||
      !fits(bit, count + 1, row_bits) ||
      !do_ascend(bit, count, {row_bits, false})) {
    return false;
  }
  uint32_t last = 0;
  for (uint32_t i = 0; i <= count; ++i) {
    const uint32_t start = get(bit + i * row_bits + width_, start_bits);
    const bool follows =
        i == 0 ? start == 0 : start >= last && start - last <= shap::kMaxInput;
    if (!follows) {
      return false;
    }
    last = start;
  }
  bit += (count + 1) * row_bits;
  return fits(bit, last, width_) && do_exist(bit, last, width_);
}

// Row by row, the children of each before those of the next.
bool ShapeVerifier::are_ligatures(uint32_t bit, uint32_t count) const noexcept {
  const uint32_t child_bits = take(bit, 5);
  const uint32_t row_bits = 2 * width_ + child_bits;
  if (child_bits > format::bit_table::kMaxBits ||
      !do_ascend(bit, count, {row_bits, false})) {
    return false;
  }
  const auto child_of = [&](uint32_t row) {
    return get(bit + row * row_bits + 2 * width_, child_bits);
  };
  uint32_t child = count;
  for (uint32_t i = 0; fits(bit, i + 1, row_bits); ++i) {
    if (child_of(i) != child) {
      return false;
    }
    if (i == child) {
      return true;
    }
    if (!fits(bit, i + 2, row_bits) ||
        get(bit + i * row_bits + width_, width_) >= glyph_count_) {
      return false;
    }
    const uint32_t end = child_of(i + 1);
    if (end < child ||
        !do_ascend(bit + child * row_bits, end - child, {row_bits, false})) {
      return false;
    }
    child = end;
  }
  return false;
}

bool ShapeVerifier::name_sets(uint32_t& bit, uint32_t count) const noexcept {
  for (; count != 0; --count) {
    if (take(bit, set_bits_) >= sets_) {
      return false;
    }
  }
  return true;
}

bool ShapeVerifier::are_rules(uint32_t bit, uint32_t count) const noexcept {
  for (; count != 0; --count) {
    if (!fits(bit, 4 * shap::kRuleBits, 1)) {
      return false;
    }
    const uint32_t before = take(bit, shap::kRuleBits);
    const uint32_t input = take(bit, shap::kRuleBits);
    const uint32_t behind = take(bit, shap::kRuleBits);
    uint32_t actions = take(bit, shap::kRuleBits);
    const uint32_t sets = 1 + before + input + behind;
    if (!fits(bit,
              sets * set_bits_ + actions * (shap::kRuleBits + lookup_bits_),
              1) ||
        !name_sets(bit, sets)) {
      return false;
    }
    for (; actions != 0; --actions) {
      bit += shap::kRuleBits;
      if (take(bit, lookup_bits_) >= lookups_) {
        return false;
      }
    }
  }
  return true;
}

bool ShapeVerifier::are_adjustments(uint32_t bit,
                                    uint32_t count) const noexcept {
  uint32_t row_bits = width_;
  bit += 3 * 16;
  for (uint32_t i = 0; i < 3; ++i) {
    const uint32_t bits = take(bit, 5);
    if (bits > 16) {
      return false;
    }
    row_bits += bits;
  }
  return do_ascend(bit, count, {row_bits, false});
}

bool ShapeVerifier::are_pairs(uint32_t bit, uint32_t count) const noexcept {
  bit += 16;
  const uint32_t left_bits = take(bit, 5);
  const uint32_t right_bits = take(bit, 5);
  const uint32_t start_bits = take(bit, 5);
  const uint32_t value_bits = take(bit, 5);
  bit += 5;
  const uint32_t left_count = take(bit, 16);
  const uint32_t row_bits = width_ + left_bits + right_bits;
  if (value_bits > 16 || left_bits > 16 || right_bits > 16 ||
      start_bits > format::bit_table::kMaxBits ||
      !do_ascend(bit, count, {row_bits, false})) {
    return false;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (get(bit + i * row_bits + width_, left_bits) > left_count) {
      return false;
    }
  }
  const uint32_t starts = bit + count * row_bits;
  if (!fits(starts, left_count + 1, start_bits)) {
    return false;
  }
  const uint32_t pairs = starts + (left_count + 1) * start_bits;
  const uint32_t pair_bits = right_bits + value_bits;
  uint32_t begin = get(starts, start_bits);
  if (begin != 0) {
    return false;
  }
  for (uint32_t left = 1; left <= left_count; ++left) {
    const uint32_t end = get(starts + left * start_bits, start_bits);
    if (end < begin || !fits(pairs, end, pair_bits)) {
      return false;
    }
    uint32_t last = 0;
    for (; begin < end; ++begin) {
      const uint32_t right = get(pairs + begin * pair_bits, right_bits);
      if (right <= last) {
        return false;
      }
      last = right;
    }
  }
  return true;
}

// `more` bits are between the widths and the numbers.
bool ShapeVerifier::are_anchors(uint32_t bit,
                                uint32_t count,
                                uint32_t more) const noexcept {
  const uint32_t level_bits = take(bit, 5);
  const uint32_t x_bits = take(bit, 5);
  const uint32_t kind_bits = take(bit, 5);
  const uint32_t y_bits = take(bit, 5);
  const uint32_t pool_bits = take(bit, 5);
  const uint32_t count_bits = take(bit, 5);
  bit += more;
  const uint32_t levels = take(bit, 16);
  const uint32_t bases = take(bit, 16);
  const uint32_t mark_bits = width_ + level_bits + x_bits;
  const uint32_t base_bits = width_ + pool_bits + count_bits;
  if (x_bits > 16 || level_bits > 16 || count_bits > 16 ||
      pool_bits > format::bit_table::kMaxBits ||
      kind_bits + y_bits > format::bit_table::kMaxBits ||
      !do_ascend(bit, count, {mark_bits, true})) {
    return false;
  }
  // The levels that `number` anchors name, in rows.
  const auto name_levels = [&](uint32_t at, uint32_t number,
                               uint32_t row_bits) {
    for (uint32_t i = 0; i < number; ++i) {
      if (get(at + i * row_bits, level_bits) >= levels) {
        return false;
      }
    }
    return true;
  };
  const uint32_t marks = bit + width_;
  bit += count * mark_bits;
  if (!do_ascend(bit, bases, {base_bits, true})) {
    return false;
  }
  uint32_t end = 0;
  for (uint32_t i = 0; i < bases; ++i, bit += base_bits) {
    const uint32_t last = get(bit + width_, pool_bits) +
                          get(bit + width_ + pool_bits, count_bits);
    end = last > end ? last : end;
  }
  if (!fits(bit, levels, kind_bits + y_bits)) {
    return false;
  }
  bit += levels * (kind_bits + y_bits);
  return fits(bit, end, level_bits + x_bits) &&
         name_levels(marks, count, mark_bits) &&
         name_levels(bit, end, level_bits + x_bits);
}

}  // namespace

Status verify_shaping(const Font& font) noexcept {
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  detail::ShapeTables tables;
  if (section.data == nullptr) {
    return Status::ok;
  }
  return tables.open(section) &&
                 ShapeVerifier(tables, font.glyph_count()).is_whole()
             ? Status::ok
             : Status::corrupt;
}

}  // namespace inkcell
