// Rules of contexts.
#include <algorithm>
#include <iterator>

#include "inkcell/format/rom.hpp"
#include "shaping/layout_table.hpp"

namespace inkcell::gen {

void LayoutTable::read_actions(At at, unsigned count, LayoutRule& rule) const {
  for (unsigned i = 0; i < count; ++i) {
    rule.actions.emplace_back(u16(at + 4 * At{i}), u16(at + 4 * At{i} + 2));
  }
}

// Rules that nothing can match are left out.
void LayoutTable::add_rule(LayoutRule rule, LayoutLookup& out) const {
  for (const auto* sets : {&rule.before, &rule.input, &rule.behind}) {
    if (std::any_of(sets->begin(), sets->end(),
                    [](const GlyphIds& ids) { return ids.empty(); })) {
      return;
    }
  }
  if (rule.before.size() > format::shaping::kMaxInput ||
      rule.input.size() > format::shaping::kMaxInput + 1 ||
      rule.behind.size() > format::shaping::kMaxInput ||
      rule.actions.size() > format::shaping::kMaxInput) {
    refuse("looks at more than 15 glyphs");
  }
  out.rules.push_back(std::move(rule));
}

void LayoutTable::read_context(At at,
                               bool is_chained,
                               LayoutLookup& out) const {
  if (u16(at) != 3) {
    return read_rule_sets(at, is_chained, out);
  }
  LayoutRule rule;
  At next = at + 2;
  const auto read_sets = [&](unsigned count, std::vector<GlyphIds>& sets) {
    for (unsigned i = 0; i < count; ++i, next += 2) {
      sets.push_back(covered_ids(offset(at, next)));
    }
  };
  const auto take = [&] {
    next += 2;
    return u16(next - 2);
  };
  if (is_chained) {
    read_sets(take(), rule.before);
    read_sets(take(), rule.input);
    read_sets(take(), rule.behind);
    const unsigned count = take();
    read_actions(next, count, rule);
  } else {
    const unsigned inputs = take();
    const unsigned count = take();
    read_sets(inputs, rule.input);
    read_actions(next, count, rule);
  }
  if (!rule.input.empty()) {
    add_rule(std::move(rule), out);
  }
}

// Rules by glyphs (format 1) or by classes of glyphs (format 2).
void LayoutTable::read_rule_sets(At at,
                                 bool is_chained,
                                 LayoutLookup& out) const {
  const bool is_by_class = u16(at) == 2;
  if (u16(at) != 1 && !is_by_class) {
    return;
  }
  const GlyphIds covered = covered_ids(offset(at, at + 2));
  const std::vector<uint32_t> firsts = coverage(offset(at, at + 2));
  std::array<std::map<uint32_t, unsigned>, 3> kinds;  // before, input, behind
  At next = at + 4;
  for (size_t part = 0; is_by_class && part < 3; ++part) {
    if (is_chained || part == 1) {
      kinds[part] = classes(offset(at, next));
      next += 2;
    }
  }
  const auto set_of = [&](size_t part, unsigned value) {
    if (is_by_class) {
      return class_ids(kinds[part], value);
    }
    const auto own = id(value);
    return own ? GlyphIds{*own} : GlyphIds();
  };
  const unsigned count = u16(next);
  for (unsigned i = 0; i < count; ++i) {
    const At set = offset(at, next + 2 + 2 * At{i});
    GlyphIds first;
    if (is_by_class) {
      const GlyphIds all = class_ids(kinds[1], i);
      std::set_intersection(all.begin(), all.end(), covered.begin(),
                            covered.end(), std::inserter(first, first.end()));
    } else if (i < firsts.size()) {
      first = set_of(1, firsts[i]);
    }
    for (unsigned k = 0; set != 0 && !first.empty() && k < u16(set); ++k) {
      At entry = offset(set, set + 2 + 2 * At{k});
      LayoutRule rule;
      rule.input.push_back(first);
      const auto take = [&] {
        entry += 2;
        return u16(entry - 2);
      };
      const auto read_part = [&](size_t part, unsigned length,
                                 std::vector<GlyphIds>& sets) {
        for (unsigned n = 0; n < length; ++n) {
          sets.push_back(set_of(part, take()));
        }
      };
      if (is_chained) {
        read_part(0, take(), rule.before);
        read_part(1, std::max(take(), 1u) - 1, rule.input);
        read_part(2, take(), rule.behind);
        const unsigned actions = take();
        read_actions(entry, actions, rule);
      } else {
        const unsigned inputs = std::max(take(), 1u);
        const unsigned actions = take();
        read_part(1, inputs - 1, rule.input);
        read_actions(entry, actions, rule);
      }
      add_rule(std::move(rule), out);
    }
  }
}

void LayoutTable::read_reverse(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  LayoutRule rule;
  GlyphIds first;
  At next = at + 4;
  for (std::vector<GlyphIds>* sets : {&rule.before, &rule.behind}) {
    const unsigned count = u16(next);
    next += 2;
    for (unsigned i = 0; i < count; ++i, next += 2) {
      sets->push_back(covered_ids(offset(at, next)));
    }
  }
  for (size_t i = 0; i < from.size() && i < u16(next); ++i) {
    const auto own = id(from[i]);
    const auto to = id(u16(next + 2 + 2 * i));
    if (own && to) {
      rule.pairs.emplace(*own, *to);
      first.insert(*own);
    }
  }
  if (!first.empty()) {
    rule.input = {first};
    add_rule(std::move(rule), out);
  }
}

}  // namespace inkcell::gen
