// Bodies: mass, contacts against exact polygons, shots, energy, sleep, and the
// lines where soft ones meet.
#include "body_models.hpp"
#include "check.hpp"
#include "ink.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/simulation/bodies.hpp"
#include "inkcell/simulation/body_draw.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

/// How many shots are fired: on boards few (CMakeLists.txt).
#ifndef INKCELL_SHOTS
#  define INKCELL_SHOTS 60
#endif

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using namespace body_models;

constexpr int32_t kOne = 1 << 16;
constexpr size_t kCount = 10;
constexpr Rect kRoom = {0, 0, 200, 180};

Body bodies[kCount];
BodyContact contacts[4 * 40];
Picture<64, 64> picture[2];

int32_t worst_overlap() {
  int32_t most = 0;
  for (size_t i = 0; i < kCount; ++i) {
    const Edges a = edges_of(bodies[i]);
    for (size_t k = 0; k < i; ++k) {
      const Rect common = intersect(box_of(bodies[i]), box_of(bodies[k]));
      if (is_empty(common)) {
        continue;
      }
      const Edges b = edges_of(bodies[k]);
      const int32_t one = overlap_of(a, b);
      const int32_t other = overlap_of(b, a);
      most = one > most ? one : most;
      most = other > most ? other : most;
    }
  }
  return most;
}

// In a room, at random angles and speeds.
void scatter(uint32_t seed, int32_t speed) {
  Random random(seed);
  for (size_t i = 0; i < kCount; ++i) {
    Body& body = bodies[i];
    body = Body();
    body.shape = &models[i % 3].shape;
    body.x = Q16_16::from_int(28 + static_cast<int32_t>(i % 4) * 48);
    body.y = Q16_16::from_int(30 + static_cast<int32_t>(i / 4) * 56);
    body.turn_q32 = random.next();
    body.x_speed.raw = random.between(-speed, speed);
    body.y_speed.raw = random.between(-speed, speed);
    body.spin_q20 = random.between(-40000, 40000);
  }
}

// Energy of motion and of height above the floor. [mass px^2 / step^2, Q24]
int64_t energy(int32_t gravity_q16) {
  int64_t sum = 0;
  for (const Body& body : bodies) {
    const int64_t x = body.x_speed.raw >> 4;
    const int64_t y = body.y_speed.raw >> 4;
    const int64_t spin = body.spin_q20 >> 4;
    const int64_t turns = (spin * spin >> 8) * body.shape->gyration_q8() >> 8;
    const int64_t height = kRoom.y1 * int64_t{kOne} - body.y.raw;
    sum += body.shape->area() *
           ((x * x + y * y + turns) / 2 + (height * gravity_q16 >> 8));
  }
  return sum;
}

// A board of 2 x 40 px, made without a font.
struct Board {
  int8_t samples[10 * 48];
  BodyPoint edge[64];
  BodyShape shape;

  Board() {
    DistanceGrid grid(samples, 10, 48, 0);
    for (const auto [x, y] : pixels_of(10, 48)) {
      const int32_t across = 32 - magnitude(2 * x - 9) * 16;
      const int32_t along = 20 * 32 - magnitude(2 * y - 47) * 16;
      const int32_t inside = across < along ? across : along;
      grid.row(y)[x] = static_cast<int8_t>(inside < -128 ? -128 : inside);
    }
    CHECK_OK(shape.make(grid, edge));
  }
};

Ink ink_of(size_t i, const BodyRules& rules) {
  Ink ink;
  draw_body(bodies, i, rules, kFilterMotion, ink.sink());
  return ink;
}

// Draws one of two bodies on its picture; returns its ink.
int32_t draw_pair(const BodyRules& rules, int i) {
  picture[i].clear();
  draw_body({bodies, 2}, static_cast<size_t>(i), rules, kFilterMotion,
            picture[i].sink());
  return picture[i].ink();
}

}  // namespace

TEST(shapes_weigh_what_they_are) {
  make_models();
  // The bar is 11.25 x 30 px.
  const BodyShape& bar = models[0].shape;
  CHECK(bar.area() >= 334 && bar.area() <= 341);
  const int32_t gyration_q8 = (45 * 45 * 16 + 30 * 30 * 256) / 12;
  CHECK(bar.gyration_q8() > gyration_q8 * 98 / 100);
  CHECK(bar.gyration_q8() < gyration_q8 * 102 / 100);
  const int32_t x = bar.centre_x().raw - (kLeft * kOne + 15 * kOne);
  const int32_t y = bar.centre_y().raw - (kBase - 15) * kOne;
  CHECK(x > -2000 && x < 2000 && y > -2000 && y < 2000);
  // Points are on edges.
  for (const Model& model : models) {
    Body body;
    body.shape = &model.shape;
    const Edges edges = edges_of(body);
    for (const BodyPoint& point : model.shape.points()) {
      CHECK(depth_in(edges, {point.x_q5 * 8, point.y_q5 * 8}) < 100);
    }
  }
  int8_t nothing[16] = {-128, -128, -128, -128, -128, -128, -128, -128,
                        -128, -128, -128, -128, -128, -128, -128, -128};
  BodyPoint room[8];
  BodyShape shape;
  CHECK(shape.make(DistanceGrid(nothing, 4, 4, 0), room) ==
        Status::bad_argument);
  CHECK(shape.make(models[0].shape.grid(), {room, 7}) == Status::buffer_small);
}

TEST(a_heap_comes_to_rest_without_overlaps) {
  make_models();
  BodyRules rules;
  rules.walls = kRoom;
  rules.gravity.raw = 2300;  // 500 px/s^2 at 120 steps/s
  scatter(5, 2 * kOne);
  int32_t most = 0;
  for (int32_t i = 0; i < 1400; ++i) {
    step(bodies, rules, contacts);
    if (i % 8 == 0) {
      const int32_t now = worst_overlap();
      most = now > most ? now : most;
    }
    for (const Body& body : bodies) {
      CHECK(body.x.raw > 0 && body.x.raw < kRoom.x1 * kOne);
      CHECK(body.y.raw < kRoom.y1 * kOne);
    }
  }
  check::write("deepest overlap [px / 256]: ");
  check::write_number(most);
  check::write("\n");
  CHECK(most <= 128);
  CHECK(are_asleep(bodies));
  Body before[kCount];
  for (size_t i = 0; i < kCount; ++i) {
    before[i] = bodies[i];
  }
  step(bodies, rules, contacts);
  for (size_t i = 0; i < kCount; ++i) {
    CHECK_EQ(bodies[i].x.raw, before[i].x.raw);
    CHECK_EQ(bodies[i].y.raw, before[i].y.raw);
  }
  // A shot wakes who it hits.
  bodies[0].still_steps = 0;
  bodies[0].y = Q16_16::from_int(-60);
  BodyRules open = rules;
  open.walls.y0 = -200;
  for (int32_t i = 0; i < 200; ++i) {
    step(bodies, open, contacts);
  }
  bool has_moved = false;
  for (size_t i = 1; i < kCount; ++i) {
    has_moved = has_moved || bodies[i].x.raw != before[i].x.raw;
  }
  CHECK(has_moved);
}

TEST(nothing_is_shot_through_a_thin_board) {
  make_models();
  static Board board;
  BodyRules rules;
  rules.walls = {0, 0, 160, 40};
  rules.bounce_q8 = 200;
  Rounds rounds(77, INKCELL_SHOTS);
  for (Random& random : rounds) {
    bodies[0] = Body();
    bodies[0].shape = &board.shape;
    bodies[0].is_fixed = true;
    bodies[0].x = Q16_16::from_int(80);
    bodies[0].y = Q16_16::from_int(20);
    bodies[1] = Body();
    bodies[1].shape = &models[rounds.number % 2].shape;
    bodies[1].x = Q16_16::from_int(40);
    bodies[1].y = Q16_16::from_int(20);
    bodies[1].turn_q32 = random.next();
    bodies[1].x_speed.raw = random.between(kOne / 16, 16 * kOne);
    bodies[1].y_speed.raw = random.between(-2 * kOne, 2 * kOne);
    bodies[1].spin_q20 = random.between(-300000, 300000);
    for (int32_t i = 0; i < 20; ++i) {
      step({bodies, 2}, rules, contacts);
      CHECK(bodies[1].x.raw < 80 * kOne && bodies[1].x.raw > 0);
    }
  }
}

// Two letters are thrown up side by side, 3 px apart, while others hit each
// other far away: each flight is the parabola of its start.
TEST(flights_do_not_depend_on_others) {
  make_models();
  BodyRules rules;
  rules.walls = {0, -400, 1100, 180};
  rules.gravity.raw = 4000;
  rules.pieces = 8;
  scatter(5, 6 * kOne);
  for (size_t i = 2; i < kCount; ++i) {
    bodies[i].x = Q16_16::from_int(25 + static_cast<int32_t>(i % 2) * 40);
    bodies[i].y = Q16_16::from_int(20 + static_cast<int32_t>(i / 2) * 32);
  }
  for (int32_t i = 0; i < 2; ++i) {
    bodies[i] = Body();
    bodies[i].shape = &models[0].shape;
    bodies[i].x = Q16_16::from_int(1000 + 14 * i);
    bodies[i].y = Q16_16::from_int(150);
    bodies[i].y_speed = Q16_16::from_int(-8);
  }
  int32_t most = 0;
  for (int32_t i = 1; i <= 120; ++i) {
    step(bodies, rules, contacts);
    const int32_t y =
        (150 - 8 * i) * kOne + rules.gravity.raw * i * (i + 1) / 2;
    for (int32_t k = 0; k < 2; ++k) {
      CHECK_EQ(bodies[k].x.raw, (1000 + 14 * k) * kOne);
      const int32_t off = magnitude(bodies[k].y.raw - y);
      most = off > most ? off : most;
    }
  }
  CHECK(most < kOne / 256);
}

TEST(energy_does_not_grow) {
  make_models();
  const uint16_t kBounces[] = {256, 128};
  for (const uint16_t bounce : kBounces) {
    BodyRules rules;
    rules.walls = kRoom;
    rules.gravity.raw = 0;
    rules.bounce_q8 = bounce;
    rules.friction_q8 = bounce == 256 ? 0 : 100;
    scatter(9, kOne);
    const int64_t first = energy(0);
    int64_t before = first;
    int64_t gained = 0;
    for (int32_t i = 0; i < 1000; ++i) {
      step(bodies, rules, contacts);
      const int64_t now = energy(0);
      gained = now - before > gained ? now - before : gained;
      before = now;
    }
    check::write("energy after and most gained in a step [1/1000]: ");
    check::write_number(static_cast<int32_t>(before * 1000 / first));
    check::write(" ");
    check::write_number(static_cast<int32_t>(gained * 1000 / first));
    check::write("\n");
    CHECK(gained <= first / 200);
    CHECK(before <= first + first / 20);
  }
}

TEST(soft_bodies_meet_at_one_line) {
  make_models();
  BodyRules rules;
  rules.walls = {0, 0, 64, 64};
  rules.overlap.raw = 3 << 10;
  bodies[0] = Body();
  bodies[0].shape = &models[0].shape;
  bodies[0].x = Q16_16::from_int(26);
  bodies[0].y = Q16_16::from_int(30);
  bodies[1] = bodies[0];
  bodies[1].x.raw = 44 * kOne;
  bodies[1].y.raw = 34 * kOne;
  bodies[1].turn_q32 = 1u << 29;
  const int32_t ink[] = {draw_pair(rules, 0), draw_pair(rules, 1)};
  step({bodies, 2}, rules, contacts);
  for (int i = 0; i < 2; ++i) {
    CHECK_EQ(bodies[i].touches[0].with, 1 - i);
    CHECK(bodies[i].touches[0].bulge_q6 > 16);
    const int32_t now = draw_pair(rules, i);
    CHECK(now > ink[i] * 99 / 100 && now < ink[i] * 101 / 100);
  }
  int32_t shared = 0;
  for (const auto [x, y] : pixels_of(64, 64)) {
    const int32_t first = picture[0].at(x, y);
    const int32_t second = picture[1].at(x, y);
    CHECK(first + second <= 300);
    shared += first > 60 && second > 60 ? 1 : 0;
  }
  CHECK(shared >= 3);  // both end there
  // Strips, and parts of them, give the same picture.
  picture[1].clear();
  for (int32_t y = 0; y < 64; y += 5) {
    for (int32_t x = 0; x < 64; x += 20) {
      draw_body({bodies, 2}, 0, rules, kFilterMotion,
                picture[1].sink({x, y, x + 20, y + 5}));
    }
  }
  CHECK(picture[0] == picture[1]);
}

TEST(soft_bodies_keep_their_ink_on_the_floor) {
  make_models();
  BodyRules rules;
  rules.walls = {0, 0, 64, 64};
  rules.overlap.raw = 3 << 10;
  for (int i = 0; i < 2; ++i) {  // upright, and on a side
    bodies[i] = Body();
    bodies[i].shape = &models[1].shape;
    bodies[i].x = Q16_16::from_int(32);
    bodies[i].y = Q16_16::from_int(30);
    bodies[i].turn_q32 = static_cast<uint32_t>(i) << 30;
  }
  for (int i = 0; i < 2; ++i) {
    const int32_t ink = draw_pair(rules, i);
    Body& body = bodies[i];
    while (body.touches[0].with != BodyTouch::kWalls + 3) {
      body.y.raw += kOne / 2;
      CHECK(body.y.raw < 60 * kOne);
      step({&body, 1}, rules, contacts);
    }
    rules.gravity.raw = 16000;
    for (int frame = 0; frame < 40; ++frame) {
      step({&body, 1}, rules, contacts);
      const int32_t now = draw_pair(rules, i);
      CHECK(now > ink * 97 / 100 && now < ink * 103 / 100);
    }
    CHECK(body.touches[0].bulge_q6 > 16);
    rules.gravity = {};
  }
}

// By 15 to 25 % of the height, for 6 to 10 frames of two steps; the lowest line
// (but for its ramp) and the ink stay.
TEST(soft_bodies_are_squashed_where_they_fall) {
  make_models();
  BodyRules rules;
  rules.walls = {0, 0, 64, 64};
  rules.gravity.raw = 16000;
  rules.overlap.raw = 3 << 10;
  rules.stiffness_q16 = rules.damping_q16 = 16000;
  rules.squash_q14 = 160;
  for (int32_t turned = 0; turned < 4; ++turned) {
    Body& body = bodies[0];
    body = Body();
    body.shape = &models[2].shape;
    body.x = Q16_16::from_int(32);
    body.y = Q16_16::from_int(18);
    body.y_speed = Q16_16::from_int(9);
    body.turn_q32 = static_cast<uint32_t>(turned) << 30;
    int32_t most = 0;
    int32_t steps = 0;
    for (int32_t i = 0; i < 60 && (steps == 0 || body.squash.raw != 0); ++i) {
      step({&body, 1}, rules, contacts);
      const int32_t now = body.squash.raw;
      steps += now != 0 ? 1 : 0;
      most = now > most ? now : most;
      bodies[1] = body;
      bodies[1].squash = {};
      const Ink flat = ink_of(0, rules);
      const Ink whole = ink_of(1, rules);
      CHECK(magnitude(flat.sum - whole.sum) <= whole.sum * 4 / 100);
      CHECK(magnitude(flat.box.y1 - whole.box.y1) <= 1);
      const int32_t height = whole.box.y1 - whole.box.y0;
      const int32_t lower = flat.box.y0 - whole.box.y0;
      CHECK(magnitude(lower * 64 - height * now / 256) <= 64);
      const int32_t wider =
          flat.box.x1 - flat.box.x0 - (whole.box.x1 - whole.box.x0);
      CHECK(now < (1 << 14) / 10 || wider >= 2);
    }
    CHECK(most >= (1 << 14) * 15 / 100 && most <= (1 << 14) * 25 / 100);
    CHECK(steps >= 12 && steps <= 20);
  }
}

// A letter that is drawn wider than it is ends at those beside it, too.
TEST(squashed_bodies_do_not_cover_others) {
  make_models();
  BodyRules rules;
  rules.walls = {0, 0, 64, 64};
  rules.overlap.raw = 3 << 10;
  bodies[0] = Body();
  bodies[0].shape = &models[2].shape;
  bodies[0].x = Q16_16::from_int(17);
  bodies[0].y = Q16_16::from_int(30);
  bodies[1] = bodies[0];
  bodies[1].x = Q16_16::from_int(44);  // 3 px apart
  bodies[0].squash.raw = Body::kMostSquashQ14;
  step({bodies, 2}, rules, contacts);
  for (int i = 0; i < 2; ++i) {
    CHECK_EQ(bodies[i].touches[0].with, 1 - i);
    draw_pair(rules, i);
  }
  int32_t met = 0;
  for (const auto [x, y] : pixels_of(64, 64)) {
    const int32_t both = picture[0].at(x, y) + picture[1].at(x, y);
    CHECK(both <= 300);
    met += picture[0].at(x, y) > 20 && picture[1].at(x, y) > 20 ? 1 : 0;
  }
  CHECK(met > 0);
}
