// Pulls particles home, spreads homes and finds edges.
#include "inkcell/simulation/particle_homes.hpp"

#include "limits.hpp"

namespace inkcell::simulation {
namespace {

// The grid's corner is clamped to the screen's range. [px]
int32_t on_screen(int32_t at) noexcept {
  return clamp(at, -8192, 8191);
}

int16_t to_q4(int32_t px_q4) noexcept {
  return static_cast<int16_t>(clamp(px_q4, INT16_MIN, INT16_MAX));
}

}  // namespace

void pull_home(Span<Particle> particles,
               Span<const ParticleHome> homes,
               Q16_16 stiffness,
               Q26_6 most) noexcept {
  const int32_t stiffness_q12 = clamp(stiffness.raw, 0, 1 << 16) >> 4;
  const int32_t most_q10 = clamp(most.raw, 0, kMostSpeedQ10 / 16) * 16;
  const size_t count =
      particles.size < homes.size ? particles.size : homes.size;
  const auto gain = [&](int16_t home_q4, Q16_16 at, int16_t speed) {
    // Within 256 px, so that 32 bits hold the product. [Q10]
    constexpr int32_t kFar = 256 << 10;
    const int32_t offset = home_q4 * 64 - (at.raw >> 6);
    const int32_t pull = clamp(
        clamp(offset, -kFar, kFar) * stiffness_q12 / 4096, -most_q10, most_q10);
    return static_cast<int16_t>(
        clamp(speed + pull, -kMostSpeedQ10, kMostSpeedQ10));
  };
  for (size_t i = 0; i < count; ++i) {
    Particle& p = particles[i];
    p.x_speed_q10 = gain(homes[i].x_q4, p.x, p.x_speed_q10);
    p.y_speed_q10 = gain(homes[i].y_q4, p.y, p.y_speed_q10);
  }
}

bool spread_homes(const DistanceGrid& grid,
                  int32_t x,
                  int32_t y,
                  uint32_t seed,
                  Span<ParticleHome> homes) noexcept {
  uint32_t inside = 0;
  for (int32_t row = 0; row < grid.height(); ++row) {
    for (int32_t column = 0; column < grid.width(); ++column) {
      inside += grid.at(column, row) >= 0 ? 1u : 0u;
    }
  }
  if (inside == 0 || homes.size == 0) {
    return false;
  }
  // Each sample inside adds homes.size to the count, each home subtracts
  // `inside`. Column by column, at a random place in the sample's square.
  const auto count = static_cast<uint32_t>(homes.size);
  const int32_t scale = grid.scale_log2();
  uint32_t parts = inside / 2;
  uint32_t next = 0;
  for (int32_t column = 0; column < grid.width(); ++column) {
    for (int32_t row = 0; row < grid.height(); ++row) {
      if (grid.at(column, row) < 0) {
        continue;
      }
      parts += count;
      while (parts >= inside && next < count) {
        parts -= inside;
        const uint32_t random = hash(seed, next);
        const auto right = static_cast<int32_t>((random & 0xffff) >> 12);
        const auto down = static_cast<int32_t>(random >> 28);
        ParticleHome& home = homes[next++];
        home.x_q4 =
            to_q4(on_screen(x) * 16 + ((column * 16 + right) * (1 << scale)));
        home.y_q4 =
            to_q4(on_screen(y) * 16 + ((row * 16 + down) * (1 << scale)));
      }
    }
  }
  return true;
}

bool find_edge(const DistanceGrid& grid,
               int32_t x,
               int32_t y,
               RandomNumbers& random,
               Particle& out) noexcept {
  constexpr int32_t kTries = 64;
  constexpr int32_t kSteps = 4;
  constexpr int32_t kNearQ10 = 256;
  for (int32_t i = 0; i < kTries; ++i) {
    const auto width = static_cast<uint32_t>(grid.width_px()) << 16;
    const auto height = static_cast<uint32_t>(grid.height_px()) << 16;
    Q16_16 px = Q16_16::from_raw(static_cast<int32_t>(random.below(width)));
    Q16_16 py = Q16_16::from_raw(static_cast<int32_t>(random.below(height)));
    for (int32_t k = 0; k <= kSteps; ++k) {
      const GridPoint here = probe(grid, px, py);
      const int32_t off = here.distance_q10;
      if (off <= kNearQ10 && off >= -kNearQ10) {
        out.x.raw = on_screen(x) * 65536 + px.raw;
        out.y.raw = on_screen(y) * 65536 + py.raw;
        return true;
      }
      if (here.x_slope_q13 == 0 && here.y_slope_q13 == 0) {
        break;
      }
      // A Newton step with slope 1.
      px.raw -= off * here.x_slope_q13 / 128;
      py.raw -= off * here.y_slope_q13 / 128;
    }
  }
  return false;
}

}  // namespace inkcell::simulation
