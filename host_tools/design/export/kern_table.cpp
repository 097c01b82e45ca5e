// Kerning of UFO 3, and the kern table.
#include <algorithm>
#include <cmath>

#include "export/tables.hpp"

namespace inkcell::design {
namespace {

// The most pairs of a subtable, whose length has 16 bits.
constexpr size_t kMostPairs = (65535 - 14) / 6;

struct Pair {
  unsigned left;
  unsigned right;
  int value;
};

void add_subtable(const Pair* pairs, size_t count, BigEndian& table) {
  unsigned log2 = 0;
  while (size_t{2} << log2 <= count) {
    ++log2;
  }
  table.u16(0);
  table.u16(static_cast<unsigned>(14 + 6 * count));
  table.u16(1);  // horizontal
  table.u16(static_cast<unsigned>(count));
  table.u16(6u << log2);
  table.u16(log2);
  table.u16(6 * static_cast<unsigned>(count) - (6u << log2));
  for (size_t i = 0; i < count; ++i) {
    table.u16(pairs[i].left);
    table.u16(pairs[i].right);
    table.i16(pairs[i].value);
  }
}

}  // namespace

KerningLookup::KerningLookup(const FontData& font) : font_(font) {
  for (const auto& [name, glyphs] : font.groups.items()) {
    const bool is_left = name.rfind("public.kern1.", 0) == 0;
    const bool is_right = name.rfind("public.kern2.", 0) == 0;
    if (!is_left && !is_right) {
      continue;
    }
    for (const Value& glyph : glyphs) {
      if (glyph.is_string()) {
        (is_left ? left_group_ : right_group_)[glyph.get<std::string>()] = name;
      }
    }
  }
}

double KerningLookup::value(const std::string& left,
                            const std::string& right) const {
  const auto group = [](const std::map<std::string, std::string>& groups,
                        const std::string& glyph) {
    const auto found = groups.find(glyph);
    return found == groups.end() ? std::string() : found->second;
  };
  const std::string left_group = group(left_group_, left);
  const std::string right_group = group(right_group_, right);
  const std::pair<std::string, std::string> order[] = {
      {left, right},
      {left, right_group},
      {left_group, right},
      {left_group, right_group}};
  for (const auto& [first, second] : order) {
    const auto row = font_.kerning.find(first);
    if (first.empty() || second.empty() || row == font_.kerning.end()) {
      continue;
    }
    const auto found = row->find(second);
    if (found != row->end() && found->is_number()) {
      return found->get<double>();
    }
  }
  return 0;
}

BigEndian kern_table(const FontData& font,
                     const std::vector<std::string>& glyphs) {
  BigEndian table;
  if (font.kerning.empty()) {
    return table;
  }
  const KerningLookup lookup(font);
  std::vector<Pair> pairs;
  for (size_t left = 0; left < glyphs.size(); ++left) {
    for (size_t right = 0; right < glyphs.size(); ++right) {
      const int value = static_cast<int>(
          std::lround(lookup.value(glyphs[left], glyphs[right])));
      if (value != 0) {
        pairs.push_back(
            {static_cast<unsigned>(left), static_cast<unsigned>(right), value});
      }
    }
  }
  if (pairs.empty()) {
    return table;
  }
  const size_t subtables = (pairs.size() + kMostPairs - 1) / kMostPairs;
  table.u16(0);
  table.u16(static_cast<unsigned>(subtables));
  for (size_t first = 0; first < pairs.size(); first += kMostPairs) {
    add_subtable(pairs.data() + first,
                 std::min(kMostPairs, pairs.size() - first), table);
  }
  return table;
}

}  // namespace inkcell::design
