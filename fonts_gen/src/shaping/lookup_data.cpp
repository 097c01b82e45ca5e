// The data of lookups.
#include <algorithm>

#include "base/error.hpp"
#include "shaping/section_writer.hpp"
#include "source/kerning.hpp"

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
  }
  for (const Column& column : columns) {
    out.put(column.bits, 5);
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
  std::vector<size_t> lefts;
  std::vector<std::vector<int16_t>> rows;
  std::vector<int> values;
  bool moves_both = false;
  bool moves_one = false;
  for (const auto& [pair, value] : lookup.kerned) {
    const auto& [x, advance] = value;
    if (x == 0 && advance == 0) {
      continue;
    }
    moves_both = moves_both || x != 0;
    moves_one = moves_one || x != advance;
    if (lefts.empty() || lefts.back() != pair.first) {
      lefts.push_back(pair.first);
      rows.emplace_back(source_.glyph_count);
    }
    rows.back()[pair.second] = static_cast<int16_t>(advance);
    values.push_back(advance);
  }
  if (moves_both && moves_one) {
    source_.file.refuse(
        "moves some glyphs of pairs otherwise than their advances, which "
        "--shape cannot do; choose another face");
  }
  const KerningMatrix classes = join_classes(source_.glyph_count, lefts, rows);
  const auto right_count = static_cast<size_t>(classes.right_classes);
  const Column value(values);
  const unsigned left_bits =
      width_of(static_cast<uint32_t>(classes.left_classes));
  const unsigned right_bits =
      width_of(static_cast<uint32_t>(classes.right_classes));
  const auto pairs = static_cast<uint32_t>(
      classes.values.size() -
      static_cast<size_t>(
          std::count(classes.values.begin(), classes.values.end(), 0)));
  const unsigned start_bits = width_of(pairs);
  out.put_i16(value.least);
  for (const unsigned width :
       {left_bits, right_bits, start_bits, value.bits, moves_both ? 1u : 0u}) {
    out.put(width, 5);
  }
  out.put(static_cast<uint32_t>(classes.left_classes), 16);
  uint32_t members = 0;
  for (size_t i = 0; i < source_.glyph_count; ++i) {
    if (classes.left_class[i] + classes.right_class[i] != 0) {
      out.put(static_cast<uint32_t>(i), glyph_bits_);
      out.put(classes.left_class[i], left_bits);
      out.put(classes.right_class[i], right_bits);
      ++members;
    }
  }
  SectionBits rows_of_pairs;
  uint32_t start = 0;
  for (size_t i = 0; i < classes.values.size(); ++i) {
    if (i % right_count == 0) {
      out.put(start, start_bits);
    }
    if (classes.values[i] != 0) {
      rows_of_pairs.put(static_cast<uint32_t>(i % right_count + 1), right_bits);
      value.put(classes.values[i], rows_of_pairs);
      ++start;
    }
  }
  out.put(start, start_bits);
  out.append(rows_of_pairs);
  return members;
}

// Anchors of marks, rows of anchors of bases, and a pool of such rows, each
// once. Kinds of marks of several subtables get numbers of their own, and an
// anchor names a level: a kind and a height. Glyphs of cursive scripts have the
// only kind: their entries stand on exits.
uint32_t SectionWriter::put_anchors(const LayoutLookup& lookup,
                                    SectionBits& out) const {
  using Level = std::pair<unsigned, int>;
  using Row = std::vector<std::pair<Level, int>>;
  std::vector<std::tuple<uint16_t, Level, int>> marks;
  std::map<uint16_t, std::vector<Row>> bases;
  std::vector<int> xs;
  std::vector<int> ys;
  std::map<Level, uint32_t> levels;
  unsigned first_kind = 0;
  const auto level_of = [&](unsigned kind, const LayoutAnchor& place) {
    xs.push_back(place.x);
    ys.push_back(place.y);
    return levels.emplace(Level(first_kind + kind, place.y), 0).first->first;
  };
  for (const LayoutAnchors& subtable : lookup.anchors) {
    unsigned kinds = 0;
    for (const auto& [glyph, mark] : subtable.marks) {
      marks.emplace_back(glyph, level_of(mark.kind, mark.anchor),
                         mark.anchor.x);
      kinds = std::max(kinds, mark.kind + 1);
    }
    for (const auto& [glyph, rows] : subtable.bases) {
      std::vector<Row>& own = bases[glyph];
      own.resize(std::max(own.size(), rows.size()));
      for (size_t i = 0; i < rows.size(); ++i) {
        for (const auto& [kind, place] : rows[i]) {
          if (kind < kinds) {
            own[i].emplace_back(level_of(kind, place), place.x);
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
  check(levels.size(), 65535, "heights of anchors");
  uint32_t number = 0;
  for (auto& [level, own] : levels) {
    own = number++;
  }
  const Column x(xs);
  const Column y(ys);
  const unsigned level_bits =
      width_of(std::max(static_cast<uint32_t>(levels.size()), 1u) - 1);
  const unsigned kind_bits = width_of(std::max(first_kind, 1u) - 1);
  const unsigned pool_bits = width_of(static_cast<uint32_t>(pool.size()));
  const unsigned count_bits = width_of(longest);
  // Both are read as one number.
  check(kind_bits + y.bits, format::bit_table::kMaxBits, "bits of a height");
  if (lookup.type == shaping::kCursive) {
    out.put_i16(x.least);
  }
  for (const unsigned width :
       {level_bits, x.bits, kind_bits, y.bits, pool_bits, count_bits}) {
    out.put(width, 5);
  }
  if (lookup.type == shaping::kCursive) {
    out.put(lookup.flags & 1, 5);
  }
  out.put(static_cast<uint32_t>(levels.size()), 16);
  out.put(rows, 16);
  for (const auto& [glyph, level, at_x] : marks) {
    out.put(glyph, glyph_bits_);
    out.put(levels.at(level), level_bits);
    x.put(at_x, out);
  }
  for (const auto& [glyph, own] : bases) {
    for (const Row& row : own) {
      out.put(glyph, glyph_bits_);
      out.put(starts.at(row), pool_bits);
      out.put(static_cast<uint32_t>(row.size()), count_bits);
    }
  }
  for (const auto& [level, own] : levels) {
    out.put(level.first, kind_bits);
    y.put(level.second, out);
  }
  for (const auto& [level, at_x] : pool) {
    out.put(levels.at(level), level_bits);
    x.put(at_x, out);
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
    case shaping::kReverse:
    case shaping::kPositionContext:
      return put_rules(lookup, is_gpos, out);
    case shaping::kAdjust:
      return put_adjustments(lookup, out);
    case shaping::kPairs:
      return put_pairs(lookup, out);
    case shaping::kCursive:
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
