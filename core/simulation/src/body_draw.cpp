// Draws rows of pixels, each a line through the grids of a body and its
// neighbours.
#include "inkcell/simulation/body_draw.hpp"

#include "inkcell/simulation/body_contacts.hpp"
#include "limits.hpp"
#include "pixel_run.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kMostSwellQ10 = 1 << 10;

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
  // Steps in the grid [Q14]; (cosine, sine) and (-sine, cosine) of a body that
  // is not squashed.
  int16_t x_right;
  int16_t y_right;
  int16_t x_down;
  int16_t y_down;
  int16_t bulge_q10;  // of the body drawn: beside this neighbour
  int16_t next;       // it does not matter to the left of this column

  // The first pixel of a row.
  Place row(int32_t y) const noexcept {
    return {origin.x + x_down * y * 4, origin.y + y_down * y * 4};
  }
  // The distance of a pixel of the row that begins at `from`.
  int32_t distance(const ShapeField& field,
                   const Place& from,
                   int32_t x) const noexcept {
    return field.at(from.x + x_right * x * 4, from.y + y_right * x * 4);
  }
};

// The lowest point of a turned body, below its centre. [px, Q16]
int32_t lowest_of(const BodyShape& shape, const Turn& turn) noexcept {
  int32_t lowest = 0;
  for (const BodyPoint& point : shape.points()) {
    lowest = max(lowest, turn.cosine * point.y_q5 - turn.sine * point.x_q5);
  }
  return lowest >> 3;
}

// (x, y): the upper left corner of the box, in px on the screen.
__attribute__((noinline)) void look_at(const Body& body,
                                       int32_t x,
                                       int32_t y,
                                       View& view) noexcept {
  const BodyShape& shape = *body.shape;
  const Turn turn = turn_of(body.angle());
  // Rotated back by the body's angle: (x c - y s, y c + x s).
  int64_t dx = int64_t{x} * 65536 + 32768 - body.x.raw;
  int64_t dy = int64_t{y} * 65536 + 32768 - body.y.raw;
  // In the grid, what is drawn of a squashed body is farther from its lowest
  // line, and nearer to its middle.
  const int32_t flat = clamp(body.squash.raw, 0, Body::kMostSquashQ14);
  const int32_t across = kOneQ14 - flat;
  const int32_t along = kOneQ14 * kOneQ14 / across;
  if (flat != 0) {
    const int32_t lowest = lowest_of(shape, turn);
    dx = dx * across >> 14;
    dy = clamp_i64(lowest + ((dy - lowest) * along >> 14), -(1 << 30), 1 << 30);
  }
  view.shape = &shape;
  view.x_right = static_cast<int16_t>(turn.cosine * across >> 14);
  view.y_right = static_cast<int16_t>(turn.sine * across >> 14);
  view.x_down = static_cast<int16_t>(-turn.sine * along >> 14);
  view.y_down = static_cast<int16_t>(turn.cosine * along >> 14);
  const int32_t half = 1 << (15 + shape.grid().scale_log2());
  view.origin.x = shape.centre_x().raw - half +
                  scaled(dx * turn.cosine - dy * turn.sine, 14);
  view.origin.y = shape.centre_y().raw - half +
                  scaled(dy * turn.cosine + dx * turn.sine, 14);
}

struct BodyPainter {
  View own;  // bulge_q10: all around
  View others[Body::kMostTouches];
  size_t count;
  uint8_t wall_bulges_q6[4];  // left, top, right, bottom
  Rect walls;
  Rect box;
  const Filter& filter;

  int32_t scale() const noexcept { return own.shape->grid().scale_log2(); }
  // The bulge at a distance from a wall. [px -> px, Q10]
  int32_t at_wall(int32_t wall, int32_t px) const noexcept {
    const int32_t bulge_q10 = wall_bulges_q6[wall] * 16;
    return bulge_q10 == 0
               ? 0
               : bulge_share(-px * 1024 - 512, scale()) * bulge_q10 >> 10;
  }
  // An upper bound of bulges in a row, where `around` is known.
  int32_t most_bulge(int32_t around) const noexcept {
    int32_t sum = around + max(wall_bulges_q6[0], wall_bulges_q6[2]) * 16;
    for (size_t i = 0; i < count; ++i) {
      sum += others[i].bulge_q10;
    }
    return min(sum, own.bulge_q10 + most_bulge_q10(scale()));
  }

  // The distance of a pixel from the lines that cut the body; adds to `bulge`.
  // [px, Q10] (column, line) is in the box. A step of one pixel changes a
  // distance by at most 1 px.
  int32_t cut_of(int32_t distance,
                 int32_t column,
                 int32_t line,
                 int32_t& bulge) noexcept {
    int32_t cut = INT32_MAX;
    for (size_t i = 0; i < count; ++i) {
      View& other = others[i];
      if (column < other.next) {
        continue;
      }
      const int32_t other_scale = other.shape->grid().scale_log2();
      const int32_t depth =
          other.distance(ShapeField(*other.shape), other.row(line), column);
      const int32_t far = -depth - (4096 << other_scale);
      if (far >= 0) {
        other.next = static_cast<int16_t>(column + 1 + (far >> 10));
        continue;
      }
      bulge += bulge_share(depth, other_scale) * other.bulge_q10 >> 10;
      // The pixel belongs to the body in which it is deeper.
      cut = min(cut, (distance - depth) >> 1);
    }
    return cut;
  }

  __attribute__((noinline)) void draw_row(int32_t y,
                                          const Sink& sink) noexcept {
    const int32_t line = y - box.y0;
    const int32_t end = min(box.x1, sink.window.x1) - box.x0;
    const int32_t around =
        own.bulge_q10 + at_wall(1, y - walls.y0) + at_wall(3, walls.y1 - 1 - y);
    const int32_t limit = most_bulge(around);
    // Distances without coverage, even with a bulge, and with full coverage.
    const int32_t blank = min(filter.outside_q10, 0) - limit - 64;
    const int32_t full = max(filter.inside_q10, 0) + 64;
    for (View& other : others) {
      other.next = 0;
    }
    const ShapeField field(*own.shape);
    const Place from = own.row(line);
    PixelRun run(sink, y);
    for (int32_t column = max(sink.window.x0 - box.x0, 0); column < end;) {
      const int32_t distance = own.distance(field, from, column);
      if (distance < blank) {
        column += 1 + ((blank - distance) >> 10);
        continue;
      }
      const int32_t x = box.x0 + column;
      int32_t bulge =
          around + at_wall(0, x - walls.x0) + at_wall(2, walls.x1 - 1 - x);
      const int32_t cut = cut_of(distance, column, line, bulge);
      // A step of one pixel lessens the depth by at most 1 px.
      const int32_t deep = min(distance, cut) - full;
      if (deep > 0) {
        const int32_t last = min(column + 1 + (deep >> 10), end);
        run.fill(x, box.x0 + last);
        column = last;
      } else {
        run.add(x, filter.coverage(min(distance + min(bulge, limit), cut)));
        ++column;
      }
    }
    run.flush();
  }
};

// Not inline: rows need the stack.
__attribute__((noinline)) void set_views(Span<const Body> bodies,
                                         size_t index,
                                         BodyPainter& painter) noexcept {
  const Body& body = bodies[index];
  const Rect& box = painter.box;
  look_at(body, box.x0, box.y0, painter.own);
  int32_t swell_q10 = 0;
  for (const BodyTouch& touch : body.touches) {
    swell_q10 = min(swell_q10 + touch.swell_q8 * 4, kMostSwellQ10);
    if (touch.with < bodies.size && touch.with != index &&
        bodies[touch.with].shape != nullptr) {
      View& other = painter.others[painter.count++];
      look_at(bodies[touch.with], box.x0, box.y0, other);
      other.bulge_q10 = static_cast<int16_t>(touch.bulge_q6 * 16);
    } else if (touch.with >= BodyTouch::kWalls &&
               touch.with < BodyTouch::kWalls + 4) {
      painter.wall_bulges_q6[touch.with - BodyTouch::kWalls] = touch.bulge_q6;
    }
  }
  painter.own.bulge_q10 = static_cast<int16_t>(swell_q10);
}

}  // namespace

void draw_body(Span<const Body> bodies,
               size_t index,
               const BodyRules& rules,
               const Filter& filter,
               const Sink& sink) noexcept {
  if (bodies[index].shape == nullptr) {
    return;
  }
  const Rect walls = intersect(rules.walls, {-8191, -8191, 8191, 8191});
  const Rect box = intersect(box_of(bodies[index]), walls);
  const Rect part = intersect(box, sink.window);
  if (is_empty(part)) {
    return;
  }
  BodyPainter painter = {{}, {}, 0, {}, walls, box, filter};
  set_views(bodies, index, painter);
  for (int32_t y = part.y0; y < part.y1; ++y) {
    painter.draw_row(y, sink);
  }
}

}  // namespace inkcell::simulation
