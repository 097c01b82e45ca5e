#include "polyline.hpp"

#include "base/math.hpp"
#include "rows/contours.hpp"

namespace inkcell::detail {

// From one point to another, or from the origin.
struct Offset {
  int32_t x;
  int32_t y;
};

namespace {

constexpr int32_t kLastVertex = 1;  // in Vertex::along_y
constexpr size_t kMaxVertices = UINT16_MAX;

// Half the rounding of directions, so that quotients are the nearest ones.
constexpr int32_t kHalfQ14 = 1 << 13;

// A vertex that turns by less than this has the sign of its edge's line, which
// is near the truth there; others are convex or concave for sure. The sine of
// 10 degrees. [Q28]
constexpr int32_t kStraightQ28 = 46613490;

int32_t dot_q14(const Offset& v, const Vertex& edge) noexcept {
  return v.x * edge.along_x + v.y * edge.along_y;
}
// Positive to the left of the edge.
int32_t height(const Offset& v, const Vertex& edge) noexcept {
  return (v.y * edge.along_x - v.x * edge.along_y + kHalfQ14) >> 14;
}

Offset from(const Vertex& vertex, int32_t x, int32_t y) noexcept {
  return {x - vertex.x, y - vertex.y};
}

uint32_t square(int32_t value) noexcept {
  return static_cast<uint32_t>(value * value);
}

// To the nearest, of components below 2^17.
int32_t length(const Offset& v) noexcept {
  const int32_t shift = max(abs(v.x), abs(v.y)) < (1 << 15) ? 0 : 2;
  return static_cast<int32_t>(
      nearest_root_of(square(v.x >> shift) + square(v.y >> shift)) << shift);
}

// Turns `vertex` to `v`, which is not 0. Not the last of a contour.
void set_direction(Vertex& vertex, Offset v) noexcept {
  // With the longer component in 2^14..2^15 the length is exact to 2^-15.
  while (max(abs(v.x), abs(v.y)) >= 1 << 15) {
    v = {v.x >> 1, v.y >> 1};
  }
  while (max(abs(v.x), abs(v.y)) < 1 << 14) {
    v = {v.x * 2, v.y * 2};
  }
  const int32_t over = length(v);
  vertex.along_x = static_cast<int16_t>((v.x * (1 << 15) / over + 1) >> 1);
  vertex.along_y =
      static_cast<int16_t>((v.y * (1 << 14) / over + 1) & ~kLastVertex);
}

}  // namespace

// Writes vertices. Positions are those of points: px of 1 u, y down.
struct Polyline::Pen {
  static constexpr bool kNearRows = false;
  const Frame& frame;
  int32_t left_q8;    // of the grid
  int32_t bottom_q8;  // likewise
  Vertex* top;
  uint32_t room;       // vertices that fit
  uint32_t count = 0;  // those that are written
  uint32_t first = 0;  // the contour's
  bool is_full = false;

  Vertex& vertex(uint32_t number) const noexcept {
    return top[-1 - static_cast<int32_t>(number)];
  }
  uint16_t to_step(int32_t from_q8) const noexcept {
    const int32_t down = 8 - frame.fraction;
    const int32_t step = (from_q8 + (1 << down >> 1)) >> down;
    return static_cast<uint16_t>(min(max(step, 0), UINT16_MAX));
  }
  void add_point(const PixelPoint& to) noexcept {
    if (count == room) {
      is_full = true;
      return;
    }
    Vertex& next = vertex(count);
    next.x = to_step(to.x - left_q8);
    next.y = to_step(bottom_q8 - to.y);
    next.along_y = kLastVertex;
    if (count != first) {
      Vertex& last = vertex(count - 1);
      if (next.x == last.x && next.y == last.y) {
        return;
      }
      set_direction(last, {next.x - last.x, next.y - last.y});
    }
    ++count;
  }

  // A parabola is farther from n chords than bend / (4 n^2) nowhere.
  void add_curve(const PixelPoint* edge) noexcept {
    const PixelPoint& at = edge[0];
    const Offset side = {2 * (edge[1].x - at.x), 2 * (edge[1].y - at.y)};
    const Offset bend = {edge[2].x - at.x - side.x, edge[2].y - at.y - side.y};
    const int32_t x = abs(bend.x);
    const int32_t y = abs(bend.y);
    const int32_t most = max(x, y) + min(x, y) / 2;
    int32_t chords = 1;
    while (chords < kMaxChords && 4 * chords * chords * frame.error_q8 < most) {
      ++chords;
    }
    for (int32_t i = 1; i < chords; ++i) {
      add_point({at.x + i * (side.x + i * bend.x / chords) / chords,
                 at.y + i * (side.y + i * bend.y / chords) / chords});
    }
  }

  void take(const PixelPoint* edge, bool is_bent, uint32_t) noexcept {
    if (is_bent) {
      add_curve(edge);
    }
    add_point(edge[2]);
  }
  void start(const PixelPoint& at) noexcept {
    end_contour();
    first = count;
    add_point(at);
  }
  void end_contour() noexcept {
    if (count - first < 3) {
      count = first;
      return;
    }
    Vertex& last = vertex(count - 1);
    last.along_x = vertex(first).along_x;
    last.along_y = static_cast<int16_t>(vertex(first).along_y | kLastVertex);
  }
};

bool Polyline::read(OutlineGlyph& glyph,
                    const Rect& box,
                    const Frame& frame,
                    Span<uint8_t>& ram) noexcept {
  top_ = reinterpret_cast<Vertex*>(ram.data + ram.size);
  const size_t room = ram.size / (sizeof(Vertex) + sizeof(EdgeNumber));
  Pen pen = {frame, (frame.x0_u - first_column(box)) * 256,
             -(frame.y0_u + box.y0) * 256, top_,
             static_cast<uint32_t>(room < kMaxVertices ? room : kMaxVertices)};
  const Band whole = {};
  PixelPoint edge[3] = {};
  bool is_bent = false;
  glyph.rewind();
  // cppcheck-suppress danglingTemporaryLifetime ; none is one
  while (!glyph.is_done() && !pen.is_full) {
    ScreenPoint points[8];
    walk_contours(whole, edge, is_bent, points, glyph.read(points, 8), pen);
  }
  pen.end_contour();
  edges_ = reinterpret_cast<EdgeNumber*>(top_ - pen.count) - pen.count;
  edge_count_ = 0;
  for (uint32_t i = 0; i < pen.count; ++i) {
    if ((vertex(i).along_y & kLastVertex) == 0) {
      edges_[edge_count_++] = static_cast<EdgeNumber>(i);
    }
  }
  ram.size -= (sizeof(Vertex) + sizeof(EdgeNumber)) * pen.count;
  ram.size &= ~size_t{3};
  return !pen.is_full;
}

// The vertex that an edge ends at belongs to it, the one that it begins at to
// the edge before. Squares are of halves, so that they fit.
int32_t Polyline::distance(int32_t x,
                           int32_t y,
                           uint32_t count) const noexcept {
  uint32_t least = UINT32_MAX;
  int32_t best = -int32_t{UINT16_MAX};  // the height over the nearest edge
  const Vertex* nearest_end = nullptr;  // where that is its end
  for (uint32_t i = 0; i < count; ++i) {
    const Vertex* const begin = &vertex(edges_[i]);
    const Vertex* const end = begin - 1;
    const Offset v = from(*begin, x, y);
    const int32_t up = height(v, *begin);
    uint32_t away = square(up >> 1);
    if (away >= least || dot_q14(v, *begin) < 0) {
      continue;
    }
    const Offset w = from(*end, x, y);
    const bool is_beyond = dot_q14(w, *begin) > 0;
    if (is_beyond) {
      away = square(w.x >> 1) + square(w.y >> 1);
      if (away >= least) {
        continue;
      }
    }
    least = away;
    best = up;
    nearest_end = is_beyond ? end : nullptr;
  }
  if (nearest_end == nullptr) {
    return best;
  }
  const Vertex& next = *nearest_end;
  const Vertex& last = nearest_end[1];
  const int32_t turn_q28 =
      last.along_x * next.along_y - last.along_y * next.along_x;
  const bool is_straight =
      abs(turn_q28) < kStraightQ28 &&
      last.along_x * next.along_x + last.along_y * next.along_y > 0;
  const int32_t away = length(from(next, x, y));
  return (is_straight ? best < 0 : turn_q28 >= 0) ? -away : away;
}

// The greatest of three bounds of an edge's distance: over its line, before its
// begin, and beyond its end.
uint32_t Polyline::keep(int32_t x,
                        int32_t y,
                        uint32_t count,
                        int32_t reach) noexcept {
  uint32_t kept = 0;
  const int32_t far = -reach - 1;
  for (uint32_t i = 0; i < count; ++i) {
    const EdgeNumber edge = edges_[i];
    const Vertex& begin = vertex(edge);
    const Offset v = from(begin, x, y);
    if (abs(height(v, begin)) <= reach && dot_q14(v, begin) >> 14 >= far &&
        dot_q14(from(vertex(edge + 1u), x, y), begin) >> 14 <= reach) {
      edges_[i] = edges_[kept];
      edges_[kept++] = edge;
    }
  }
  return kept;
}

}  // namespace inkcell::detail
