// Kerning of UFO 3, and the tables kern and GPOS.
#include <algorithm>
#include <cmath>

#include "export/tables.hpp"
#include "model/error.hpp"

namespace inkcell::design {
namespace {

// The most pairs of a subtable, whose length has 16 bits.
constexpr size_t kMostPairs = (65535 - 14) / 6;

// The bytes of a matrix of GPOS; offsets of 16 bits follow it.
constexpr size_t kMostMatrix = 24000;

struct Pair {
  size_t left;
  size_t right;
  int value;
};

void add_subtable(const Pair* pairs, size_t count, BigEndian& table) {
  table.words(0, 14 + 6 * count, 1, count);  // horizontal
  table.search(count, 6);
  for (size_t i = 0; i < count; ++i) {
    table.words(pairs[i].left, pairs[i].right, pairs[i].value);
  }
}

std::vector<Pair> pairs_of(const gen::KerningMatrix& kerning) {
  std::vector<Pair> pairs;
  for (size_t left = 0; left < kerning.left_class.size(); ++left) {
    for (size_t right = 0; right < kerning.right_class.size(); ++right) {
      const int value = kerning.value(left, right);
      if (value != 0) {
        pairs.push_back({left, right, value});
      }
    }
  }
  return pairs;
}

// Glyphs by their classes in [first, last), which are numbered from `base` on.
BigEndian class_definition(const std::vector<uint16_t>& classes,
                           size_t first,
                           size_t last,
                           size_t base) {
  BigEndian ranges;
  unsigned count = 0;
  for (size_t i = 0; i < classes.size();) {
    size_t end = i + 1;
    while (end < classes.size() && classes[end] == classes[i]) {
      ++end;
    }
    if (classes[i] > first && classes[i] <= last) {
      ranges.words(i, end - 1, classes[i] - 1 - first + base);
      ++count;
    }
    i = end;
  }
  BigEndian table;
  table.words(2, count);
  table.append(ranges);
  return table;
}

// The rows [first, last) of the matrix as PairPosFormat2.
BigEndian pair_classes(const gen::KerningMatrix& kerning,
                       size_t first,
                       size_t last) {
  const auto columns = static_cast<size_t>(kerning.right_classes);
  BigEndian matrix;
  for (size_t row = first; row < last; ++row) {
    matrix.i16(0);  // glyphs of no class
    for (size_t column = 0; column < columns; ++column) {
      matrix.i16(kerning.values[row * columns + column]);
    }
  }
  BigEndian coverage;
  coverage.words(1, 0);
  for (size_t i = 0; i < kerning.left_class.size(); ++i) {
    if (kerning.left_class[i] > first && kerning.left_class[i] <= last) {
      coverage.u16(static_cast<unsigned>(i));
    }
  }
  coverage.set_u16(2, static_cast<unsigned>(coverage.size() / 2 - 2));
  const BigEndian left = class_definition(kerning.left_class, first, last, 0);
  const size_t at = 16 + matrix.size();
  if (at + coverage.size() + left.size() > 65535) {
    throw Error("the kerning has too many glyphs of one class for GPOS");
  }
  BigEndian table;
  table.words(2, at, 4, 0, at + coverage.size(),
              at + coverage.size() + left.size(), last - first, columns + 1);
  table.append(matrix);
  table.append(coverage);
  table.append(left);
  table.append(class_definition(kerning.right_class, 0, columns, 1));
  return table;
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

std::string KerningLookup::left_group(const std::string& glyph) const {
  const auto found = left_group_.find(glyph);
  return found == left_group_.end() ? std::string() : found->second;
}

std::string KerningLookup::right_group(const std::string& glyph) const {
  const auto found = right_group_.find(glyph);
  return found == right_group_.end() ? std::string() : found->second;
}

std::pair<std::string, std::string> KerningLookup::entry(
    const std::string& left, const std::string& right) const {
  const std::string lefts = left_group(left);
  const std::string rights = right_group(right);
  const std::pair<std::string, std::string> order[] = {
      {left, right}, {left, rights}, {lefts, right}, {lefts, rights}};
  for (const auto& [first, second] : order) {
    const auto row = font_.kerning.find(first);
    if (!first.empty() && !second.empty() && row != font_.kerning.end() &&
        row->contains(second) && (*row)[second].is_number()) {
      return {first, second};
    }
  }
  return {lefts.empty() ? left : lefts, rights.empty() ? right : rights};
}

double KerningLookup::value(const std::string& left,
                            const std::string& right) const {
  const auto [first, second] = entry(left, right);
  const auto row = font_.kerning.find(first);
  return row == font_.kerning.end() ? 0 : row->value(second, 0.0);
}

gen::KerningMatrix kerning_of(const FontData& font,
                              const std::vector<std::string>& glyphs) {
  if (font.kerning.empty()) {
    return {};
  }
  const KerningLookup lookup(font);
  std::vector<size_t> lefts;
  std::vector<std::vector<int16_t>> rows;
  for (size_t left = 0; left < glyphs.size(); ++left) {
    std::vector<int16_t> row;
    for (const std::string& right : glyphs) {
      row.push_back(static_cast<int16_t>(std::lround(
          std::clamp(lookup.value(glyphs[left], right), -32768.0, 32767.0))));
    }
    if (std::any_of(row.begin(), row.end(), [](int16_t v) { return v != 0; })) {
      lefts.push_back(left);
      rows.push_back(std::move(row));
    }
  }
  return rows.empty() ? gen::KerningMatrix()
                      : gen::join_classes(glyphs.size(), lefts, rows);
}

size_t kerned_pairs(const gen::KerningMatrix& kerning) {
  return pairs_of(kerning).size();
}

BigEndian kern_table(const gen::KerningMatrix& kerning) {
  const std::vector<Pair> pairs = pairs_of(kerning);
  BigEndian table;
  const size_t subtables = (pairs.size() + kMostPairs - 1) / kMostPairs;
  table.words(0, subtables);
  for (size_t first = 0; first < pairs.size(); first += kMostPairs) {
    add_subtable(pairs.data() + first,
                 std::min(kMostPairs, pairs.size() - first), table);
  }
  return table;
}

// One lookup. Each subtable is reached by an extension of 8 bytes, whose offset
// has 32 bits.
BigEndian gpos_table(const gen::KerningMatrix& kerning) {
  const auto rows = static_cast<size_t>(kerning.left_classes);
  const size_t columns = static_cast<size_t>(kerning.right_classes) + 1;
  const size_t step = std::max<size_t>(1, kMostMatrix / (2 * columns));
  std::vector<BigEndian> subtables;
  for (size_t first = 0; first < rows; first += step) {
    subtables.push_back(
        pair_classes(kerning, first, std::min(rows, first + step)));
  }
  BigEndian table;
  table.u32(0x00010000);
  table.words(10, 30, 44, 1);  // scripts, features, lookups
  table.text("DFLT");
  table.words(8, 4, 0, 0, 0xffff, 1, 0);  // one language with one feature
  table.u16(1);
  table.text("kern");
  table.words(8, 0, 1, 0, 1, 4, 9, 0);  // the first lookup: extensions
  const size_t count = subtables.size();
  table.words(count);
  for (size_t i = 0; i < count; ++i) {
    table.words(6 + 2 * count + 8 * i);
  }
  size_t at = 8 * count;
  for (size_t i = 0; i < count; ++i) {
    table.words(1, 2);  // pairs
    table.u32(static_cast<uint32_t>(at - 8 * i));
    at += subtables[i].size();
  }
  for (const BigEndian& subtable : subtables) {
    table.append(subtable);
  }
  return table;
}

}  // namespace inkcell::design
