// Rows of pixels on a line through the grid of a body, and of its neighbours.
#include "inkcell/kinetic/body_draw.hpp"

#include "inkcell/kinetic/body_contacts.hpp"
#include "limits.hpp"

namespace inkcell {
namespace kinetic {
namespace {

constexpr size_t kMostNeighbours = 6;
constexpr int32_t kRingQ10 = 6 << 10;   // around an overlap [px]
constexpr int32_t kBulgeQ10 = 1 << 10;  // at most [px]
constexpr int32_t kRun = 32;

// The place of a pixel's centre in the grid of a body. [px, Q16]
struct Place {
  int32_t x;
  int32_t y;
};

// A body as rows see it, small: a frame holds seven.
struct View {
  const DistanceGrid* grid;
  Place origin;  // of pixel (0, 0) of the box that is drawn
  int16_t cosine_q14;
  int16_t sine_q14;
  int16_t squeeze_q10;

  // A pixel to the right is (c, s) in the grid, one down (-s, c).
  Place at(int32_t x, int32_t y) const noexcept {
    return {origin.x + (cosine_q14 * x - sine_q14 * y) * 4,
            origin.y + (sine_q14 * x + cosine_q14 * y) * 4};
  }
  // Inside it; beyond the grid at least so far outside. [px, Q10]
  int32_t distance(const Place& place) const noexcept {
    const int32_t x_end = grid->width_px() << 16;
    const int32_t y_end = grid->height_px() << 16;
    const int32_t out =
        max(max(-place.x, place.x - x_end), max(-place.y, place.y - y_end));
    if (out > 4 << 16) {
      return -(out >> 6);
    }
    return probe(*grid, Q16_16::from_raw(place.x), Q16_16::from_raw(place.y))
        .distance_q10;
  }
};

// (x, y): the upper left corner of the box that is drawn, in px on the screen.
// Not inline: products of 64 bits take registers that frames would keep.
__attribute__((noinline)) void look_at(const Body& body,
                                       int32_t x,
                                       int32_t y,
                                       View& view) noexcept {
  const BodyShape& shape = *body.shape;
  const Turn turn = turn_of(body.angle());
  // Back by the body's turn: (x c - y s, y c + x s).
  view.grid = &shape.grid();
  view.cosine_q14 = static_cast<int16_t>(turn.cosine);
  view.sine_q14 = static_cast<int16_t>(turn.sine);
  const int64_t dx = int64_t{x} * 65536 + 32768 - body.x.raw;
  const int64_t dy = int64_t{y} * 65536 + 32768 - body.y.raw;
  view.origin.x =
      shape.centre_x().raw + scaled(dx * turn.cosine - dy * turn.sine, 14);
  view.origin.y =
      shape.centre_y().raw + scaled(dy * turn.cosine + dx * turn.sine, 14);
  view.squeeze_q10 = body.squeeze.raw;
}

// Gathers coverage of neighbouring pixels, and passes it on.
class Run {
 public:
  Run(const Sink& sink, int32_t y) noexcept : sink_(sink), y_(y) {}

  void add(int32_t x, uint8_t coverage) noexcept {
    if (x < sink_.window.x0 || x >= sink_.window.x1 || coverage == 0) {
      return;
    }
    if (count_ == kRun || x != first_ + count_) {
      flush();
      first_ = x;
    }
    coverage_[count_++] = coverage;
  }
  void fill(int32_t x, int32_t end) noexcept {
    flush();
    x = max(x, sink_.window.x0);
    end = min(end, sink_.window.x1);
    if (x < end) {
      sink_.solid(sink_.context, x, y_, end - x);
    }
  }
  void flush() noexcept {
    if (count_ != 0) {
      sink_.coverage(sink_.context, first_, y_, coverage_, count_);
      count_ = 0;
    }
  }

 private:
  const Sink& sink_;
  int32_t y_;
  int32_t first_ = 0;
  int32_t count_ = 0;
  uint8_t coverage_[kRun];
};

// A hill of height 1 over 0 to kRingQ10, flat at both ends. [Q10 -> Q10]
int32_t hill(int32_t way_q10) noexcept {
  if (way_q10 <= 0 || way_q10 >= kRingQ10) {
    return 0;
  }
  const int32_t part = way_q10 / (kRingQ10 >> 10);
  const int32_t slope = part * (1024 - part) >> 8;  // up to 1024
  return slope * slope >> 10;
}

struct Painter {
  View own;
  View others[kMostNeighbours];
  size_t count;
  const Rect& walls;
  const Filter& filter;

  // [px, Q10] From the nearest wall.
  int32_t from_wall(int32_t x, int32_t y) const noexcept {
    return min(min(x - walls.x0, walls.x1 - 1 - x),
               min(y - walls.y0, walls.y1 - 1 - y)) *
               1024 +
           512;
  }
  int32_t deformed(int32_t distance,
                   int32_t column,
                   int32_t line,
                   int32_t wall) const noexcept;
  // Frames of their own.
  __attribute__((noinline)) void add_neighbour(const Body& body,
                                               const Rect& whole,
                                               const Rect& box) noexcept;
  __attribute__((noinline)) void draw_row(const Rect& box,
                                          int32_t y,
                                          const Sink& sink) const noexcept;
};

bool have_common(const Rect& a, const Rect& b) noexcept {
  return !is_empty(intersect(a, b));
}

// If its box and the whole one of the body that is drawn have pixels in common.
void Painter::add_neighbour(const Body& body,
                            const Rect& whole,
                            const Rect& box) noexcept {
  if (have_common(whole, box_of(body))) {
    look_at(body, box.x0, box.y0, others[count++]);
  }
}

// (column, line): in the box.
int32_t Painter::deformed(int32_t distance,
                          int32_t column,
                          int32_t line,
                          int32_t wall) const noexcept {
  int32_t result = distance;
  int32_t bulge = 0;
  const auto swell = [&](int32_t squeeze, int32_t way) {
    bulge = max(bulge, min(squeeze / 2, kBulgeQ10) * hill(way) >> 10);
  };
  for (size_t i = 0; i < count; ++i) {
    const View& other = others[i];
    const int32_t depth = other.distance(other.at(column, line));
    result -= max(depth, 0);
    swell(min(own.squeeze_q10, other.squeeze_q10), -depth);
  }
  swell(own.squeeze_q10, wall);
  return min(result + bulge, wall);
}

void Painter::draw_row(const Rect& box,
                       int32_t y,
                       const Sink& sink) const noexcept {
  const int32_t line = y - box.y0;
  const int32_t width = box.x1 - box.x0;
  // Farther out nothing is covered, whatever swells; farther in all is.
  const int32_t blank = min(filter.outside_q10, 0) - kBulgeQ10 - 512;
  const int32_t full = max(filter.inside_q10, 0) + 512;
  Run run(sink, y);
  for (int32_t column = 0; column < width;) {
    const int32_t distance = own.distance(own.at(column, line));
    const int32_t x = box.x0 + column;
    if (distance < blank) {
      column += 1 + ((blank - distance) >> 10);
      continue;
    }
    const int32_t wall = from_wall(x, y);
    if (count == 0 && distance > full && wall > full) {
      // A pixel to the right is by a pixel less deep, at most.
      const int32_t deep = min(distance, wall) - full;
      const int32_t end = min(column + 1 + (deep >> 10), width);
      run.fill(x, box.x0 + end);
      column = end;
      continue;
    }
    run.add(x, filter.coverage(deformed(distance, column, line, wall)));
    ++column;
  }
  run.flush();
}

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
  const Rect box = intersect(whole, rules.walls);
  if (is_empty(box) || !have_common(box, sink.window)) {
    return;
  }
  Painter painter = {{}, {}, 0, rules.walls, filter};
  look_at(body, box.x0, box.y0, painter.own);
  for (size_t i = 0; i < bodies.size && painter.count < kMostNeighbours; ++i) {
    const Body& other = bodies[i];
    if (i != index && other.shape != nullptr && other.squeeze.raw > 0 &&
        body.squeeze.raw > 0) {
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
