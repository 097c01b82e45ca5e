// The data of lookups.
#include <algorithm>

#include "base/error.hpp"
#include "shaping/section_writer.hpp"

namespace inkcell::gen {
namespace {

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
  void put(int value, SectionBits& out) const {
    out.put(static_cast<uint32_t>(value - least), bits);
  }
};

}  // namespace

uint32_t SectionWriter::put_single(const LayoutLookup& lookup,
                                   SectionBits& out) const {
  for (const auto& [from, to] : lookup.replaced) {
    out.put(from, glyph_bits_);
    out.put(to.front(), glyph_bits_);
  }
  return static_cast<uint32_t>(lookup.replaced.size());
}

uint32_t SectionWriter::put_multiple(const LayoutLookup& lookup,
                                     SectionBits& out) const {
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
                                      SectionBits& out) const {
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

uint32_t SectionWriter::put_rules(const LayoutLookup& lookup,
                                  bool is_gpos,
                                  SectionBits& out) {
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

uint32_t SectionWriter::put_reverse(const LayoutLookup& lookup,
                                    SectionBits& out) {
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
                                        SectionBits& out) const {
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
uint32_t SectionWriter::put_pairs(const LayoutLookup& lookup,
                                  SectionBits& out) const {
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
                                    SectionBits& out) const {
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
                                    SectionBits& out) const {
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
                                 SectionBits& out) {
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
void SectionWriter::put_set(const GlyphIds& ids, SectionBits& out) const {
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

}  // namespace inkcell::gen
