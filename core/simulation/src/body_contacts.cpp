// Broad phase: circles. Narrow phase: the points of each body in the distances
// of the other. At most four contacts of a pair are kept: the outermost to both
// sides, and the deepest of each side that faces.
#include "inkcell/simulation/body_contacts.hpp"

#include "body_look.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

// Bodies nearer than two samples are examined: they may meet by their bulges.
// [px, Q10]
int32_t near_q10(const Body& body) noexcept {
  return 2048 << body.shape->grid().scale_log2();
}

// Whether the body stays where it is in the piece at hand. A sleeper may wake.
bool stays(const Body& body) noexcept {
  return body.is_fixed || (!body.is_asleep() && body.left_q16 == 0);
}

// How much farther a squashed body is drawn, at most. [px, Q10]
int32_t wider_q10(const Body& body) noexcept {
  const int32_t flat =
      clamp(body.squash.raw + body.squash_speed_q14, 0, Body::kMostSquashQ14);
  return body.shape->radius() * flat / 12;  // 4/3 of it
}

// Whether the body moves in the piece at hand.
bool moves(const Body& body) noexcept {
  return !body.is_fixed && !body.is_asleep() && body.left_q16 > 0;
}

// The arm of a force along n is r_y n_x - r_x n_y: turns are counter-clockwise,
// y is down. Not inline: a third of emit() on Cortex-M0.
__attribute__((noinline)) int32_t arm(int32_t r_x,
                                      int32_t r_y,
                                      int32_t n_x,
                                      int32_t n_y) noexcept {
  return scaled(int64_t{r_y} * n_x - int64_t{r_x} * n_y, 14);
}

// The search for contacts of all bodies.
struct Finder {
  Span<Body> bodies;
  Span<BodyContact> contacts;
  const BodyRules& rules;
  int32_t still_q16;
  bool is_drawn;        // sets touches; otherwise finds contacts
  int32_t overlap_q10;  // of the pair at hand
  size_t count;

  // Distances above it touch hard. [px, Q10]
  int32_t hard_q10() const noexcept { return overlap_q10 - kTouchQ10; }
  int32_t overlap_of(const Body& body) const noexcept {
    return min(rules.overlap.raw, body.shape->depth_q10() / 3) - kSkinQ10;
  }
  // Limits clear_q10 of a body to its share of a gap, at least of slide_q10().
  // The distance is above 0 where it overlaps.
  void note(Body& body, int32_t distance_q10, int32_t part_q8) const noexcept {
    const int32_t gap_q10 = min(overlap_q10 - distance_q10, kFarQ10);
    body.clear_q10 = min(body.clear_q10,
                         max(gap_q10, slide_q10(overlap_q10)) * part_q8 >> 8);
  }

  // A pair shares its distance in proportion to the speeds, at least an eighth
  // each, as a push may make the slow one fast.
  void note_pair(Body& a, Body& b, int32_t distance_q10) const noexcept {
    const int32_t both = a.most_speed_q16 + b.most_speed_q16 + 1;
    const int32_t part = 32 + a.most_speed_q16 / ((both >> 8) + 1) * 3 / 4;
    note(a, distance_q10, stays(b) ? 256 : part);
    note(b, distance_q10, stays(a) ? 256 : 256 - part);
  }

  // Bodies that do not touch, but fly side by side, are held apart by the speed
  // between them: the solver divides their step alike.
  void keep_apart(size_t first, size_t second, int32_t distance_q10) noexcept {
    Body& a = bodies[first];
    Body& b = bodies[second];
    const int32_t both = a.most_speed_q16 + b.most_speed_q16;
    const int32_t gap_q10 = max(overlap_q10 - distance_q10, kTouchQ10);
    if (moves(a) && moves(b) && gap_q10 < both >> 5 &&
        contacts.size - count > kContactsOfPair &&
        2 * speed_between(a, b) < both) {
      contacts[count] = {};
      contacts[count].first = static_cast<uint8_t>(first);
      contacts[count].second = static_cast<uint8_t>(second);
      contacts[count].gap_q10 = gap_q10;
      ++count;
      return;
    }
    note_pair(a, b, distance_q10);
  }

  // A sleeper wakes if a fast body touches it.
  void wake(Body& body, const Body& by) const noexcept {
    if (body.is_asleep() && by.most_speed_q16 > 2 * still_q16) {
      body.still_steps = 0;
      body.left_q16 = by.left_q16;
    }
  }

  // Forgets touches that will be examined.
  void forget(size_t index) const noexcept {
    const bool is_sought = moves(bodies[index]);
    for (BodyTouch& touch : bodies[index].touches) {
      if (is_sought ||
          (touch.with < bodies.size && moves(bodies[touch.with]))) {
        touch = BodyTouch();
      }
    }
  }

  // The area that a body has lost goes into a bulge around the contact, and
  // what exceeds the greatest bulge all around the body. [px^2, Q10]
  __attribute__((noinline)) void squash(Body& body,
                                        size_t with,
                                        int32_t lost_q10,
                                        const Sums& sums) const noexcept {
    const BodyShape& shape = *body.shape;
    const int32_t around_q10 = max(
        1,
        static_cast<int32_t>(int64_t{sums.room_q9} * shape.spacing_q5() >> 4));
    const int32_t bulge_q10 = min(lost_q10 * 1024 / around_q10,
                                  most_bulge_q10(shape.grid().scale_log2()));
    const int32_t length = sums.outside * shape.spacing_q5() >> 6;
    const int32_t left_q10 =
        lost_q10 -
        clamp_i64(int64_t{bulge_q10} * around_q10 >> 10, 0, lost_q10);
    BodyTouch* to = body.touches;
    for (BodyTouch& touch : body.touches) {
      if (touch.with == with) {
        to = &touch;
        break;
      }
      const bool is_less = touch.bulge_q6 < to->bulge_q6;
      if (to->with != BodyTouch::kNothing &&
          (touch.with == BodyTouch::kNothing || is_less)) {
        to = &touch;
      }
    }
    to->with = static_cast<uint8_t>(with);
    to->bulge_q6 = static_cast<uint8_t>(bulge_q10 >> 4);
    to->swell_q8 =
        static_cast<uint8_t>(min(left_q10 / max(length, 1) >> 2, 255));
  }

  // A neighbour that the body does not touch but as it is drawn.
  void meet(Body& body, size_t with) const noexcept {
    for (BodyTouch& touch : body.touches) {
      if (touch.with == BodyTouch::kNothing || touch.with == with) {
        touch.with = static_cast<uint8_t>(with);
        return;
      }
    }
  }

  // The memory of the candidates, all unused; null if there is too little.
  BodyContact* clean() const noexcept {
    if (contacts.size - count < kContactsOfPair) {
      return nullptr;
    }
    for (size_t i = 0; i < kContactsOfPair; ++i) {
      contacts[count + i].soft_q10 = -1;
    }
    return &contacts[count];
  }

  // Turns the candidates into contacts. (x_between, y_between): from the
  // second's centre to the first's. [px, Q8]
  void emit(size_t first,
            size_t second,
            int32_t x_between,
            int32_t y_between) noexcept {
    const BodyContact* kept = &contacts[count];
    int32_t ids[kContactsOfPair];
    for (size_t i = 0; i < kContactsOfPair; ++i) {
      ids[i] = kept[i].soft_q10;
      bool is_own = ids[i] >= 0;
      for (size_t k = 0; k < i; ++k) {
        is_own = is_own && ids[k] != ids[i];
      }
      if (!is_own) {
        continue;
      }
      const int32_t distance_q10 = kept[i].gap_q10;
      const int32_t x = kept[i].first_normal;
      const int32_t y = kept[i].first_tangent;
      int32_t nx = kept[i].nx;
      int32_t ny = kept[i].ny;
      BodyContact& contact = contacts[count++];
      contact.first = static_cast<uint8_t>(first);
      contact.second = static_cast<uint8_t>(second);
      contact.gap_q10 = overlap_q10 - distance_q10;
      contact.soft_q10 = clamp(distance_q10, 0, overlap_q10);
      auto length = static_cast<int32_t>(length_of(nx, ny));
      if (length < (1 << 13) / 8) {
        // No gradient: use the line between the centres.
        nx = x_between / 8;
        ny = y_between / 8;
        length = static_cast<int32_t>(length_of(nx, ny));
      }
      contact.nx = length == 0 ? 0 : nx * kOneQ14 / length;
      contact.ny = length == 0 ? -kOneQ14 : ny * kOneQ14 / length;
      contact.first_normal = arm(x, y, contact.nx, contact.ny);
      contact.first_tangent = arm(x, y, -contact.ny, contact.nx);
      contact.second_normal =
          arm(x + x_between, y + y_between, contact.nx, contact.ny);
      contact.second_tangent =
          arm(x + x_between, y + y_between, -contact.ny, contact.nx);
    }
  }

  // A frame of its own, as that of walls.
  __attribute__((noinline)) void find_pair(size_t first,
                                           size_t second) noexcept {
    Body& a = bodies[first];
    Body& b = bodies[second];
    if (!moves(a) && !moves(b)) {
      return;
    }
    // Positions are within 2^13 px: 32 bits hold the difference.
    const int32_t x_between = (a.x.raw - b.x.raw) >> 8;
    const int32_t y_between = (a.y.raw - b.y.raw) >> 8;
    const int32_t radii = a.shape->radius() + b.shape->radius();
    // Less 1/32: below the distance between the centres.
    const int32_t rough = near_length(abs(x_between), abs(y_between));
    const int32_t apart_q10 = (rough - (rough >> 5) - (radii << 8)) * 4;
    overlap_q10 = min(overlap_of(a), overlap_of(b));
    const int32_t near = max(near_q10(a), near_q10(b));
    const int32_t wider = wider_q10(a) + wider_q10(b);
    if (is_drawn && wider > 0 && apart_q10 < near + wider) {
      meet(a, second);
      meet(b, first);
    }
    if (apart_q10 >= near) {
      keep_apart(first, second, -apart_q10);
      return;
    }
    BodyContact* kept = clean();
    Look look = {&a, &b, x_between, y_between, true, hard_q10(), kept};
    Sums of_a = {-kFarQ10, is_drawn};
    look.find(of_a);
    Sums of_b = {of_a.most, is_drawn};
    if (of_a.most > -near) {
      look.from = &b;
      look.into = &a;
      look.is_first = false;
      look.find(of_b);
    }
    if (is_drawn && of_b.most > -near && rules.overlap.raw > 0) {
      // The common area is between the sums of both; each loses half of it.
      const int64_t sum = int64_t{of_a.lost_q6} * a.shape->spacing_q5() +
                          int64_t{of_b.lost_q6} * b.shape->spacing_q5();
      const int32_t lost_q10 = clamp_i64(sum >> 3, 0, (1 << 21) - 1);
      squash(a, second, lost_q10, of_a);
      squash(b, first, lost_q10, of_b);
    }
    if (kept == nullptr || kept->soft_q10 < 0) {
      keep_apart(first, second, of_b.most);
      return;
    }
    wake(a, b);
    wake(b, a);
    emit(first, second, x_between, y_between);
  }

  // Walls: left, top, right, bottom.
  __attribute__((noinline)) void find_wall(size_t index,
                                           int32_t wall) noexcept {
    Body& body = bodies[index];
    const bool is_across = wall % 2 == 0;  // bounds x
    const int32_t sign = wall < 2 ? -1 : 1;
    const Rect& walls = rules.walls;
    const int32_t bounds[] = {walls.x0, walls.y0, walls.x1, walls.y1};
    // The distance of the centre beyond the wall. [px, Q10]
    const int32_t centre =
        sign *
        (((is_across ? body.x.raw : body.y.raw) >> 6) - bounds[wall] * 1024);
    const int32_t nearest = centre + (body.shape->radius() << 10);
    overlap_q10 = overlap_of(body);
    if (nearest <= -near_q10(body)) {
      note(body, nearest, 256);
      return;
    }
    const Turn turn = turn_of(body.angle());
    BodyContact* kept = clean();
    Sums sums = {-kFarQ10, is_drawn};
    int32_t id = 0;
    for (const BodyPoint& point : body.shape->points()) {
      ++id;
      const int32_t x = turned_x(turn, point.x_q5, point.y_q5) >> 11;
      const int32_t y = turned_y(turn, point.x_q5, point.y_q5) >> 11;
      const int32_t distance = centre + sign * (is_across ? x : y) * 4;
      sums.add(distance, static_cast<size_t>(id) <= body.shape->corner_count(),
               body.shape->grid().scale_log2());
      if (distance <= min(hard_q10(), 0) || kept == nullptr) {
        continue;
      }
      const Touch touch = {id,
                           distance,
                           x,
                           y,
                           is_across ? -sign * (1 << 13) : 0,
                           is_across ? 0 : -sign * (1 << 13),
                           is_across ? y : x};
      add_touch(kept, touch, hard_q10(), true);
    }
    note(body, sums.most, 256);
    if (is_drawn && sums.lost_q6 > 0 && rules.overlap.raw > 0) {
      const int64_t lost = int64_t{sums.lost_q6} * body.shape->spacing_q5();
      squash(body, BodyTouch::kWalls + static_cast<size_t>(wall),
             clamp_i64(lost >> 1, 0, (1 << 21) - 1), sums);
    }
    if (kept != nullptr) {
      emit(index, BodyContact::kWall, 0, 0);
    }
  }

  __attribute__((noinline)) void find_all() noexcept {
    for (size_t i = 0; i < bodies.size; ++i) {
      if (bodies[i].shape == nullptr) {
        continue;
      }
      for (int32_t wall = 0; wall < 4 && moves(bodies[i]); ++wall) {
        find_wall(i, wall);
      }
      for (size_t k = 0; k < i; ++k) {
        if (bodies[k].shape != nullptr) {
          find_pair(i, k);
        }
      }
    }
  }
};

// An upper bound of a length, at most 6 % above it.
int32_t length_above(int32_t x, int32_t y) noexcept {
  const int32_t near = near_length(abs(x), abs(y));
  return near + (near >> 5) + 1;
}

// The speed of the edge by spin. [px a step, Q16]
int32_t edge_speed(const Body& body) noexcept {
  const int64_t spun = int64_t{abs(body.spin_q20)} * body.shape->radius() >> 4;
  return clamp_i64(spun, 0, 1 << 28);
}

}  // namespace

int32_t speed_of(const Body& body) noexcept {
  return length_above(body.x_speed.raw, body.y_speed.raw) + edge_speed(body);
}

int32_t speed_between(const Body& a, const Body& b) noexcept {
  return length_above(a.x_speed.raw - b.x_speed.raw,
                      a.y_speed.raw - b.y_speed.raw) +
         edge_speed(a) + edge_speed(b);
}

size_t find_contacts(Span<Body> bodies,
                     const BodyRules& rules,
                     int32_t still_q16,
                     Span<BodyContact> contacts) noexcept {
  for (Body& body : bodies) {
    body.clear_q10 = kFarQ10;
    body.most_speed_q16 = body.shape == nullptr ? 0 : speed_of(body);
  }
  Finder finder = {bodies, contacts, rules, still_q16, false, 0, 0};
  finder.find_all();
  return finder.count;
}

void find_touches(Span<Body> bodies, const BodyRules& rules) noexcept {
  Finder finder = {bodies, {}, rules, 0, true, 0, 0};
  // Pairs that do not move are not examined: they keep their touches.
  for (size_t i = 0; i < bodies.size; ++i) {
    finder.forget(i);
  }
  finder.find_all();
}

}  // namespace inkcell::simulation
