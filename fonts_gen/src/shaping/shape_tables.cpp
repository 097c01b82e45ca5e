#include "shaping/shape_tables.hpp"

#include <fribidi.h>
#include <hb-ot.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "base/bit_table_writer.hpp"
#include "base/error.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace shaping = format::shaping;

// Bits that are written later than what they are counted for.
class Bits {
 public:
  void put(uint32_t value, unsigned width) {
    parts_.emplace_back(value, width);
    size_ += width;
  }
  void put_i16(int value) { put(static_cast<uint16_t>(value), 16); }
  void append(const Bits& other) {
    parts_.insert(parts_.end(), other.parts_.begin(), other.parts_.end());
    size_ += other.size_;
  }
  uint32_t size() const { return size_; }
  void write(BitTableWriter& out) const {
    for (const auto& [value, width] : parts_) {
      out.put(value, width);
    }
  }
  bool operator<(const Bits& other) const { return parts_ < other.parts_; }

 private:
  std::vector<std::pair<uint32_t, unsigned>> parts_;
  uint32_t size_ = 0;
};

// Numbers with a base and as few bits as hold the rest.
struct Column {
  int least = 0;
  unsigned bits = 0;

  explicit Column(const std::vector<int>& values) {
    if (!values.empty()) {
      const auto [low, high] =
          std::minmax_element(values.begin(), values.end());
      least = *low;
      bits = width_of(static_cast<uint32_t>(*high - *low));
    }
  }
  void put(int value, Bits& out) const {
    out.put(static_cast<uint32_t>(value - least), bits);
  }
};

struct Traits {
  unsigned joining = 0;
  unsigned rank = 0;
  unsigned mark = 0;

  auto key() const { return std::tie(joining, rank, mark); }
  bool operator<(const Traits& other) const { return key() < other.key(); }
  bool is_plain() const { return joining + rank + mark == 0; }
};

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

class SectionWriter {
 public:
  explicit SectionWriter(const ShapeSource& source)
      : source_(source),
        gsub_(source.file, HB_OT_TAG_GSUB, source.glyphs),
        gpos_(source.file, HB_OT_TAG_GPOS, source.glyphs),
        classes_(read_classes(source.file, source.glyphs, source.characters)),
        glyph_bits_(width_of(static_cast<uint32_t>(source.glyph_count - 1))) {}

  Bytes write();

 private:
  using Key = std::pair<bool, unsigned>;  // GPOS, number in the file

  struct Entry {
    unsigned lookup = 0;
    unsigned mask = 0;
    bool manual_zwj = false;
  };
  struct Program {
    const ShapePlan* plan;
    size_t first = 0;
    size_t substitutions = 0;
    size_t positions = 0;
  };

  unsigned number_of(const Key& key, unsigned depth);
  unsigned set_of(const GlyphIds& ids);
  void add_programs();
  void add_nested();
  void find_compositions();
  void find_spans();
  Traits traits_of(char32_t c) const;
  struct ScriptRange {
    char32_t first;
    char32_t last;
    unsigned program;
  };
  std::vector<ScriptRange> find_scripts() const;
  std::vector<std::pair<char32_t, char32_t>> find_mirrors() const;
  void find_sets();
  uint32_t put_data(const LayoutLookup& lookup, bool is_gpos, Bits& out);
  uint32_t put_single(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_multiple(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_ligatures(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_rules(const LayoutLookup& lookup, bool is_gpos, Bits& out);
  uint32_t put_reverse(const LayoutLookup& lookup, Bits& out);
  uint32_t put_adjustments(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_pairs(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_cursive(const LayoutLookup& lookup, Bits& out) const;
  uint32_t put_anchors(const LayoutLookup& lookup, Bits& out) const;
  unsigned filter_of(const LayoutLookup& lookup);
  void find_rows();
  void put_set(const GlyphIds& ids, Bits& out) const;
  void check(size_t count, size_t most, const char* what) const;

  const ShapeSource& source_;
  LayoutTable gsub_;
  LayoutTable gpos_;
  GlyphClasses classes_;
  unsigned glyph_bits_;

  std::map<Key, unsigned> numbers_;
  std::vector<Key> keys_;
  std::vector<LayoutLookup> lookups_;
  size_t top_ = 0;
  std::vector<Entry> entries_;
  std::vector<Program> programs_;
  std::map<GlyphIds, unsigned> set_numbers_;
  std::vector<GlyphIds> sets_;
  struct Composition {
    unsigned mark;
    char32_t letter;
    char32_t composed;
  };
  std::vector<Composition> compositions_;
  std::vector<char32_t> marks_;
  unsigned rank_bits_ = 0;
  unsigned mark_bits_ = 0;
  unsigned letter_bits_ = 0;
  std::map<unsigned, unsigned> ranks_;
  struct Span {
    char32_t first;
    std::vector<unsigned> properties;
  };
  std::vector<Span> spans_;
  std::vector<Traits> properties_;
  std::vector<unsigned> glyph_rows_;
  std::vector<std::vector<bool>> rows_;
  unsigned set_bits_ = 0;
  unsigned lookup_bits_ = 0;
};

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

Traits SectionWriter::traits_of(char32_t c) const {
  Traits traits;
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
  std::map<Traits, unsigned> numbers = {{Traits(), 0}};
  properties_.push_back(Traits());
  constexpr char32_t kGap = 12;  // a span costs more than so many characters
  for (const char32_t c : all) {
    const Traits traits = traits_of(c);
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

uint32_t SectionWriter::put_single(const LayoutLookup& lookup,
                                   Bits& out) const {
  for (const auto& [from, to] : lookup.replaced) {
    out.put(from, glyph_bits_);
    out.put(to.front(), glyph_bits_);
  }
  return static_cast<uint32_t>(lookup.replaced.size());
}

uint32_t SectionWriter::put_multiple(const LayoutLookup& lookup,
                                     Bits& out) const {
  uint32_t total = 0;
  for (const auto& [from, to] : lookup.replaced) {
    total += static_cast<uint32_t>(to.size());
  }
  const unsigned bits = width_of(total);
  out.put(bits, 5);
  uint32_t start = 0;
  for (const auto& [from, to] : lookup.replaced) {
    out.put(from, glyph_bits_);
    out.put(start, bits);
    start += static_cast<uint32_t>(to.size());
  }
  out.put(0, glyph_bits_);
  out.put(start, bits);
  for (const auto& [from, to] : lookup.replaced) {
    for (const uint16_t glyph : to) {
      out.put(glyph, glyph_bits_);
    }
  }
  return static_cast<uint32_t>(lookup.replaced.size());
}

// A tree in rows by depth. What stands behind a shorter ligature of the file is
// never reached, and left out.
uint32_t SectionWriter::put_ligatures(const LayoutLookup& lookup,
                                      Bits& out) const {
  struct Node {
    uint16_t ligature = 0;
    std::map<uint16_t, Node> next;
  };
  std::map<uint16_t, Node> roots;
  for (const auto& [first, ligatures] : lookup.ligatures) {
    for (const LayoutLookup::Ligature& ligature : ligatures) {
      Node* node = &roots[first];
      bool is_reached = true;
      for (const uint16_t glyph : ligature.rest) {
        is_reached = is_reached && node->ligature == 0;
        node = &node->next[glyph];
      }
      if (is_reached && node->ligature == 0) {
        node->ligature = ligature.glyph;
      }
    }
  }
  std::vector<std::pair<uint16_t, const Node*>> order;
  const auto add = [&order](const std::map<uint16_t, Node>& nodes) {
    for (const auto& [glyph, node] : nodes) {
      order.emplace_back(glyph, &node);
    }
  };
  add(roots);
  std::vector<size_t> children;
  for (size_t i = 0; i < order.size(); ++i) {
    children.push_back(order.size());
    add(order[i].second->next);
  }
  const unsigned bits = width_of(static_cast<uint32_t>(order.size()));
  out.put(bits, 5);
  for (size_t i = 0; i < order.size(); ++i) {
    out.put(order[i].first, glyph_bits_);
    out.put(order[i].second->ligature, glyph_bits_);
    out.put(static_cast<uint32_t>(children[i]), bits);
  }
  out.put(0, 2 * glyph_bits_);
  out.put(static_cast<uint32_t>(order.size()), bits);
  return static_cast<uint32_t>(roots.size());
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

uint32_t SectionWriter::put_rules(const LayoutLookup& lookup,
                                  bool is_gpos,
                                  Bits& out) {
  for (const LayoutRule& rule : lookup.rules) {
    for (const size_t length : {rule.before.size(), rule.input.size() - 1,
                                rule.behind.size(), rule.actions.size()}) {
      out.put(static_cast<uint32_t>(length), shaping::kRuleBits);
    }
    out.put(set_of(rule.input.front()), set_bits_);
    const auto put_sets = [&](const std::vector<GlyphIds>& sets, size_t from) {
      for (size_t i = from; i < sets.size(); ++i) {
        out.put(set_of(sets[i]), set_bits_);
      }
    };
    put_sets(rule.before, 0);
    put_sets(rule.input, 1);
    put_sets(rule.behind, 0);
    for (const auto& [place, number] : rule.actions) {
      out.put(place, shaping::kRuleBits);
      out.put(numbers_.at(Key(is_gpos, number)), lookup_bits_);
    }
  }
  return static_cast<uint32_t>(lookup.rules.size());
}

uint32_t SectionWriter::put_reverse(const LayoutLookup& lookup, Bits& out) {
  for (const LayoutRule& rule : lookup.rules) {
    out.put(static_cast<uint32_t>(rule.before.size()), shaping::kRuleBits);
    out.put(static_cast<uint32_t>(rule.behind.size()), shaping::kRuleBits);
    out.put(static_cast<uint32_t>(rule.pairs.size()), 16);
    for (const auto* sets : {&rule.before, &rule.behind}) {
      for (const GlyphIds& ids : *sets) {
        out.put(set_of(ids), set_bits_);
      }
    }
    for (const auto& [from, to] : rule.pairs) {
      out.put(from, glyph_bits_);
      out.put(to, glyph_bits_);
    }
  }
  return static_cast<uint32_t>(lookup.rules.size());
}

uint32_t SectionWriter::put_adjustments(const LayoutLookup& lookup,
                                        Bits& out) const {
  std::vector<Column> columns;
  for (size_t i = 0; i < 3; ++i) {
    std::vector<int> values;
    for (const auto& [glyph, value] : lookup.adjusted) {
      values.push_back(value[i]);
    }
    columns.emplace_back(values);
    out.put_i16(columns[i].least);
    out.put(columns[i].bits, 5);
  }
  for (const auto& [glyph, value] : lookup.adjusted) {
    out.put(glyph, glyph_bits_);
    for (size_t i = 0; i < 3; ++i) {
      columns[i].put(value[i], out);
    }
  }
  return static_cast<uint32_t>(lookup.adjusted.size());
}

// As section KERN: classes of glyphs that kern alike.
uint32_t SectionWriter::put_pairs(const LayoutLookup& lookup, Bits& out) const {
  using Row = std::map<uint16_t, int>;
  std::map<uint16_t, Row> rows;
  std::map<uint16_t, Row> columns;
  std::vector<int> values;
  bool moves_both = false;
  bool moves_one = false;
  for (const auto& [pair, value] : lookup.kerned) {
    const auto& [x, advance] = value;
    if (x == 0 && advance == 0) {
      continue;
    }
    if (x != 0 && x != advance) {
      source_.file.refuse(
          "moves a glyph of a pair otherwise than its advance, which --shape "
          "cannot do; choose another face");
    }
    moves_both = moves_both || x != 0;
    moves_one = moves_one || x == 0;
    rows[pair.first][pair.second] = advance;
    values.push_back(advance);
  }
  if (moves_both && moves_one) {
    source_.file.refuse(
        "moves some glyphs of pairs and not others, which --shape cannot do; "
        "choose another face");
  }
  std::map<Row, unsigned> left_numbers;
  std::map<uint16_t, unsigned> lefts;
  std::vector<const Row*> classes;
  for (const auto& [glyph, row] : rows) {
    const auto [found, is_new] = left_numbers.emplace(
        row, static_cast<unsigned>(left_numbers.size() + 1));
    if (is_new) {
      classes.push_back(&found->first);
    }
    lefts[glyph] = found->second;
  }
  for (size_t i = 0; i < classes.size(); ++i) {
    for (const auto& [right, value] : *classes[i]) {
      columns[right][static_cast<uint16_t>(i)] = value;
    }
  }
  std::map<Row, unsigned> right_numbers;
  std::map<uint16_t, unsigned> rights;
  for (const auto& [glyph, column] : columns) {
    rights[glyph] =
        right_numbers
            .emplace(column, static_cast<unsigned>(right_numbers.size() + 1))
            .first->second;
  }
  std::vector<std::map<unsigned, int>> pairs;
  uint32_t total = 0;
  for (const Row* row : classes) {
    std::map<unsigned, int> of_classes;
    for (const auto& [right, value] : *row) {
      of_classes[rights[right]] = value;
    }
    total += static_cast<uint32_t>(of_classes.size());
    pairs.push_back(of_classes);
  }
  const Column value(values);
  const unsigned left_bits = width_of(static_cast<uint32_t>(classes.size()));
  const unsigned right_bits =
      width_of(static_cast<uint32_t>(right_numbers.size()));
  const unsigned start_bits = width_of(total);
  GlyphIds members;
  for (const auto& [glyph, number] : lefts) {
    members.insert(glyph);
  }
  for (const auto& [glyph, number] : rights) {
    members.insert(glyph);
  }
  out.put_i16(value.least);
  out.put(value.bits, 5);
  out.put(moves_both ? 1 : 0, 1);
  out.put(left_bits, 5);
  out.put(right_bits, 5);
  out.put(start_bits, 5);
  out.put(static_cast<uint32_t>(classes.size()), 16);
  const auto class_of = [](const std::map<uint16_t, unsigned>& numbers,
                           uint16_t glyph) {
    const auto found = numbers.find(glyph);
    return found == numbers.end() ? 0u : found->second;
  };
  for (const uint16_t glyph : members) {
    out.put(glyph, glyph_bits_);
    out.put(class_of(lefts, glyph), left_bits);
    out.put(class_of(rights, glyph), right_bits);
  }
  uint32_t start = 0;
  for (const auto& row : pairs) {
    out.put(start, start_bits);
    start += static_cast<uint32_t>(row.size());
  }
  out.put(start, start_bits);
  for (const auto& row : pairs) {
    for (const auto& [right, amount] : row) {
      out.put(right, right_bits);
      value.put(amount, out);
    }
  }
  return static_cast<uint32_t>(members.size());
}

uint32_t SectionWriter::put_cursive(const LayoutLookup& lookup,
                                    Bits& out) const {
  std::vector<int> xs;
  std::vector<int> ys;
  for (const auto& [glyph, ends] : lookup.cursive) {
    for (const auto& place : {ends.first, ends.second}) {
      if (place) {
        xs.push_back(place->x);
        ys.push_back(place->y);
      }
    }
  }
  const Column x(xs);
  const Column y(ys);
  out.put_i16(x.least);
  out.put_i16(y.least);
  out.put(x.bits, 5);
  out.put(y.bits, 5);
  out.put(lookup.flags & 1, 1);
  for (const auto& [glyph, ends] : lookup.cursive) {
    out.put(glyph, glyph_bits_);
    out.put(ends.first ? 1 : 0, 1);
    out.put(ends.second ? 1 : 0, 1);
    for (const auto& place : {ends.first, ends.second}) {
      x.put(place ? place->x : x.least, out);
      y.put(place ? place->y : y.least, out);
    }
  }
  return static_cast<uint32_t>(lookup.cursive.size());
}

// Anchors of marks, rows of anchors of bases, and a pool of such rows, each
// once. Kinds of marks of several subtables get numbers of their own.
uint32_t SectionWriter::put_anchors(const LayoutLookup& lookup,
                                    Bits& out) const {
  using Row = std::vector<std::tuple<unsigned, int, int>>;
  std::vector<std::tuple<uint16_t, unsigned, LayoutAnchor>> marks;
  std::map<uint16_t, std::vector<Row>> bases;
  std::vector<int> xs;
  std::vector<int> ys;
  unsigned first_kind = 0;
  const auto add = [&](const LayoutAnchor& place) {
    xs.push_back(place.x);
    ys.push_back(place.y);
  };
  for (const LayoutAnchors& subtable : lookup.anchors) {
    unsigned kinds = 0;
    for (const auto& [glyph, mark] : subtable.marks) {
      marks.emplace_back(glyph, first_kind + mark.kind, mark.anchor);
      kinds = std::max(kinds, mark.kind + 1);
      add(mark.anchor);
    }
    for (const auto& [glyph, rows] : subtable.bases) {
      std::vector<Row>& own = bases[glyph];
      own.resize(std::max(own.size(), rows.size()));
      for (size_t i = 0; i < rows.size(); ++i) {
        for (const auto& [kind, place] : rows[i]) {
          if (kind < kinds) {
            own[i].emplace_back(first_kind + kind, place.x, place.y);
            add(place);
          }
        }
      }
    }
    first_kind += kinds;
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const auto& a, const auto& b) {
                     return std::get<0>(a) < std::get<0>(b);
                   });
  std::map<Row, uint32_t> starts;
  Row pool;
  uint32_t rows = 0;
  uint32_t longest = 0;
  for (const auto& [glyph, own] : bases) {
    for (const Row& row : own) {
      if (starts.emplace(row, static_cast<uint32_t>(pool.size())).second) {
        pool.insert(pool.end(), row.begin(), row.end());
      }
      longest = std::max(longest, static_cast<uint32_t>(row.size()));
      ++rows;
    }
  }
  check(rows, 65535, "anchors of letters");
  const Column x(xs);
  const Column y(ys);
  const unsigned kind_bits = width_of(std::max(first_kind, 1u) - 1);
  const unsigned pool_bits = width_of(static_cast<uint32_t>(pool.size()));
  const unsigned count_bits = width_of(longest);
  out.put_i16(x.least);
  out.put_i16(y.least);
  for (const unsigned width :
       {x.bits, y.bits, kind_bits, pool_bits, count_bits}) {
    out.put(width, 5);
  }
  out.put(rows, 16);
  const auto put_anchor = [&](unsigned kind, int at_x, int at_y) {
    out.put(kind, kind_bits);
    x.put(at_x, out);
    y.put(at_y, out);
  };
  for (const auto& [glyph, kind, place] : marks) {
    out.put(glyph, glyph_bits_);
    put_anchor(kind, place.x, place.y);
  }
  for (const auto& [glyph, own] : bases) {
    for (const Row& row : own) {
      out.put(glyph, glyph_bits_);
      out.put(starts.at(row), pool_bits);
      out.put(static_cast<uint32_t>(row.size()), count_bits);
    }
  }
  for (const auto& [kind, at_x, at_y] : pool) {
    put_anchor(kind, at_x, at_y);
  }
  return static_cast<uint32_t>(marks.size());
}

uint32_t SectionWriter::put_data(const LayoutLookup& lookup,
                                 bool is_gpos,
                                 Bits& out) {
  switch (lookup.type) {
    case shaping::kSingle:
      return put_single(lookup, out);
    case shaping::kMultiple:
      return put_multiple(lookup, out);
    case shaping::kLigatures:
      return put_ligatures(lookup, out);
    case shaping::kContext:
    case shaping::kPositionContext:
      return put_rules(lookup, is_gpos, out);
    case shaping::kReverse:
      return put_reverse(lookup, out);
    case shaping::kAdjust:
      return put_adjustments(lookup, out);
    case shaping::kPairs:
      return put_pairs(lookup, out);
    case shaping::kCursive:
      return put_cursive(lookup, out);
    case shaping::kMarkToBase:
    case shaping::kMarkToLigature:
    case shaping::kMarkToMark:
      return put_anchors(lookup, out);
    default:
      return 0;  // a lookup of another lookup that has no glyph
  }
}

// A list of glyphs, or a bit for each of a span, whichever is shorter.
void SectionWriter::put_set(const GlyphIds& ids, Bits& out) const {
  const size_t span = ids.empty() ? 1u : *ids.rbegin() - *ids.begin() + 1u;
  const bool is_list =
      ids.empty() || ids.size() * glyph_bits_ < span + glyph_bits_;
  out.put(is_list ? 1 : 0, 1);
  if (is_list) {
    out.put(static_cast<uint32_t>(ids.size()), glyph_bits_);
    for (const uint16_t glyph : ids) {
      out.put(glyph, glyph_bits_);
    }
    return;
  }
  out.put(*ids.begin(), glyph_bits_);
  out.put(static_cast<uint32_t>(span - 1), glyph_bits_);
  for (unsigned glyph = *ids.begin(); glyph <= *ids.rbegin(); ++glyph) {
    out.put(static_cast<uint32_t>(ids.count(static_cast<uint16_t>(glyph))), 1);
  }
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
  Bits data;
  std::vector<uint32_t> counts;
  std::vector<uint32_t> begins;
  std::map<std::pair<unsigned, Bits>, uint32_t> written;
  const auto append = [&](unsigned type, const Bits& bits) {
    const auto [found, is_new] =
        written.emplace(std::pair(type, bits), data.size());
    if (is_new) {
      data.append(bits);
    }
    return found->second;
  };
  std::vector<uint32_t> set_begins;
  for (const GlyphIds& ids : sets_) {
    Bits bits;
    put_set(ids, bits);
    set_begins.push_back(append(0, bits));
  }
  for (size_t i = 0; i < lookups_.size(); ++i) {
    Bits bits;
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
  Bits bits;
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
  for (const Traits& traits : properties_) {
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

}  // namespace

Bytes shape_section(const ShapeSource& source) {
  return SectionWriter(source).write();
}

void set_shape_steps(Bytes& section, unsigned steps) {
  set_u16(section, shaping::kSteps, steps);
}

}  // namespace inkcell::gen
