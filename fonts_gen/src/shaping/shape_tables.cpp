#include "shaping/shape_tables.hpp"

#include <fribidi.h>
#include <hb-ot.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "base/error.hpp"
#include "shaping/section_writer.hpp"

namespace inkcell::gen {
namespace {

hb_unicode_funcs_t* unicode() {
  return hb_unicode_funcs_get_default();
}

bool is_any_mark(char32_t c) {
  const auto category = hb_unicode_general_category(unicode(), c);
  return category == HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK;
}

// Arabic marks that belong to the letter, before all others (UTR #53).
bool is_modifier(char32_t c) {
  static const CharSet kModifiers = {0x654, 0x655, 0x658, 0x6dc, 0x6e3,
                                     0x6e7, 0x6e8, 0x8ca, 0x8cb, 0x8cd,
                                     0x8ce, 0x8cf, 0x8d3, 0x8f3};
  return kModifiers.count(c) != 0;
}

// The order of marks: classes of Unicode, changed as HarfBuzz does where those
// do not order what is drawn.
unsigned order_of(char32_t c) {
  const unsigned kind =
      static_cast<unsigned>(hb_unicode_combining_class(unicode(), c));
  static const std::map<unsigned, unsigned> kChanged = {
      {10, 22}, {11, 15}, {12, 16},   {13, 17},   {14, 23},  {15, 18},
      {16, 19}, {17, 20}, {18, 21},   {19, 14},   {20, 24},  {21, 12},
      {22, 25}, {23, 13}, {24, 10},   {25, 11},   {27, 28},  {28, 29},
      {29, 30}, {30, 31}, {31, 32},   {32, 33},   {33, 27},  {84, 0},
      {91, 0},  {103, 3}, {129, 129}, {130, 132}, {132, 131}};
  if (is_modifier(c)) {
    return kind == 220 ? 1 : 2;
  }
  const auto found = kChanged.find(kind);
  return found == kChanged.end() ? kind : found->second;
}

unsigned hebrew_mark(char32_t c) {
  switch (hb_unicode_combining_class(unicode(), c)) {
    case HB_UNICODE_COMBINING_CLASS_CCC17:
    case HB_UNICODE_COMBINING_CLASS_CCC18:
      return shaping::kWideMark;
    case HB_UNICODE_COMBINING_CLASS_CCC10:
    case HB_UNICODE_COMBINING_CLASS_CCC14:
      return shaping::kNarrowMark;
    case HB_UNICODE_COMBINING_CLASS_CCC22:
    case HB_UNICODE_COMBINING_CLASS_BELOW:
      return shaping::kLowMark;
    default:
      return shaping::kMark;
  }
}

unsigned joining_of(char32_t c) {
  if (c == 0x200c) {
    return shaping::kJoinsNone;
  }
  if (c == 0x200d) {
    return shaping::kJoinsDual;
  }
  const FriBidiJoiningType type = fribidi_get_joining_type(c);
  if (FRIBIDI_IS_JOINING_TYPE_R(type)) {
    return shaping::kJoinsRight;
  }
  if (FRIBIDI_IS_JOINING_TYPE_D(type) || FRIBIDI_IS_JOINING_TYPE_C(type)) {
    return shaping::kJoinsDual;
  }
  if (FRIBIDI_IS_JOINING_TYPE_L(type)) {
    return shaping::kJoinsLeft;
  }
  const auto category = hb_unicode_general_category(unicode(), c);
  return is_any_mark(c) || category == HB_UNICODE_GENERAL_CATEGORY_FORMAT
             ? shaping::kMark
             : shaping::kJoinsNone;
}

}  // namespace

void SectionWriter::check(size_t count, size_t most, const char* what) const {
  if (count > most) {
    source_.file.refuse("--shape needs " + std::to_string(count) + " " + what +
                        ", a font holds " + std::to_string(most) +
                        "; ask for fewer characters or scripts");
  }
}

unsigned SectionWriter::number_of(const Key& key, unsigned depth) {
  check(depth, shaping::kMaxDepth, "lookups within each other");
  const auto [found, is_new] =
      numbers_.emplace(key, static_cast<unsigned>(keys_.size()));
  if (is_new) {
    keys_.push_back(key);
    lookups_.push_back((key.first ? gpos_ : gsub_).lookup(key.second));
  }
  return found->second;
}

unsigned SectionWriter::set_of(const GlyphIds& ids) {
  const auto [found, is_new] =
      set_numbers_.emplace(ids, static_cast<unsigned>(sets_.size()));
  if (is_new) {
    sets_.push_back(ids);
  }
  return found->second;
}

void SectionWriter::add_programs() {
  for (const ShapePlan& plan : source_.plans) {
    Program program = {&plan, entries_.size(), 0, 0};
    const auto add = [&](const std::vector<ShapeEntry>& entries, bool is_gpos) {
      size_t count = 0;
      for (const ShapeEntry& entry : entries) {
        const Key key(is_gpos, entry.lookup);
        if ((is_gpos ? gpos_ : gsub_).lookup(entry.lookup).empty()) {
          continue;
        }
        entries_.push_back({number_of(key, 0), entry.mask, entry.manual_zwj});
        ++count;
      }
      return count;
    };
    program.substitutions = add(plan.substitutions, false);
    program.positions = add(plan.positions, true);
    programs_.push_back(program);
  }
  top_ = keys_.size();
}

// Lookups that rules alone name.
void SectionWriter::add_nested() {
  std::function<void(unsigned, unsigned)> visit = [&](unsigned number,
                                                      unsigned depth) {
    const bool is_gpos = keys_[number].first;
    const std::vector<LayoutRule> rules = lookups_[number].rules;
    for (const LayoutRule& rule : rules) {
      for (const auto& action : rule.actions) {
        visit(number_of(Key(is_gpos, action.second), depth + 1), depth + 1);
      }
    }
  };
  for (unsigned i = 0; i < top_; ++i) {
    visit(i, 0);
  }
}

void SectionWriter::find_compositions() {
  std::map<char32_t, unsigned> numbers;
  for (const auto& [composed, glyph] : source_.characters) {
    hb_codepoint_t letter = 0;
    hb_codepoint_t mark = 0;
    hb_codepoint_t again = 0;
    if (composed > 0xffff ||
        hb_unicode_decompose(unicode(), composed, &letter, &mark) == 0 ||
        mark == 0 || hb_unicode_compose(unicode(), letter, mark, &again) == 0 ||
        again != composed || source_.characters.count(letter) == 0 ||
        source_.characters.count(mark) == 0 || order_of(mark) == 0) {
      continue;
    }
    const auto [found, is_new] =
        numbers.emplace(mark, static_cast<unsigned>(marks_.size() + 1));
    if (is_new) {
      marks_.push_back(mark);
    }
    compositions_.push_back({found->second, letter, composed});
  }
  std::sort(compositions_.begin(), compositions_.end(),
            [](const Composition& a, const Composition& b) {
              return std::tie(a.letter, a.mark) < std::tie(b.letter, b.mark);
            });
  char32_t most = 0;
  for (const Composition& one : compositions_) {
    most = std::max({most, one.letter, one.composed});
  }
  letter_bits_ = width_of(most);
  mark_bits_ = width_of(static_cast<uint32_t>(marks_.size()));
  check(marks_.size(), 127, "marks that compose");
  // Both are looked for as one number.
  check(letter_bits_ + mark_bits_, format::bit_table::kMaxBits,
        "bits of a composition");
}

ShapeTraits SectionWriter::traits_of(char32_t c) const {
  ShapeTraits traits;
  const bool joins = std::any_of(
      programs_.begin(), programs_.end(), [](const Program& program) {
        return (program.plan->flags & shaping::kJoins) != 0;
      });
  if (is_any_mark(c)) {
    traits.joining =
        shaped_script(c) == HB_SCRIPT_HEBREW ? hebrew_mark(c) : shaping::kMark;
    const auto rank = ranks_.find(order_of(c));
    traits.rank = rank == ranks_.end() ? 0 : rank->second;
    const auto mark = std::find(marks_.begin(), marks_.end(), c);
    traits.mark = mark == marks_.end()
                      ? 0
                      : static_cast<unsigned>(mark - marks_.begin() + 1);
  } else if (joins) {
    traits.joining = joining_of(c);
  }
  return traits;
}

// Characters whose traits are not plain: of the font, and all that join or are
// marks in the block of a script, so that letters also join with those that
// the font lacks.
void SectionWriter::find_spans() {
  CharSet all;
  for (const auto& [c, glyph] : source_.characters) {
    all.insert(c);
  }
  for (const Program& program : programs_) {
    if ((program.plan->flags & shaping::kJoins) != 0) {
      for (char32_t c = 0x600; c < 0x700; ++c) {
        all.insert(c);
      }
      all.insert({0x200c, 0x200d});
    }
  }
  std::set<unsigned> orders;
  for (const char32_t c : all) {
    if (is_any_mark(c) && order_of(c) != 0) {
      orders.insert(order_of(c));
    }
  }
  for (const unsigned order : orders) {
    ranks_.emplace(order, static_cast<unsigned>(ranks_.size() + 1));
  }
  rank_bits_ = width_of(static_cast<uint32_t>(ranks_.size()));
  std::map<ShapeTraits, unsigned> numbers = {{ShapeTraits(), 0}};
  properties_.push_back(ShapeTraits());
  constexpr char32_t kGap = 12;  // a span costs more than so many characters
  for (const char32_t c : all) {
    const ShapeTraits traits = traits_of(c);
    if (traits.is_plain()) {
      continue;
    }
    const auto [found, is_new] =
        numbers.emplace(traits, static_cast<unsigned>(properties_.size()));
    if (is_new) {
      properties_.push_back(traits);
    }
    if (spans_.empty() ||
        c - spans_.back().first - spans_.back().properties.size() > kGap) {
      spans_.push_back({c, {}});
    }
    Span& span = spans_.back();
    span.properties.resize(c - span.first, 0);
    span.properties.push_back(found->second);
  }
  check(properties_.size(), 255, "kinds of characters");
  check(spans_.size(), 255, "spans of characters");
}

// Ranges of characters of the font by the first program of their script.
// Marks of all scripts belong to what is before them.
std::vector<SectionWriter::ScriptRange> SectionWriter::find_scripts() const {
  std::vector<ScriptRange> ranges;
  bool is_open = false;
  for (const auto& [c, glyph] : source_.characters) {
    const hb_script_t script = shaped_script(c);
    if (script == HB_SCRIPT_COMMON && is_any_mark(c)) {
      continue;
    }
    const auto found = std::find_if(
        programs_.begin(), programs_.end(),
        [&](const auto& one) { return one.plan->hb_script == script; });
    if (found == programs_.end()) {
      is_open = false;
      continue;
    }
    const auto program = static_cast<unsigned>(found - programs_.begin());
    if (is_open && ranges.back().program == program) {
      ranges.back().last = c;
    } else {
      ranges.push_back({c, c, program});
      is_open = true;
    }
  }
  check(ranges.size(), 255, "ranges of characters");
  return ranges;
}

unsigned SectionWriter::filter_of(const LayoutLookup& lookup) {
  constexpr unsigned kUseSet = 16;
  if ((lookup.flags & kUseSet) != 0) {
    return set_of(lookup.mark_set < classes_.mark_sets.size()
                      ? classes_.mark_sets[lookup.mark_set]
                      : GlyphIds()) +
           1;
  }
  const unsigned kind = lookup.flags >> 8;
  if (kind == 0) {
    return 0;
  }
  GlyphIds ids;
  for (const auto& [glyph, of_glyph] : classes_.mark_classes) {
    if (of_glyph == kind) {
      ids.insert(glyph);
    }
  }
  return set_of(ids) + 1;
}

// All sets that lookups name, so that numbers of sets have a width.
void SectionWriter::find_sets() {
  for (const LayoutLookup& lookup : lookups_) {
    filter_of(lookup);
    for (const LayoutRule& rule : lookup.rules) {
      for (const auto* sets : {&rule.input, &rule.before, &rule.behind}) {
        for (const GlyphIds& ids : *sets) {
          set_of(ids);
        }
      }
    }
  }
  check(sets_.size(), 65535, "sets of glyphs");
  set_bits_ = width_of(static_cast<uint32_t>(sets_.size()));
  lookup_bits_ = width_of(static_cast<uint32_t>(lookups_.size()));
}

// The class of each glyph, and a bit for each lookup of a program that may
// apply to it; equal rows are stored once.
void SectionWriter::find_rows() {
  std::vector<GlyphIds> covered;
  for (size_t i = 0; i < top_; ++i) {
    covered.push_back(lookups_[i].covered());
  }
  std::map<std::vector<bool>, unsigned> numbers;
  const auto add = [&](uint16_t glyph) {
    const auto kind = classes_.kinds.find(glyph);
    const unsigned number = kind == classes_.kinds.end() ? 0 : kind->second;
    std::vector<bool> row = {(number & 1) != 0, (number & 2) != 0};
    for (const GlyphIds& ids : covered) {
      row.push_back(ids.count(glyph) != 0);
    }
    const auto [found, is_new] =
        numbers.emplace(row, static_cast<unsigned>(rows_.size()));
    if (is_new) {
      rows_.push_back(row);
    }
    return found->second;
  };
  for (size_t glyph = 0; glyph < source_.glyph_count; ++glyph) {
    glyph_rows_.push_back(add(static_cast<uint16_t>(glyph)));
  }
  check(rows_.size(), 256, "kinds of glyphs");
}

std::vector<std::pair<char32_t, char32_t>> SectionWriter::find_mirrors() const {
  std::vector<std::pair<char32_t, char32_t>> mirrors;
  const bool is_any = std::any_of(
      programs_.begin(), programs_.end(),
      [](const Program& program) { return program.plan->is_right_to_left; });
  for (const auto& [c, glyph] : source_.characters) {
    const char32_t other = hb_unicode_mirroring(unicode(), c);
    if (is_any && other != c && source_.characters.count(other) != 0 &&
        std::max(c, other) <= 0xffff) {
      mirrors.emplace_back(c, other);
    }
  }
  check(mirrors.size(), 255, "characters with mirror images");
  return mirrors;
}

Bytes SectionWriter::write() {
  add_programs();
  add_nested();
  find_compositions();
  find_spans();
  find_sets();
  find_rows();
  check(keys_.size(), 65535, "lookups");
  check(entries_.size(), 65535, "lookups of programs");
  check(compositions_.size(), 65535, "composed letters");
  const std::vector<ScriptRange> scripts = find_scripts();
  const auto mirrors = find_mirrors();
  SectionBits data;
  std::vector<uint32_t> counts;
  std::vector<uint32_t> begins;
  std::map<std::pair<unsigned, SectionBits>, uint32_t> written;
  const auto append = [&](unsigned type, const SectionBits& bits) {
    const auto [found, is_new] =
        written.emplace(std::pair(type, bits), data.size());
    if (is_new) {
      data.append(bits);
    }
    return found->second;
  };
  std::vector<uint32_t> set_begins;
  for (const GlyphIds& ids : sets_) {
    SectionBits bits;
    put_set(ids, bits);
    set_begins.push_back(append(0, bits));
  }
  for (size_t i = 0; i < lookups_.size(); ++i) {
    SectionBits bits;
    counts.push_back(put_data(lookups_[i], keys_[i].first, bits));
    check(counts.back(), 65535, "rows of a lookup");
    begins.push_back(append(lookups_[i].type, bits));
  }
  const unsigned offset_bits = width_of(data.size());
  check(offset_bits, format::bit_table::kMaxBits, "bits of offsets");
  size_t characters = 0;
  for (const Span& span : spans_) {
    characters += span.properties.size();
  }
  const unsigned property_bits =
      width_of(static_cast<uint32_t>(properties_.size() - 1));
  const unsigned row_bits = width_of(static_cast<uint32_t>(rows_.size() - 1));

  Bytes out;
  for (const size_t count : {lookups_.size(), top_, sets_.size(), rows_.size(),
                             compositions_.size(), characters, entries_.size(),
                             source_.glyph_count, size_t{shaping::kMaxSteps}}) {
    check(count, 65535, "rows of a table");
    put_u16(out, static_cast<unsigned>(count));
  }
  for (const size_t count :
       {programs_.size(), scripts.size(), spans_.size(), properties_.size(),
        marks_.size(), mirrors.size()}) {
    check(count, 255, "rows of a short table");
    put_u8(out, static_cast<unsigned>(count));
  }
  for (const unsigned width :
       {glyph_bits_, rank_bits_, mark_bits_, letter_bits_, offset_bits,
        property_bits, lookup_bits_, set_bits_, row_bits}) {
    put_u8(out, width);
  }
  SectionBits bits;
  for (const ScriptRange& range : scripts) {
    bits.put(range.first, shaping::kCodeBits);
    bits.put(range.last - range.first, shaping::kCodeBits);
    bits.put(range.program, 8);
  }
  for (const Program& program : programs_) {
    const auto put_tag = [&](const std::string& tag) {
      for (size_t i = 0; i < 4; ++i) {
        bits.put(tag.empty() ? 0 : static_cast<uint8_t>(tag[i]), 8);
      }
    };
    put_tag(program.plan->script);
    put_tag(program.plan->language);
    bits.put(program.plan->flags, 8);
    bits.put(static_cast<uint32_t>(program.first), 16);
    check(program.substitutions, 255, "lookups of a program");
    check(program.positions, 255, "lookups of a program");
    bits.put(static_cast<uint32_t>(program.substitutions), 8);
    bits.put(static_cast<uint32_t>(program.positions), 8);
  }
  for (const Entry& entry : entries_) {
    bits.put(entry.lookup, lookup_bits_);
    bits.put(entry.mask, shaping::kMaskBits);
    bits.put(entry.manual_zwj ? 1 : 0, 1);
  }
  uint32_t start = 0;
  for (const Span& span : spans_) {
    bits.put(span.first, shaping::kCodeBits);
    bits.put(static_cast<uint32_t>(span.properties.size()),
             shaping::kCountBits);
    bits.put(start, shaping::kCountBits);
    start += static_cast<uint32_t>(span.properties.size());
  }
  for (const Span& span : spans_) {
    for (const unsigned property : span.properties) {
      bits.put(property, property_bits);
    }
  }
  for (const ShapeTraits& traits : properties_) {
    bits.put(traits.joining, shaping::kJoiningBits);
    bits.put(traits.rank, rank_bits_);
    bits.put(traits.mark, mark_bits_);
  }
  for (const char32_t mark : marks_) {
    bits.put(mark, 16);
  }
  for (const Composition& one : compositions_) {
    bits.put(one.mark, mark_bits_);
    bits.put(one.letter, letter_bits_);
    bits.put(one.composed, letter_bits_);
  }
  for (const auto& [from, to] : mirrors) {
    bits.put(from, 16);
    bits.put(to, 16);
  }
  for (size_t i = 0; i < lookups_.size(); ++i) {
    bits.put(lookups_[i].type, shaping::kTypeBits);
    bits.put(lookups_[i].flags >> 1 & 7, shaping::kSkipBits);
    bits.put(filter_of(lookups_[i]), set_bits_);
    bits.put(counts[i], 16);
    bits.put(begins[i], offset_bits);
  }
  for (const uint32_t begin : set_begins) {
    bits.put(begin, offset_bits);
  }
  for (const unsigned row : glyph_rows_) {
    bits.put(row, row_bits);
  }
  for (const std::vector<bool>& row : rows_) {
    for (const bool bit : row) {
      bits.put(bit ? 1 : 0, 1);
    }
  }
  bits.append(data);
  BitTableWriter table(out);
  bits.write(table);
  return out;
}

Bytes shape_section(const ShapeSource& source) {
  return SectionWriter(source).write();
}

void set_shape_steps(Bytes& section, unsigned steps) {
  set_u16(section, shaping::kSteps, steps);
}

}  // namespace inkcell::gen
