// Draws rows of pixels, each a line through the grids of a body and its
// neighbours.
#include "inkcell/kinetic/body_draw.hpp"

#include "inkcell/kinetic/body_contacts.hpp"
#include "limits.hpp"
#include "pixel_run.hpp"

namespace inkcell {
namespace kinetic {
namespace {

constexpr size_t kMostNeighbours = 6;
constexpr int32_t kRingQ10 = 6 << 10;  // around an overlap [px]
constexpr int32_t kBulgeQ10 = kRingQ10 / 4;

// The centre of a pixel in a body's grid, from the centre of the first sample.
// [px, Q16]
struct Place {
  int32_t x;
  int32_t y;
};

// The data of a body that rows need. Small: a frame holds seven.
struct View {
  const BodyShape* shape;
  Place origin;  // of pixel (0, 0) of the box
  // A step to the right is (cosine, sine), a step down (-sine, cosine).
  int16_t cosine_q14;
  int16_t sine_q14;
  int16_t squeeze_q10;

  // The distance of a pixel; outside of the grid an upper bound. [px, Q10] As
  // probe(), without slopes, which takes a tenth off a frame.
  int32_t distance(int32_t x, int32_t y) const noexcept {
    const DistanceGrid& grid = shape->grid();
    const int32_t scale = grid.scale_log2();
    // From the centre of the first sample to that of the last. [Q16 px]
    const int32_t right = origin.x + (cosine_q14 * x - sine_q14 * y) * 4;
    const int32_t down = origin.y + (sine_q14 * x + cosine_q14 * y) * 4;
    const int32_t side = 1 << (16 + scale);
    const int32_t out = max(max(-right, right - (grid.width() - 1) * side),
                            max(-down, down - (grid.height() - 1) * side));
    if (out >= 0) {
      return -(out >> 6) - shape->margin_q10();
    }
    const int8_t* top =
        grid.row(down >> (16 + scale)) + (right >> (16 + scale));
    const int8_t* bottom = top + grid.width();
    const int32_t x_part = (right >> (8 + scale)) & 255;
    const int32_t y_part = (down >> (8 + scale)) & 255;
    const int32_t above = top[0] * 256 + (top[1] - top[0]) * x_part;
    const int32_t below = bottom[0] * 256 + (bottom[1] - bottom[0]) * x_part;
    // A sample stands for the middle of its quantum. [Q13 of a sample]
    const int32_t sum = above + ((below - above) * y_part >> 8) + 128;
    return sum * (1 << scale) >> 3;
  }
  // The width of the bulge around an overlap: the range of the grid. [px, Q10]
  int32_t ring_q10() const noexcept {
    return min(4032 << shape->grid().scale_log2(), kRingQ10);
  }
  // The greatest bulge, small enough that rings do not meet.
  int32_t bulge_q10() const noexcept {
    return min(squeeze_q10, ring_q10() >> 2);
  }
};

// (x, y): the upper left corner of the box, in px on the screen.
__attribute__((noinline)) void look_at(const Body& body,
                                       int32_t x,
                                       int32_t y,
                                       View& view) noexcept {
  const BodyShape& shape = *body.shape;
  const Turn turn = turn_of(body.angle());
  // Rotated back by the body's angle: (x c - y s, y c + x s).
  const int64_t dx = int64_t{x} * 65536 + 32768 - body.x.raw;
  const int64_t dy = int64_t{y} * 65536 + 32768 - body.y.raw;
  view.shape = &shape;
  view.cosine_q14 = static_cast<int16_t>(turn.cosine);
  view.sine_q14 = static_cast<int16_t>(turn.sine);
  const int32_t half = 1 << (15 + shape.grid().scale_log2());
  view.origin.x = shape.centre_x().raw - half +
                  scaled(dx * turn.cosine - dy * turn.sine, 14);
  view.origin.y = shape.centre_y().raw - half +
                  scaled(dy * turn.cosine + dx * turn.sine, 14);
  view.squeeze_q10 =
      static_cast<int16_t>(min(max(body.squeeze.raw, -kBulgeQ10), kBulgeQ10));
}

// A hill of height 1 over 0 to `ring`, flat at both ends. [Q10 -> Q10]
int32_t hill(int32_t distance_q10, int32_t ring_q10) noexcept {
  if (distance_q10 <= 0 || distance_q10 >= ring_q10) {
    return 0;
  }
  const int32_t part = distance_q10 * 1024 / ring_q10;
  const int32_t slope = part * (1024 - part) >> 8;  // up to 1024
  return slope * slope >> 10;
}

bool have_common(const Rect& a, const Rect& b) noexcept {
  return !is_empty(intersect(a, b));
}

struct BodyPainter {
  View own;
  View others[kMostNeighbours];
  size_t count;
  Rect walls;
  const Filter& filter;

  // The distance from the nearest wall. [px, Q10]
  int32_t from_wall(int32_t x, int32_t y) const noexcept {
    return min(min(x - walls.x0, walls.x1 - 1 - x),
               min(y - walls.y0, walls.y1 - 1 - y)) *
               1024 +
           512;
  }
  // The distance of a pixel from the lines that cut the body. [px, Q10]
  // (column, line) is in the box. Neighbour i does not matter to the left of
  // next[i]: a step of one pixel changes a distance by at most 1 px.
  int32_t cut_of(int32_t distance,
                 int32_t column,
                 int32_t line,
                 int32_t (&next)[kMostNeighbours],
                 int32_t& bulge) const noexcept {
    int32_t cut = INT32_MAX;
    for (size_t i = 0; i < count; ++i) {
      const View& other = others[i];
      const int32_t ring = other.ring_q10();
      int32_t depth = -ring;
      if (column >= next[i]) {
        depth = other.distance(column, line);
        const int32_t far = -depth - ring;
        next[i] = far < 0 ? column : column + 1 + (far >> 10);
        const int32_t most = min(own.bulge_q10(), other.bulge_q10());
        bulge = max(bulge, hill(-depth, ring) * most >> 10);
      }
      // The pixel belongs to the body in which it is deeper.
      cut = min(cut, (distance - max(depth, -ring)) >> 1);
    }
    return cut;
  }

  // Not inline, to keep frames small.
  // Adds a body whose box overlaps that of the body drawn.
  __attribute__((noinline)) void add_neighbour(const Body& body,
                                               const Rect& whole,
                                               const Rect& box) noexcept {
    if (have_common(whole, box_of(body))) {
      look_at(body, box.x0, box.y0, others[count++]);
    }
  }

  __attribute__((noinline)) void draw_row(const Rect& box,
                                          int32_t y,
                                          const Sink& sink) const noexcept {
    const int32_t line = y - box.y0;
    const int32_t width = box.x1 - box.x0;
    // Distances without coverage, even with a bulge, and with full coverage.
    const int32_t blank = min(filter.outside_q10, 0) - own.bulge_q10() - 64;
    const int32_t full = max(filter.inside_q10, 0) + 64;
    int32_t next[kMostNeighbours] = {};
    PixelRun run(sink, y);
    for (int32_t column = 0; column < width;) {
      const int32_t distance = own.distance(column, line);
      if (distance < blank) {
        column += 1 + ((blank - distance) >> 10);
        continue;
      }
      const int32_t x = box.x0 + column;
      const int32_t wall = from_wall(x, y);
      int32_t bulge = hill(wall, own.ring_q10()) * own.bulge_q10() >> 10;
      const int32_t cut =
          min(wall, cut_of(distance, column, line, next, bulge));
      // A step of one pixel lessens the depth by at most 1 px.
      const int32_t deep = min(distance, cut) - full;
      if (deep > 0) {
        const int32_t end = min(column + 1 + (deep >> 10), width);
        run.fill(x, box.x0 + end);
        column = end;
      } else {
        if (x >= sink.window.x0 && x < sink.window.x1) {
          run.add(x, filter.coverage(min(distance + bulge, cut)));
        }
        ++column;
      }
    }
    run.flush();
  }
};

}  // namespace

void draw_body(Span<const Body> bodies,
               size_t index,
               const BodyRules& rules,
               const Filter& filter,
               const Sink& sink) noexcept {
  const Body& body = bodies[index];
  if (body.shape == nullptr) {
    return;
  }
  const Rect whole = box_of(body);
  const Rect walls = intersect(rules.walls, {-8191, -8191, 8191, 8191});
  const Rect box = intersect(whole, walls);
  if (is_empty(box) || !have_common(box, sink.window)) {
    return;
  }
  BodyPainter painter = {{}, {}, 0, walls, filter};
  look_at(body, box.x0, box.y0, painter.own);
  const size_t most = rules.overlap.raw > 0 ? kMostNeighbours : 0;
  for (size_t i = 0; i < bodies.size && painter.count < most; ++i) {
    const Body& other = bodies[i];
    if (i != index && other.shape != nullptr) {
      painter.add_neighbour(other, whole, box);
    }
  }
  const int32_t first = max(box.y0, sink.window.y0);
  const int32_t end = min(box.y1, sink.window.y1);
  for (int32_t y = first; y < end; ++y) {
    painter.draw_row(box, y, sink);
  }
}

}  // namespace kinetic
}  // namespace inkcell
