// The characters of a TrueType font: formats 4 and 12.
#include "export/tables.hpp"

#include <algorithm>

namespace inkcell::design {
namespace {

struct Run {
  char32_t first;
  char32_t last;
  unsigned glyph;
};

std::vector<Run> runs(const std::map<char32_t, unsigned>& map, char32_t most) {
  std::vector<Run> result;
  for (const auto& [c, glyph] : map) {
    if (c > most) {
      break;
    }
    if (!result.empty() && result.back().last + 1 == c &&
        result.back().glyph + (c - result.back().first) == glyph) {
      result.back().last = c;
    } else {
      result.push_back({c, c, glyph});
    }
  }
  return result;
}

BigEndian format_4(const std::map<char32_t, unsigned>& map) {
  std::vector<Run> list = runs(map, 0xfffe);
  list.push_back({0xffff, 0xffff, 0});
  const unsigned count = static_cast<unsigned>(list.size());
  BigEndian table;
  table.words(4, std::min(16 + 8 * count, 65535u), 0, 2 * count);
  table.search(count, 2);
  for (const Run& run : list) {
    table.u16(run.last);
  }
  table.u16(0);
  for (const Run& run : list) {
    table.u16(run.first);
  }
  for (const Run& run : list) {
    table.u16(run.first == 0xffff ? 1 : (run.glyph - run.first) & 0xffff);
  }
  for (size_t i = 0; i < list.size(); ++i) {
    table.u16(0);
  }
  return table;
}

BigEndian format_12(const std::map<char32_t, unsigned>& map) {
  const std::vector<Run> list = runs(map, 0x10ffff);
  BigEndian table;
  table.words(12, 0);
  table.u32(static_cast<uint32_t>(16 + 12 * list.size()));
  table.u32(0);
  table.u32(static_cast<uint32_t>(list.size()));
  for (const Run& run : list) {
    table.u32(run.first);
    table.u32(run.last);
    table.u32(run.glyph);
  }
  return table;
}

}  // namespace

BigEndian cmap_table(const std::map<char32_t, unsigned>& map) {
  const BigEndian small = format_4(map);
  BigEndian table;
  table.words(0, 2);
  table.words(3, 1);  // Windows, the basic plane
  table.u32(20);
  table.words(3, 10);  // all of Unicode
  table.u32(static_cast<uint32_t>(20 + small.size()));
  table.append(small);
  table.append(format_12(map));
  return table;
}

}  // namespace inkcell::design
