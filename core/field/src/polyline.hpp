// An outline as straight edges, and the distance to it from any point.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"
#include "outlines/outline_glyph.hpp"

namespace inkcell::detail {

// A vertex and the direction of the edge that begins there. The last vertex of
// a contour lies on its first one, has that one's direction, and begins no
// edge. Lies in RAM that is lent as bytes.
struct __attribute__((may_alias)) Vertex {
  uint16_t x;
  uint16_t y;
  int16_t along_x;  // unit vector [Q14]
  int16_t along_y;  // bit 0: the last vertex of a contour
};

// The number of the vertex where an edge begins; in the same RAM.
using EdgeNumber __attribute__((may_alias)) = uint16_t;

// The edges of a glyph, y up, the ink on their left. Coordinates are in steps
// of 2^-fraction u from the lower left corner of a grid. Those edges that can
// be the nearest ones to a square are moved to the front of a list, so that a
// quadtree needs no other list for its smaller squares.
class Polyline {
 public:
  // The most edges of a curve.
  static constexpr int32_t kMaxChords = 32;

  // Where the grid of a glyph lies, and how exactly.
  struct Frame {
    int32_t x0_u;
    int32_t y0_u;
    int32_t fraction;  // 1..6
    int32_t error_q8;  // largest distance of an edge from its curve [u]
  };

  // Reads the outline, whose box is `box`, into the end of `ram`, which begins
  // and ends at multiples of 4, and shortens `ram` to what is left. False: it
  // does not fit.
  bool read(OutlineGlyph& glyph,
            const Rect& box,
            const Frame& frame,
            Span<uint8_t>& ram) noexcept;

  // Edges in the list.
  uint32_t count() const noexcept { return edge_count_; }

  // The distance from (x, y) to the nearest of the first `count` edges of the
  // list, positive where that edge has the ink. [steps] All coordinates are
  // 0..2^16.
  int32_t distance(int32_t x, int32_t y, uint32_t count) const noexcept;

  // Moves those of the first `count` edges to the front that may be as near as
  // `reach` to (x, y); returns how many.
  uint32_t keep(int32_t x, int32_t y, uint32_t count, int32_t reach) noexcept;

 private:
  struct Pen;

  // Vertices lie one below the other.
  const Vertex& vertex(uint32_t number) const noexcept {
    return top_[-1 - static_cast<int32_t>(number)];
  }

  Vertex* top_ = nullptr;
  EdgeNumber* edges_ = nullptr;  // the list
  uint32_t edge_count_ = 0;
};

}  // namespace inkcell::detail
