#include "shaping/shape_tables.hpp"

#include <algorithm>
#include <functional>

#include "base/error.hpp"
#include "shaping/section_writer.hpp"

namespace inkcell::gen {

void SectionWriter::check(size_t count, size_t most, const char* what) const {
  if (count > most) {
    source_.file.refuse("--shape needs " + std::to_string(count) + " " + what +
                        ", a font holds " + std::to_string(most) +
                        "; ask for fewer characters or scripts");
  }
}

LayoutLookup SectionWriter::read_lookup(const Key& key) const {
  LayoutLookup lookup;
  if (key != Key(false, kSequences)) {
    lookup = (key.first ? gpos_ : gsub_).lookup(key.second);
    drop_skipped(lookup);
    return lookup;
  }
  lookup.type = shaping::kLigatures;
  // Those that begin with others come before them.
  for (auto one = source_.sequences.rbegin(); one != source_.sequences.rend();
       ++one) {
    const auto& [glyphs, drawing] = *one;
    lookup.ligatures[glyphs.front()].push_back(
        {{glyphs.begin() + 1, glyphs.end()}, drawing});
  }
  return lookup;
}

// Whether a lookup looks over a glyph.
bool SectionWriter::is_skipped(const LayoutLookup& lookup,
                               uint16_t glyph) const {
  const auto found = classes_.kinds.find(glyph);
  const unsigned kind = found == classes_.kinds.end() ? 0 : found->second;
  if (kind == 0 || (lookup.flags >> kind & 1) != 0) {
    return kind != 0;
  }
  if (kind != 3) {
    return false;
  }
  if ((lookup.flags & kUseSet) != 0) {
    return lookup.mark_set >= classes_.mark_sets.size() ||
           classes_.mark_sets[lookup.mark_set].count(glyph) == 0;
  }
  const auto of_glyph = classes_.mark_classes.find(glyph);
  return lookup.flags >> 8 != 0 && (of_glyph == classes_.mark_classes.end() ||
                                    of_glyph->second != lookup.flags >> 8);
}

// Takes away what the lookup would look over where it begins, so that devices
// need not look, and says for marks what they look over to find their bases.
void SectionWriter::drop_skipped(LayoutLookup& lookup) const {
  const auto drop = [&](auto& map, auto glyph_of) {
    for (auto one = map.begin(); one != map.end();) {
      one =
          is_skipped(lookup, glyph_of(*one)) ? map.erase(one) : std::next(one);
    }
  };
  const auto first = [](const auto& entry) { return entry.first; };
  drop(lookup.replaced, first);
  drop(lookup.ligatures, first);
  drop(lookup.adjusted, first);
  drop(lookup.kerned, [](const auto& entry) { return entry.first.first; });
  for (LayoutRule& rule : lookup.rules) {
    drop(rule.input.front(), [](uint16_t glyph) { return glyph; });
  }
  for (LayoutAnchors& subtable : lookup.anchors) {
    drop(subtable.marks, first);
    if (subtable.bases.empty()) {
      subtable.marks.clear();
    }
  }
  if (lookup.type == shaping::kMarkToBase ||
      lookup.type == shaping::kMarkToLigature) {
    lookup.flags = 1u << shaping::kMarkClass;
  } else if (lookup.type == shaping::kMarkToMark) {
    lookup.flags &= ~0xeu;
  }
}

unsigned SectionWriter::number_of(const Key& key, unsigned depth) {
  check(depth, shaping::kMaxDepth, "lookups within each other");
  const auto [found, is_new] =
      numbers_.emplace(key, static_cast<unsigned>(keys_.size()));
  if (is_new) {
    keys_.push_back(key);
    lookups_.push_back(read_lookup(key));
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
    const bool is_emoji_plan = (plan.flags & shaping::kEmoji) != 0;
    const auto concerns = [&](const LayoutLookup& lookup) {
      const GlyphIds ids = lookup.covered();
      return is_emoji_plan
                 ? std::any_of(ids.begin(), ids.end(),
                               [&](uint16_t id) { return emoji_.count(id); })
                 : !ids.empty();
    };
    const auto add = [&](const std::vector<ShapeEntry>& entries, bool is_gpos) {
      size_t count = 0;
      for (const ShapeEntry& entry : entries) {
        if (entry.mask == 0) {
          entries_.push_back({entry.lookup, 0, false});
          ++count;
          continue;
        }
        const Key key(is_gpos, entry.lookup);
        if (!concerns(read_lookup(key))) {
          continue;
        }
        entries_.push_back({number_of(key, 0), entry.mask, entry.manual_zwj});
        ++count;
      }
      return count;
    };
    program.substitutions = add(plan.substitutions, false);
    if (is_emoji_plan && !source_.sequences.empty()) {
      program.substitutions +=
          add({{kSequences, shaping::kAnyForm, false}}, false);
    }
    program.positions = add(plan.positions, true);
    programs_.push_back(program);
  }
  top_ = keys_.size();
}

// Of a reverse lookup: each rule names one that replaces its glyph.
void SectionWriter::add_reverse(unsigned number) {
  for (size_t i = 0; i < lookups_[number].rules.size(); ++i) {
    LayoutRule& rule = lookups_[number].rules[i];
    LayoutLookup single;
    single.type = shaping::kSingle;
    for (const auto& [from, to] : rule.pairs) {
      single.replaced[from] = {to};
    }
    const Key key(false, kFirstOwn + static_cast<unsigned>(keys_.size()));
    rule.actions = {{0, key.second}};
    numbers_.emplace(key, static_cast<unsigned>(keys_.size()));
    keys_.push_back(key);
    lookups_.push_back(single);
  }
}

// Lookups that rules alone name.
void SectionWriter::add_nested() {
  std::function<void(unsigned, unsigned)> visit = [&](unsigned number,
                                                      unsigned depth) {
    if (lookups_[number].type == shaping::kReverse) {
      return add_reverse(number);
    }
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

unsigned SectionWriter::filter_of(const LayoutLookup& lookup) {
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

// Whether a lookup has other results where spaces are near.
bool SectionWriter::looks_at_space() const {
  const auto found = source_.characters.find(U' ');
  if (found == source_.characters.end() || source_.kerns_space) {
    return source_.kerns_space;
  }
  const uint16_t space = found->second;
  const auto has = [&](const GlyphIds& ids) { return ids.count(space) != 0; };
  return std::any_of(sets_.begin(), sets_.end(), has) ||
         std::any_of(lookups_.begin(), lookups_.end(), [&](const auto& lookup) {
           bool is_found = false;
           for (const auto& [pair, value] : lookup.kerned) {
             is_found |= (pair.first == space || pair.second == space) &&
                         value != std::pair(0, 0);
           }
           LayoutLookup others = lookup;
           others.kerned.clear();
           is_found |= has(others.covered());
           for (const auto& [first, ligatures] : lookup.ligatures) {
             for (const LayoutLookup::Ligature& one : ligatures) {
               is_found |=
                   std::count(one.rest.begin(), one.rest.end(), space) != 0;
             }
           }
           for (const LayoutAnchors& anchors : lookup.anchors) {
             is_found |= anchors.bases.count(space) != 0;
           }
           return is_found;
         });
}

Bytes SectionWriter::write() {
  add_programs();
  add_nested();
  find_compositions();
  if (keys_.empty() && compositions_.empty()) {
    return {};
  }
  find_spans();
  find_sets();
  find_rows();
  check(keys_.size(), 65535, "lookups");
  check(entries_.size(), 65535, "lookups of programs");
  check(compositions_.size(), 65535, "composed letters");
  const std::vector<ScriptRange> scripts = find_scripts();
  if (scripts.empty()) {
    return {};
  }
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
  SectionBits bits;
  for (const unsigned width :
       {glyph_bits_, rank_bits_, mark_bits_, letter_bits_, offset_bits,
        property_bits, lookup_bits_, set_bits_, row_bits}) {
    bits.put(width, shaping::kWidthBits);
  }
  for (const ScriptRange& range : scripts) {
    bits.put(range.first, shaping::kCodeBits);
    bits.put(range.last - range.first, shaping::kCodeBits);
    bits.put(range.program, 8);
  }
  const uint32_t free_space = looks_at_space() ? 0 : shaping::kSpaceIsFree;
  for (const Program& program : programs_) {
    const auto put_tag = [&](const std::string& tag) {
      for (size_t i = 0; i < 4; ++i) {
        bits.put(tag.empty() ? 0 : static_cast<uint8_t>(tag[i]), 8);
      }
    };
    put_tag(program.plan->script);
    put_tag(program.plan->language);
    bits.put(program.plan->flags | free_space, 8);
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

Bytes composing_section(ShapeSource source) {
  ShapePlan marks;
  marks.script = "DFLT";
  marks.hb_script = HB_SCRIPT_INHERITED;
  source.plans = {marks};
  source.glyph_count = 1;
  return SectionWriter(source).write();
}

void set_shape_steps(Bytes& section, unsigned steps) {
  set_u16(section, shaping::kSteps, steps);
}

}  // namespace inkcell::gen
