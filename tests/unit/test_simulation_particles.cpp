// Particles: homes, edges, walls, bounces, and the dots that they are drawn as.
#include "check.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/simulation/dots.hpp"
#include "inkcell/simulation/particle_homes.hpp"
#include "inkcell/simulation/particles.hpp"
#include "outline_font.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::simulation;
using outline_record::sample_font;

constexpr int32_t kSide = 64;  // of the scene [px]
constexpr Rect kScreen = {0, 0, kSide, kSide};
constexpr int32_t kOne = 1 << 16;
constexpr uint16_t kDiscGlyph = 1;
constexpr uint16_t kBarGlyph = 2;
constexpr uint16_t kEllGlyph = 3;
constexpr size_t kCount = 40;

int8_t samples[kSide * kSide];
Particle particles[kCount];
ParticleHome homes[kCount];
Picture<kSide, kSide> picture;
Picture<kSide, kSide> second;

DistanceGrid grid_of(uint16_t glyph, int32_t size, int32_t scale_log2) {
  const int32_t side = DistanceGrid::samples_of(kSide, scale_log2);
  DistanceGrid grid(samples, side, side, scale_log2);
  grid.clear();
  CHECK_OK(grid.paint(sample_font(), glyph, Q26_6::from_int(size), {8, 52}));
  return grid;
}

void scatter(Random& random, const DistanceGrid& grid, int32_t side_sign) {
  for (Particle& p : particles) {
    do {
      p.x.raw = static_cast<int32_t>(random.below(kSide * kOne));
      p.y.raw = static_cast<int32_t>(random.below(kSide * kOne));
    } while (probe(grid, p.x, p.y).distance_q10 * side_sign > -1024);
    p.x_speed_q10 = static_cast<int16_t>(random.between(-9000, 9000));
    p.y_speed_q10 = static_cast<int16_t>(random.between(-9000, 9000));
  }
}

int64_t energy() {
  int64_t sum = 0;
  for (const Particle& p : particles) {
    sum += p.x_speed_q10 * p.x_speed_q10 + p.y_speed_q10 * p.y_speed_q10;
  }
  return sum;
}

}  // namespace

TEST(probes_are_distances_and_slopes) {
  // The bar from x = 200 to 440 u and y = 0 to 640 u at 64 px/em: from 20.5 to
  // 35.5 px, and from 12 to 52 px.
  for (int32_t scale = 0; scale <= 1; ++scale) {
    const DistanceGrid grid = grid_of(kBarGlyph, 64, scale);
    for (int32_t x_q8 = 17 << 8; x_q8 < 24 << 8; x_q8 += 37) {
      const GridPoint left =
          probe(grid, Q16_16::from_raw(x_q8 << 8), Q16_16::from_int(30));
      const int32_t expected = (x_q8 - (41 << 7)) * 4;
      const int32_t off = left.distance_q10 - expected;
      CHECK(off <= 34 << scale && off >= -(34 << scale));
      CHECK(left.x_slope_q13 > 7600 && left.x_slope_q13 < 8800);
      CHECK(left.y_slope_q13 < 300 && left.y_slope_q13 > -300);
    }
    const GridPoint top =
        probe(grid, Q16_16::from_int(28), Q16_16::from_int(11));
    CHECK(top.distance_q10 > -1024 - 70 && top.distance_q10 < -1024 + 70);
    CHECK(top.y_slope_q13 > 7900 && top.y_slope_q13 < 8500);
  }
  const DistanceGrid grid = grid_of(kBarGlyph, 64, 0);
  const GridPoint away = probe(grid, Q16_16::from_int(-99), {});
  CHECK_EQ(away.x_slope_q13, 0);
  CHECK(away.distance_q10 < -3900);
}

TEST(homes_are_inside_and_in_order) {
  for (int32_t scale = 0; scale <= 2; ++scale) {
    const DistanceGrid grid = grid_of(kEllGlyph, 48, scale);
    CHECK(spread_homes(grid, 100, -30, 5, homes));
    const int32_t column_q4 = 16 << scale;
    for (size_t i = 0; i < kCount; ++i) {
      const GridPoint at =
          probe(grid, Q16_16::from_raw((homes[i].x_q4 - 100 * 16) * 4096),
                Q16_16::from_raw((homes[i].y_q4 + 30 * 16) * 4096));
      CHECK(at.distance_q10 > -(1024 << scale));
      CHECK(i == 0 || homes[i].x_q4 > homes[i - 1].x_q4 - column_q4);
    }
  }
  DistanceGrid empty(samples, 8, 8, 0);
  empty.clear();
  CHECK(!spread_homes(empty, 0, 0, 5, homes));
}

TEST(particles_come_home_and_rest) {
  const DistanceGrid grid = grid_of(kEllGlyph, 48, 0);
  CHECK(spread_homes(grid, 0, 0, 1, homes));
  Random random(31);
  for (Particle& p : particles) {
    p.x.raw = static_cast<int32_t>(random.below(kSide * kOne));
    p.y.raw = static_cast<int32_t>(random.below(kSide * kOne));
    p.x_speed_q10 = static_cast<int16_t>(random.between(-9000, 9000));
    p.y_speed_q10 = static_cast<int16_t>(random.between(-9000, 9000));
  }
  ParticleRules rules;
  rules.walls = kScreen;
  rules.kept_q16 = 49152;  // 1 - 2 sqrt(1/64)
  int32_t steps = 0;
  while (steps < 300 && (steps < 10 || !are_at_rest(particles))) {
    pull_home(particles, homes, Q16_16::from_raw(kOne / 64), 2_px);
    step(particles, rules, grid, 0, 0);
    ++steps;
  }
  CHECK(steps < 300);
  for (size_t i = 0; i < kCount; ++i) {
    const int32_t x = (particles[i].x.raw >> 12) - homes[i].x_q4;
    const int32_t y = (particles[i].y.raw >> 12) - homes[i].y_q4;
    CHECK(x <= 4 && x >= -4 && y <= 4 && y >= -4);
  }
}

// The letter is a stroke of 4.5 px, particles fly at up to 12 px a step.
TEST(none_passes_an_edge_or_a_wall) {
  constexpr int32_t kSteps = INKCELL_BOARD_FIRMWARE ? 100 : 2500;
  for (int32_t scale = 0; scale <= 1; ++scale) {
    for (int32_t sign = -1; sign <= 1; sign += 2) {
      const DistanceGrid grid = grid_of(kEllGlyph, 48, scale);
      Random random(32);
      scatter(random, grid, sign > 0 ? 1 : -1);
      ParticleRules rules;
      rules.walls = kScreen;
      rules.gravity_q10 = 60;
      rules.bounce_q8 = 256;
      rules.side = sign > 0 ? ParticleSide::outside : ParticleSide::inside;
      int32_t worst = 0;
      for (int32_t i = 0; i < kSteps; ++i) {
        step(particles, rules, grid, 0, 0);
        for (const Particle& p : particles) {
          CHECK(holds(kScreen, p.x.floor(), p.y.floor()));
          const int32_t depth = probe(grid, p.x, p.y).distance_q10 * sign;
          worst = depth > worst ? depth : worst;
        }
      }
      // [px, Q10]
      CHECK(worst <= 1024);
    }
  }
}

TEST(elastic_particles_keep_their_energy) {
  const DistanceGrid grid = grid_of(kDiscGlyph, 48, 0);
  Random random(33);
  scatter(random, grid, 1);
  ParticleRules rules;
  rules.walls = kScreen;
  rules.bounce_q8 = 256;
  rules.side = ParticleSide::outside;
  const int64_t before = energy();
  for (int32_t i = 0; i < (INKCELL_BOARD_FIRMWARE ? 100 : 10000); ++i) {
    step(particles, rules, grid, 0, 0);
  }
  const int64_t after = energy();
  CHECK(after <= before * 102 / 100);
  CHECK(INKCELL_BOARD_FIRMWARE || after > before / 4);
}

TEST(bounces_without_spring_never_gain_energy) {
  const DistanceGrid grid = grid_of(kDiscGlyph, 48, 0);
  Random random(34);
  scatter(random, grid, 1);
  ParticleRules rules;
  rules.walls = kScreen;
  rules.bounce_q8 = 128;
  rules.side = ParticleSide::outside;
  int64_t last = energy();
  for (int32_t i = 0; i < 200; ++i) {
    step(particles, rules, grid, 0, 0);
    const int64_t now = energy();
    CHECK(now <= last);
    last = now;
  }
}

TEST(attraction_and_orbits_follow_the_edge) {
  const DistanceGrid grid = grid_of(kDiscGlyph, 48, 1);
  RandomNumbers numbers(35);
  for (Particle& p : particles) {
    CHECK(find_edge(grid, 0, 0, numbers, p));
    const int32_t off = probe(grid, p.x, p.y).distance_q10;
    CHECK(off <= 256 && off >= -256);
    p.x_speed_q10 = 0;
    p.y_speed_q10 = 0;
  }
  ParticleRules rules;
  rules.walls = kScreen;
  rules.attraction_q10 = 40;
  rules.orbit_q10 = 40;
  rules.kept_q16 = 62000;
  rules.side = ParticleSide::outside;
  rules.bounce_q8 = 0;
  for (int32_t i = 0; i < 200; ++i) {
    step(particles, rules, grid, 0, 0);
  }
  // They slide round the disc, all in one sense.
  for (const Particle& p : particles) {
    const int64_t x = p.x.raw - 26 * kOne;
    const int64_t y = p.y.raw - 34 * kOne;
    CHECK(x * p.y_speed_q10 - y * p.x_speed_q10 < 0);
    const int32_t off = probe(grid, p.x, p.y).distance_q10;
    CHECK(off <= 1024 && off > -2048);
  }
}

TEST(dots_are_as_large_as_told) {
  for (const int32_t radius : each_of({48, 64, 128, 320, 512})) {
    for (int32_t phase = 0; phase < 64; phase += 13) {
      const auto draw = [&](const Sink& sink) {
        draw_dot(Q16_16::from_raw(30 * kOne + phase * 1024),
                 Q16_16::from_raw(31 * kOne - phase * 500),
                 Q26_6::from_raw(radius), sink);
      };
      picture.clear();
      draw(picture.sink());
      const int32_t ink = picture.ink();
      // pi r^2, [px, 255ths]
      const int32_t area = 801 * radius / 64 * radius / 64;
      CHECK(ink > area * 90 / 100 && ink < area * 110 / 100);
      second.clear();
      second.draw_parts(3, 30, draw);
      CHECK(picture == second);
    }
  }
}

TEST(hostile_particles_do_no_harm) {
  for (Random& random : Rounds(36, 200)) {
    random.fill(samples);
    const DistanceGrid grid(samples, static_cast<int32_t>(random.below(40)),
                            static_cast<int32_t>(random.below(40)),
                            static_cast<int32_t>(random.below(4)));
    for (size_t i = 0; i < kCount; ++i) {
      particles[i].x.raw = random.any();
      particles[i].y.raw = random.any();
      particles[i].x_speed_q10 = random.any();
      particles[i].y_speed_q10 = random.any();
      homes[i].x_q4 = random.any();
      homes[i].y_q4 = random.any();
      picture.next_glyph();
      draw_dot(particles[i].x, particles[i].y, Q26_6::from_raw(random.any()),
               picture.sink());
    }
    ParticleRules rules;
    rules.walls = {random.between(-99, 99), random.between(-99, 99),
                   random.any(), random.any()};
    rules.gravity_q10 = random.any();
    rules.kept_q16 = random.any();
    rules.bounce_q8 = random.any();
    rules.side = static_cast<ParticleSide>(random.below(3));
    rules.attraction_q10 = random.any();
    rules.orbit_q10 = random.any();
    rules.radius.raw = random.any();
    pull_home(particles, homes, Q16_16::from_raw(random.any()),
              Q26_6::from_raw(random.any()));
    const int32_t x = random.any();
    const int32_t y = random.any();
    step(particles, rules, grid, x, y);
    static_cast<void>(spread_homes(grid, x >> 8, y >> 8, 1, homes));
    RandomNumbers numbers(random.next());
    static_cast<void>(find_edge(grid, x >> 8, y >> 8, numbers, particles[0]));
  }
}
