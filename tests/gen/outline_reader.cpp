#include "outline_reader.hpp"

#include <algorithm>

#include "bits.hpp"

namespace inkcell::gen::test {

MinimalOutline read_outline(const std::vector<uint8_t>& record,
                            const std::vector<uint16_t>& tables,
                            int code_bits,
                            GridPosition start,
                            int most_points) {
  Bits bits(record);
  MinimalOutline outline;
  if (bits.u(1) != 1) {
    return outline;
  }
  size_t table = 0;
  GridPosition at = start;
  bool begins = true;
  for (int i = 0; i < most_points; ++i) {
    const size_t place = bits.at();
    const int entry =
        tables[(table << code_bits) + static_cast<size_t>(bits.u(code_bits))];
    table ^= static_cast<size_t>(entry >> 13);
    bits.seek(place + static_cast<size_t>(entry & 7));
    const int kind = entry >> 3 & 3;
    if (kind == 3) {
      begins = true;
      if (bits.u(1) == 0) {
        return outline;
      }
      continue;
    }
    at.x += bits.s(entry >> 5 & 15);
    at.y += bits.s(entry >> 9 & 15);
    if (begins) {
      outline.contours.emplace_back();
      begins = false;
    }
    outline.contours.back().points.push_back(
        {at.x, at.y, static_cast<PointKind>(kind)});
  }
  return outline;
}

OutlineReferences read_composite(const std::vector<uint8_t>& record) {
  Bits bits(record);
  OutlineReferences references;
  if (bits.u(8) != 3) {
    return references;
  }
  do {
    OutlineReference reference;
    reference.glyph = static_cast<size_t>(bits.u(16));
    const bool has_matrix = bits.u(1) == 1;
    const int width = bits.u(4);
    reference.dx = bits.s(width);
    reference.dy = bits.s(width);
    for (int& value : reference.matrix_q14) {
      value = has_matrix ? bits.s(16) : value;
    }
    references.push_back(reference);
  } while (bits.u(1) == 1);
  return references;
}

bool same(const MinimalOutline& a, const MinimalOutline& b) {
  const auto same_point = [](const GridPoint& p, const GridPoint& q) {
    return p.x == q.x && p.y == q.y && p.kind == q.kind;
  };
  return std::equal(
      a.contours.begin(), a.contours.end(), b.contours.begin(),
      b.contours.end(), [&](const MinimalContour& c, const MinimalContour& d) {
        return std::equal(c.points.begin(), c.points.end(), d.points.begin(),
                          d.points.end(), same_point);
      });
}

}  // namespace inkcell::gen::test
