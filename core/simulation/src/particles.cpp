// Forces, then speeds, then places: in this order energy does not grow.
#include "inkcell/simulation/particles.hpp"

#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

int16_t speed(int32_t value) noexcept {
  return static_cast<int16_t>(clamp(value, -kMostSpeedQ10, kMostSpeedQ10));
}

// Components of a unit vector. [Q13]
struct Normal {
  int32_t x;
  int32_t y;
};

// The unit gradient; against the speed where there is none.
Normal normal_of(const GridPoint& point, const Particle& particle) noexcept {
  int32_t x = point.x_slope_q13;
  int32_t y = point.y_slope_q13;
  uint32_t length = length_of(x, y);
  if (length < kOneQ13 / 8) {
    x = particle.x_speed_q10;
    y = particle.y_speed_q10;
    length = length_of(x, y);
  }
  if (length == 0) {
    return {0, -kOneQ13};
  }
  const auto divisor = static_cast<int32_t>(length);
  return {x * kOneQ13 / divisor, y * kOneQ13 / divisor};
}

void apply_field(const ParticleRules& rules,
                 const GridPoint& point,
                 Particle& p) noexcept {
  // Each product is below 2^31: slopes are at most 255 / 32.
  const int32_t x = rules.attraction_q10 * point.x_slope_q13 / kOneQ13 -
                    rules.orbit_q10 * point.y_slope_q13 / kOneQ13;
  const int32_t y = rules.attraction_q10 * point.y_slope_q13 / kOneQ13 +
                    rules.orbit_q10 * point.x_slope_q13 / kOneQ13;
  p.x_speed_q10 = speed(p.x_speed_q10 + x);
  p.y_speed_q10 = speed(p.y_speed_q10 + y);
}

// Moves a particle that is `depth` px on the wrong side of an edge back and
// reflects its speed. `inwards` is 1 if the wrong side is the inside, else -1.
void bounce(const ParticleRules& rules,
            const GridPoint& point,
            int32_t depth_q10,
            int32_t inwards,
            Particle& p) noexcept {
  const Normal n = normal_of(point, p);
  const int32_t nx = n.x * inwards;
  const int32_t ny = n.y * inwards;
  p.x.raw -= depth_q10 * nx / (kOneQ13 >> 6);
  p.y.raw -= depth_q10 * ny / (kOneQ13 >> 6);
  const int32_t towards = (p.x_speed_q10 * nx + p.y_speed_q10 * ny) / kOneQ13;
  if (towards > 0) {
    const int32_t change =
        towards * (256 + clamp(rules.bounce_q8, 0, 256)) / 256;
    p.x_speed_q10 = speed(p.x_speed_q10 - change * nx / kOneQ13);
    p.y_speed_q10 = speed(p.y_speed_q10 - change * ny / kOneQ13);
  }
}

void meet_wall(int32_t low,
               int32_t high,
               int32_t bounce_q8,
               Q16_16& at,
               int16_t& speed_q10) noexcept {
  const int64_t low_q16 = int64_t{low} * (1 << 16);
  const int64_t high_q16 = int64_t{high} * (1 << 16) - 1;
  const bool is_low = at.raw < low_q16;
  if (!is_low && at.raw <= high_q16) {
    return;
  }
  at.raw = static_cast<int32_t>(is_low ? low_q16 : high_q16);
  if (is_low == (speed_q10 < 0)) {
    speed_q10 = speed(-speed_q10 * bounce_q8 / 256);
  }
}

// A grid on the screen.
struct GridPlace {
  const DistanceGrid& grid;
  int32_t x_q16;
  int32_t y_q16;

  GridPoint at(const Particle& p) const noexcept {
    return probe(grid, Q16_16::from_raw(p.x.raw - x_q16),
                 Q16_16::from_raw(p.y.raw - y_q16));
  }
};

// Moves a particle along its speed, in pieces too short to pass an edge.
void move(const ParticleRules& rules,
          const GridPlace& place,
          Particle& p) noexcept {
  constexpr int32_t kPieceQ10 = 1 << 10;
  const int32_t inwards = rules.side == ParticleSide::outside ? 1 : -1;
  const int32_t radius_q10 = clamp(rules.radius.raw, 0, 512) * 16;
  int32_t left_q10 = 1 << 10;  // of the step
  // Pieces are at least a pixel, steps at most 16 px on each axis.
  for (int pieces = 0; pieces < 32 && left_q10 > 0; ++pieces) {
    const int32_t x_speed = abs(p.x_speed_q10);
    const int32_t y_speed = abs(p.y_speed_q10);
    // An upper bound of the distance left. [px, Q10]
    const int32_t distance = (x_speed + y_speed) * left_q10 >> 10;
    int32_t part_q10 = left_q10;
    if (rules.side != ParticleSide::both && distance > kPieceQ10) {
      const int32_t clear = -place.at(p).distance_q10 * inwards - radius_q10;
      const int32_t piece = max(clear, kPieceQ10);
      if (distance > piece) {
        part_q10 =
            static_cast<int32_t>(static_cast<uint32_t>(piece << 10) /
                                 static_cast<uint32_t>(x_speed + y_speed));
        part_q10 = max(part_q10, 1);
      }
    }
    left_q10 -= part_q10;
    p.x.raw += p.x_speed_q10 * part_q10 / 16;
    p.y.raw += p.y_speed_q10 * part_q10 / 16;
    if (rules.side != ParticleSide::both) {
      const GridPoint there = place.at(p);
      const int32_t depth = there.distance_q10 * inwards + radius_q10;
      if (depth > 0) {
        bounce(rules, there, depth, inwards, p);
      }
    }
  }
}

}  // namespace

void step(Span<Particle> particles,
          const ParticleRules& rules,
          const DistanceGrid& grid,
          int32_t x,
          int32_t y) noexcept {
  const GridPlace place = {grid, clamp(x, -8192, 8191) * (1 << 16),
                           clamp(y, -8192, 8191) * (1 << 16)};
  const Rect walls = intersect(rules.walls, {-8192, -8192, 8192, 8192});
  const bool has_field = rules.attraction_q10 != 0 || rules.orbit_q10 != 0;
  if (is_empty(walls)) {
    return;
  }
  for (Particle& p : particles) {
    // Clamps untrusted positions, so that no sum overflows.
    meet_wall(walls.x0, walls.x1, 0, p.x, p.x_speed_q10);
    meet_wall(walls.y0, walls.y1, 0, p.y, p.y_speed_q10);
    if (has_field) {
      apply_field(rules, place.at(p), p);
    }
    const int32_t kept_q15 = rules.kept_q16 >> 1;
    const bool is_kept = rules.kept_q16 == UINT16_MAX;
    const int32_t x_speed = p.x_speed_q10;
    const int32_t y_speed = p.y_speed_q10 + rules.gravity_q10;
    p.x_speed_q10 = speed(is_kept ? x_speed : x_speed * kept_q15 / 32768);
    p.y_speed_q10 = speed(is_kept ? y_speed : y_speed * kept_q15 / 32768);
    move(rules, place, p);
    const int32_t bounce_q8 = clamp(rules.bounce_q8, 0, 256);
    meet_wall(walls.x0, walls.x1, bounce_q8, p.x, p.x_speed_q10);
    meet_wall(walls.y0, walls.y1, bounce_q8, p.y, p.y_speed_q10);
  }
}

bool are_at_rest(Span<const Particle> particles) noexcept {
  for (const Particle& p : particles) {
    if (p.x_speed_q10 != 0 || p.y_speed_q10 != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace inkcell::simulation
