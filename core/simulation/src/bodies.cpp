// Sequential impulses (Guendelman et al. 2003; Catto 2005). Speeds are solved
// before positions, so that energy does not grow.
// Over 400 lines: the solver, and the step that it works for.
#include "inkcell/simulation/bodies.hpp"

#include "inkcell/simulation/body_contacts.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kRounds = 8;  // of impulses over all contacts
constexpr int32_t kMostSpeedQ16 = kMostBodySpeed << 16;
// Contacts that are slower than this plus the gravity of a step do not bounce.
// [px a step, Q16]
constexpr int32_t kBouncesQ16 = 1 << 13;
constexpr int32_t kMostPlaceQ16 = 8191 << 16;

bool takes_part(const Body& body) noexcept {
  return body.shape != nullptr && !body.is_fixed && !body.is_asleep();
}

// Inverse mass and inertia. [Q30 / px^2, Q20 / px^2]
struct InverseMass {
  int32_t mass;     // 1 / mass
  int32_t inertia;  // 1 / gyration
};

InverseMass inverse_of(const Body& body) noexcept {
  if (!takes_part(body)) {
    return {0, 0};
  }
  return {body.shape->per_area_q30(), body.shape->per_gyration_q20()};
}

void limit_speeds(Body& body) noexcept {
  const int32_t most = kMostSpeedQ16 / 2;  // by turning
  body.x_speed.raw = clamp(body.x_speed.raw, -kMostSpeedQ16, kMostSpeedQ16);
  body.y_speed.raw = clamp(body.y_speed.raw, -kMostSpeedQ16, kMostSpeedQ16);
  const int32_t spin =
      body.shape == nullptr ? most << 4 : body.shape->per_radius_q23();
  body.spin_q20 = clamp(body.spin_q20, -spin, spin);
}

void limit(Body& body) noexcept {
  body.x.raw = clamp(body.x.raw, -kMostPlaceQ16, kMostPlaceQ16);
  body.y.raw = clamp(body.y.raw, -kMostPlaceQ16, kMostPlaceQ16);
  limit_speeds(body);
}

// Applies an impulse along (nx, ny), with its arm. [px a step px^2]
void push(Body& body,
          const InverseMass& inverse,
          int64_t pushed_q16,
          int32_t nx,
          int32_t ny,
          int32_t arm) noexcept {
  if (inverse.mass == 0) {
    return;
  }
  // Below 2^22 px a step, Q16: an impulse is limited by the one for spins.
  const int32_t gain = clamp_i64((pushed_q16 * inverse.mass + (1 << 29)) >> 30,
                                 -(1 << 22), 1 << 22);
  body.x_speed.raw += scaled(int64_t{gain} * nx, 14);
  body.y_speed.raw += scaled(int64_t{gain} * ny, 14);
  body.spin_q20 += clamp_i64(
      ((int64_t{gain} * arm >> 4) * inverse.inertia + (1 << 19)) >> 20,
      -(1 << 28), 1 << 28);
  limit_speeds(body);
}

// The effective mass at a contact. [px^2, Q8]
int32_t mass_at(const InverseMass& a,
                int32_t a_arm,
                const InverseMass& b,
                int32_t b_arm) noexcept {
  const auto inverse_at = [](const InverseMass& inverse, int32_t arm) {
    const int64_t turn = (int64_t{arm} * arm >> 16) * inverse.inertia;
    const int64_t both = (1 << 20) + clamp_i64(turn, 0, 1 << 30);
    return (both * inverse.mass) >> 20;
  };
  const int64_t sum = inverse_at(a, a_arm) + inverse_at(b, b_arm);
  if (sum == 0) {
    return 0;
  }
  return clamp_i64((int64_t{1} << 38) / sum, 1, 1 << 28);
}

// Solves one piece of a step.
struct Solver {
  Span<Body> bodies;
  const BodyRules& rules;
  Span<BodyContact> contacts;

  Body* second_of(const BodyContact& contact) const noexcept {
    return contact.second == BodyContact::kWall ? nullptr
                                                : &bodies[contact.second];
  }
  // The speed along (nx, ny) at which both move apart. [px a step, Q16]
  int32_t speed_along(const BodyContact& contact,
                      int32_t nx,
                      int32_t ny,
                      int32_t first_arm,
                      int32_t second_arm) const noexcept {
    const Body& a = bodies[contact.first];
    int32_t x = a.x_speed.raw;
    int32_t y = a.y_speed.raw;
    int64_t spun = int64_t{a.spin_q20} * first_arm;
    if (const Body* b = second_of(contact)) {
      x -= b->x_speed.raw;
      y -= b->y_speed.raw;
      spun -= int64_t{b->spin_q20} * second_arm;
    }
    return scaled(int64_t{x} * nx + int64_t{y} * ny, 14) + scaled(spun, 12);
  }

  void push_both(const BodyContact& contact,
                 int64_t pushed,
                 bool is_tangent) const noexcept {
    const int32_t nx = is_tangent ? -contact.ny : contact.nx;
    const int32_t ny = is_tangent ? contact.nx : contact.ny;
    Body& a = bodies[contact.first];
    push(a, inverse_of(a), pushed, nx, ny,
         is_tangent ? contact.first_tangent : contact.first_normal);
    if (Body* b = second_of(contact)) {
      push(*b, inverse_of(*b), -pushed, nx, ny,
           is_tangent ? contact.second_tangent : contact.second_normal);
    }
  }

  int32_t normal_speed(const BodyContact& c) const noexcept {
    return speed_along(c, c.nx, c.ny, c.first_normal, c.second_normal);
  }
  void prepare(BodyContact& contact) const noexcept {
    const InverseMass a = inverse_of(bodies[contact.first]);
    InverseMass b = {0, 0};
    if (const Body* second = second_of(contact)) {
      b = inverse_of(*second);
    }
    contact.normal_mass =
        mass_at(a, contact.first_normal, b, contact.second_normal);
    contact.tangent_mass =
        mass_at(a, contact.first_tangent, b, contact.second_tangent);
    contact.pushed = 0;
    contact.rubbed = 0;
    const int32_t closing = -normal_speed(contact);
    const int32_t bounces = kBouncesQ16 + 2 * abs(rules.gravity.raw);
    contact.leaves_q16 =
        closing > bounces ? closing * clamp(rules.bounce_q8, 0, 256) / 256 : 0;
  }

  // The impulse along the tangent that stops slipping, as far as one across can
  // hold it.
  int64_t rub(const BodyContact& contact,
              int64_t rubbed,
              int64_t pushed) const noexcept {
    const int32_t slips =
        speed_along(contact, -contact.ny, contact.nx, contact.first_tangent,
                    contact.second_tangent);
    const int64_t most = (pushed * rules.friction_q8) >> 8;
    const int64_t wanted =
        rubbed - (int64_t{slips} * contact.tangent_mass >> 8);
    return wanted > most ? most : wanted < -most ? -most : wanted;
  }

  // A damped spring at a soft contact. Four contacts share a mass.
  void spring(const BodyContact& contact) const noexcept {
    if (contact.soft_q10 <= 0) {
      return;
    }
    const int32_t gain =
        scaled(int64_t{contact.soft_q10} * rules.stiffness_q16, 10) -
        scaled(int64_t{normal_speed(contact)} * rules.damping_q16, 16);
    if (gain > 0) {
      const int64_t pushed = int64_t{gain} * contact.normal_mass >> 9;
      push_both(contact, pushed, false);
      push_both(contact, rub(contact, 0, pushed), true);
    }
  }

  // Not inline: with it the frame of solve_all() is large.
  __attribute__((noinline)) void solve(BodyContact& contact) const noexcept {
    if (contact.gap_q10 >= kTouchQ10) {
      return;  // soft only
    }
    const int64_t wanted = contact.leaves_q16 - int64_t{normal_speed(contact)};
    if (wanted <= 0 && contact.pushed == 0 && contact.rubbed == 0) {
      return;
    }
    const int64_t pushed = contact.pushed + (wanted * contact.normal_mass >> 8);
    const int64_t kept = pushed > 0 ? pushed : 0;
    if (kept != contact.pushed) {
      push_both(contact, kept - contact.pushed, false);
      contact.pushed = kept;
    }
    const int64_t held = rub(contact, contact.rubbed, kept);
    if (held != contact.rubbed) {
      push_both(contact, held - contact.rubbed, true);
      contact.rubbed = held;
    }
  }

  // Moves rigid bodies that overlap apart, by half of the overlap, at most 1
  // px; off a wall by all of it, at most 2 px.
  void separate(const BodyContact& contact) const noexcept {
    if (contact.gap_q10 >= 0) {
      return;
    }
    const int32_t step_q16 = min(-contact.gap_q10, 2048) *
                             (contact.second == BodyContact::kWall ? 64 : 32);
    const int64_t pushed = int64_t{step_q16} * contact.normal_mass >> 8;
    const auto move = [&](Body& body, int64_t by) {
      const InverseMass inverse = inverse_of(body);
      const int32_t step =
          clamp_i64((by * inverse.mass + (1 << 29)) >> 30, -step_q16, step_q16);
      body.x.raw += scaled(int64_t{step} * contact.nx, 14);
      body.y.raw += scaled(int64_t{step} * contact.ny, 14);
    };
    move(bodies[contact.first], pushed);
    if (Body* b = second_of(contact)) {
      move(*b, -pushed);
    }
  }
};

// The kinetic energy, and the part from the change of speeds in this piece.
// [mass px^2 / step^2, Q24, twice]
struct Energy {
  int64_t motion;
  int64_t change;
};

Energy energy_of(Span<const Body> bodies) noexcept {
  Energy sum = {0, 0};
  for (const Body& body : bodies) {
    if (!takes_part(body)) {
      continue;
    }
    const BodyShape& shape = *body.shape;
    // Speeds are below 2^17, areas 2^18, squares of spins 2^34 / radius^2.
    const auto add = [&](int64_t x, int64_t y, int64_t spin, int64_t& to) {
      const int64_t turns = (spin * spin >> 8) * shape.gyration_q8() >> 8;
      to += ((x * x + y * y + turns) >> 4) * shape.area();
    };
    add(body.x_speed.raw >> 4, body.y_speed.raw >> 4, body.spin_q20 >> 4,
        sum.motion);
    add((body.x_speed.raw - body.x_speed_before) >> 4,
        (body.y_speed.raw - body.y_speed_before) >> 4,
        (body.spin_q20 - body.spin_before) >> 4, sum.change);
  }
  return sum;
}

// Impulses over all contacts. Bounces of several contacts at once may add
// energy: all impulses are then scaled by the factor that restores it (E + t b
// + t^2 a with t = -b / a). Not inline: the frame of step() is large.
__attribute__((noinline)) void solve_all(const Solver& solver) noexcept {
  if (solver.contacts.size == 0) {
    return;
  }
  for (Body& body : solver.bodies) {
    body.x_speed_before = body.x_speed.raw;
    body.y_speed_before = body.y_speed.raw;
    body.spin_before = body.spin_q20;
  }
  const int64_t before = energy_of(solver.bodies).motion;
  for (int32_t round = 0; round < kRounds; ++round) {
    // Walls are the last of each body: what they hold is held at the end.
    for (size_t i = solver.contacts.size; i > 0; --i) {
      solver.solve(solver.contacts[i - 1]);
    }
  }
  const Energy after = energy_of(solver.bodies);
  if (after.motion <= before || after.change == 0) {
    return;
  }
  const int64_t lost = after.change - (after.motion - before);  // -b
  const int64_t unit = after.change < 1024 ? 1 : after.change >> 10;
  const int32_t part_q10 = clamp_i64(lost / unit, 0, 1024);
  const auto less = [&](int32_t from, int32_t to) {
    return from + scaled(int64_t{to - from} * part_q10, 10);
  };
  for (Body& body : solver.bodies) {
    body.x_speed.raw = less(body.x_speed_before, body.x_speed.raw);
    body.y_speed.raw = less(body.y_speed_before, body.y_speed.raw);
    body.spin_q20 = less(body.spin_before, body.spin_q20);
  }
}

// Sets the piece of each body: the longest in which it moves clear_q10 at most,
// and no two that touch move farther than slide_q10() against each other.
// Bodies that touch have the same piece; they do not hold up others. [step,
// Q16]
__attribute__((noinline)) void set_pieces(const Solver& solver) noexcept {
  const auto limit_by = [](Body& body, int32_t clear_q10, int32_t speed) {
    const int64_t distance = int64_t{clear_q10} << 22;
    if (int64_t{speed} * body.piece_q16 > distance) {
      body.piece_q16 = max(static_cast<int32_t>(distance / speed), 1);
    }
  };
  for (Body& body : solver.bodies) {
    body.piece_q16 = 0;
    if (takes_part(body)) {
      body.piece_q16 = body.left_q16;
      limit_by(body, body.clear_q10, speed_of(body));
    }
  }
  for (const BodyContact& contact : solver.contacts) {
    if (Body* second = solver.second_of(contact)) {
      // Where both overlap, the sum is what they may.
      const int32_t overlap = contact.soft_q10 + max(contact.gap_q10, 0);
      const int32_t clear = max(contact.gap_q10, slide_q10(overlap));
      Body& first = solver.bodies[contact.first];
      const int32_t speed = first.piece_q16 == 0 ? speed_of(*second)
                            : second->piece_q16 == 0
                                ? speed_of(first)
                                : speed_between(first, *second);
      limit_by(first, clear, speed);
      limit_by(*second, clear, speed);
    }
  }
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const BodyContact& contact : solver.contacts) {
      if (Body* second = solver.second_of(contact)) {
        Body& first = solver.bodies[contact.first];
        if (first.piece_q16 != second->piece_q16 && first.piece_q16 != 0 &&
            second->piece_q16 != 0) {
          first.piece_q16 = second->piece_q16 =
              min(first.piece_q16, second->piece_q16);
          has_changed = true;
        }
      }
    }
  }
}

void advance(Body& body) noexcept {
  const int32_t piece_q16 = body.piece_q16;
  body.x.raw += scaled(int64_t{body.x_speed.raw} * piece_q16, 16);
  body.y.raw += scaled(int64_t{body.y_speed.raw} * piece_q16, 16);
  // A radian is 1 / (2 pi) turn: 10430 / 2^16. [Q20 -> Q32]
  const int64_t turned = int64_t{body.spin_q20} * piece_q16 >> 16;
  body.turn_q32 += static_cast<uint32_t>(turned * 10430 >> 4);
  limit(body);
}

// Returns whether a body will have yet to move after this piece. Not inline:
// the search for contacts needs the stack.
__attribute__((noinline)) bool solve_piece(const Solver& solver,
                                           bool is_first) noexcept {
  const Span<BodyContact> contacts = solver.contacts;
  for (BodyContact& contact : contacts) {
    if (contact.gap_q10 < kTouchQ10 || contact.soft_q10 > 0) {
      solver.prepare(contact);
    }
  }
  // Springs first, so that hard contacts hold what they push.
  for (size_t i = is_first ? contacts.size : 0; i > 0; --i) {
    solver.spring(contacts[i - 1]);
  }
  solve_all(solver);
  set_pieces(solver);
  bool is_left = false;
  for (Body& body : solver.bodies) {
    if (body.piece_q16 > 0) {
      body.left_q16 -= body.piece_q16;
      is_left = is_left || body.left_q16 > 0;
    }
  }
  return is_left;
}

__attribute__((noinline)) void move_all(const Solver& solver) noexcept {
  for (size_t i = solver.contacts.size; i > 0; --i) {
    solver.separate(solver.contacts[i - 1]);
  }
  for (Body& body : solver.bodies) {
    if (body.piece_q16 > 0) {
      advance(body);
    }
  }
}

// A damped spring: the fall that a body has lost in a step, if it is more than
// `least_q16`, sets it off.
void spring_back(Body& body, int32_t gain_q14, int32_t least_q16) noexcept {
  constexpr int32_t kStiffness = 400;  // [Q14]
  constexpr int32_t kDamping = 1800;
  constexpr int32_t kMostSpeed = 1750;  // which squashes by 18 %
  const int32_t lost_q16 =
      takes_part(body) ? body.fall_q16 - body.y_speed.raw : 0;
  int32_t speed = body.squash_speed_q14;
  if (lost_q16 > least_q16) {
    speed += min((lost_q16 >> 4) * gain_q14 >> 12, kMostSpeed);
  }
  speed = clamp(speed, -kMostSpeed, kMostSpeed);
  const int32_t now = clamp(body.squash.raw, 0, Body::kMostSquashQ14);
  // Stiffer on the way in, which takes two frames.
  const int32_t stiff = speed > 0 ? 2 : 1;
  speed -= (now * kStiffness * stiff * stiff + speed * kDamping * stiff) >> 14;
  const int32_t next = min(now + speed, Body::kMostSquashQ14);
  body.squash.raw = static_cast<int16_t>(max(next, 0));
  body.squash_speed_q14 = static_cast<int16_t>(next > 0 ? speed : 0);
}

// Limits all values, gives each body its time, and applies gravity.
__attribute__((noinline)) void begin_step(Span<Body> bodies,
                                          const BodyRules& rules) noexcept {
  for (Body& body : bodies) {
    limit(body);
    body.left_q16 = 1 << 16;
    if (takes_part(body)) {
      body.y_speed.raw += is_empty(rules.walls) ? 0 : rules.gravity.raw;
      body.fall_q16 = body.y_speed.raw;
    } else if (body.shape != nullptr) {
      body.x_speed = body.y_speed = {};
      body.spin_q20 = 0;
    }
  }
}

}  // namespace

void step(Span<Body> all,
          const BodyRules& asked,
          Span<BodyContact> room) noexcept {
  const Span<Body> bodies(all.data,
                          all.size < kMostBodies ? all.size : kMostBodies);
  BodyRules rules = asked;
  rules.walls = intersect(asked.walls, {-8191, -8191, 8191, 8191});
  rules.gravity.raw = clamp(asked.gravity.raw, -(1 << 17), 1 << 17);
  rules.overlap.raw = static_cast<int16_t>(clamp(asked.overlap.raw, 0, 8192));
  begin_step(bodies, rules);
  if (is_empty(rules.walls)) {
    return;
  }
  const int32_t still_q16 = 8000 + 2 * abs(rules.gravity.raw);
  const int32_t most = clamp(rules.pieces, 1, BodyRules::kMostPieces);
  bool is_left = true;
  for (int32_t piece = 0; piece < most && is_left; ++piece) {
    const size_t count = find_contacts(bodies, rules, still_q16, room);
    const Solver solver = {bodies, rules, {room.data, count}};
    is_left = solve_piece(solver, piece == 0);
    if (rules.is_drawn && (!is_left || piece + 1 == most)) {
      for (Body& body : bodies) {
        body.left_q16 = 1 << 16;  // all have touches
      }
      find_touches(bodies, rules);
    }
    move_all(solver);
  }
  for (Body& body : bodies) {
    spring_back(body, min(rules.squash_q14, 1 << 13), 2 * still_q16);
    if (takes_part(body)) {
      const bool is_still = speed_of(body) <= still_q16;
      body.still_steps =
          is_still ? static_cast<uint8_t>(body.still_steps + 1) : uint8_t{0};
    }
  }
}

bool are_asleep(Span<const Body> bodies) noexcept {
  for (const Body& body : bodies) {
    if (takes_part(body)) {
      return false;
    }
  }
  return true;
}

Rect box_of(const Body& body) noexcept {
  if (body.shape == nullptr) {
    return {};
  }
  const int32_t x = body.x.raw >> 16;
  const int32_t y = body.y.raw >> 16;
  // A squash of q makes a body wider by q / (1 - q), at most 4/3 q.
  const int32_t flat = clamp(body.squash.raw, 0, Body::kMostSquashQ14);
  const int32_t wider = (body.shape->radius() * flat / 3 + 4095) >> 12;
  // With a bulge, a swell and half of an edge's ramp.
  const int32_t radius = body.shape->radius() + wider + 3 +
                         (1 << min(body.shape->grid().scale_log2(), 1));
  return {x - radius, y - radius, x + radius + 1, y + radius + 1};
}

}  // namespace inkcell::simulation
