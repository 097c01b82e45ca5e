// Folds the parts, pixel by pixel.
#include "inkcell/simulation/combine.hpp"

#include "inkcell/geometry.hpp"
#include "limits.hpp"
#include "pixel_run.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kFarQ10 = -(32 << 10);
constexpr int32_t kMostPlace = 8191;  // [px]

// The distances at which coverage rises. [px, Q10]
struct Ramp {
  int32_t low;
  int32_t high;
};

GridPoint negated(const GridPoint& a) noexcept {
  return {-a.distance_q10, -a.x_slope_q13, -a.y_slope_q13};
}

// The length of a gradient.
int32_t length_q13(const GridPoint& a) noexcept {
  return near_length(abs(a.x_slope_q13), abs(a.y_slope_q13));
}

// The coverage of two half-planes, with a and b on the ramp [0, width].
int32_t covered_by_both(int32_t a,
                        int32_t b,
                        int32_t width,
                        int32_t cosine) noexcept {
  const int32_t across = a + b - a * b / width;
  const int32_t other = cosine < 0 ? min(a + b, width) : max(a, b);
  return across + ((other - across) * abs(cosine) >> 13);
}

GridPoint united(const GridPoint& a,
                 const GridPoint& b,
                 const Ramp& ramp) noexcept {
  GridPoint result = a.distance_q10 >= b.distance_q10 ? a : b;
  const int32_t least = min(a.distance_q10, b.distance_q10);
  if (least > ramp.low && result.distance_q10 < ramp.high) {
    // The angle between the gradients. Slopes are below 8 in Q13: products of
    // Q22 fit.
    const int32_t dot = (a.x_slope_q13 >> 2) * (b.x_slope_q13 >> 2) +
                        (a.y_slope_q13 >> 2) * (b.y_slope_q13 >> 2);
    const int32_t lengths = (length_q13(a) >> 2) * (length_q13(b) >> 2);
    const int32_t cosine =
        clamp(dot / max(lengths >> 13, 1), -kOneQ13, kOneQ13);
    const int32_t both =
        ramp.low + covered_by_both(a.distance_q10 - ramp.low,
                                   b.distance_q10 - ramp.low,
                                   ramp.high - ramp.low, cosine);
    // A thin part has a short gradient: the farther part adds less, down to
    // half.
    const int32_t trust_q14 = kOneQ13 + min(lengths >> 9, kOneQ13);
    result.distance_q10 += (both - result.distance_q10) * trust_q14 >> 14;
  }
  return result;
}

// max(a, b) + h^2 / 4k with h = max(k - |a - b|, 0), over the length of the
// gradient.
GridPoint blended(const GridPoint& a,
                  const GridPoint& b,
                  int32_t reach_q10,
                  const Ramp& ramp) noexcept {
  const int32_t apart = a.distance_q10 - b.distance_q10;
  const int32_t near = reach_q10 - abs(apart);
  if (near <= 0) {
    return united(a, b, ramp);
  }
  // The share of b. [Q10]
  const int32_t part = 512 - apart * 512 / reach_q10;
  const auto mixed = [part](int32_t of_a, int32_t of_b) {
    return of_a + ((of_b - of_a) * part >> 10);
  };
  GridPoint result;
  result.distance_q10 =
      max(a.distance_q10, b.distance_q10) + near * (near >> 2) / reach_q10;
  result.x_slope_q13 = mixed(a.x_slope_q13, b.x_slope_q13);
  result.y_slope_q13 = mixed(a.y_slope_q13, b.y_slope_q13);
  // Opposite gradients cancel: there is no edge.
  const int32_t length = clamp(length_q13(result), kOneQ13 / 2, kOneQ13);
  const int32_t most = 2 * max(ramp.high, -ramp.low);
  if (abs(result.distance_q10) < most) {
    result.distance_q10 = result.distance_q10 * kOneQ13 / length;
    result.x_slope_q13 = result.x_slope_q13 * (kOneQ13 >> 3) / (length >> 3);
    result.y_slope_q13 = result.y_slope_q13 * (kOneQ13 >> 3) / (length >> 3);
  }
  return result;
}

// The range of a part's distances: clamped values, 4 sides away, must not
// change the edge of another part.
int32_t reach_q10(const GridPart& part) noexcept {
  const int32_t most = part.grid == nullptr ? 0 : 3 << part.grid->scale_log2();
  return clamp(part.reach.raw, 64, most * 64) * 16;
}

GridPoint combined(const GridPoint& a,
                   const GridPoint& b,
                   const GridPart& part,
                   const Ramp& ramp) noexcept {
  const Ramp turned = {-ramp.high, -ramp.low};
  switch (part.how) {
    case Combine::intersect:
      return negated(united(negated(a), negated(b), turned));
    case Combine::subtract:
      return negated(united(negated(a), b, turned));
    case Combine::blend:
      return blended(a, b, reach_q10(part), ramp);
    case Combine::unite:
      break;
  }
  return united(a, b, ramp);
}

// Distance and slope of a part at a place on the screen.
GridPoint at_part(const GridPart& part, int64_t x_q16, int64_t y_q16) noexcept {
  if (part.grid == nullptr || part.grid->width() == 0) {
    return {kFarQ10, 0, 0};
  }
  constexpr int32_t kMost = kMostPlace << 16;
  return probe(*part.grid,
               Q16_16::from_raw(clamp_i64(x_q16 - part.x.raw, -kMost, kMost)),
               Q16_16::from_raw(clamp_i64(y_q16 - part.y.raw, -kMost, kMost)));
}

bool is_edge(const GridPoint& point, const Ramp& ramp) noexcept {
  return point.distance_q10 > ramp.low && point.distance_q10 < ramp.high;
}

// Slopes by central differences over a sample: probe() has those of one square,
// which may lie beside the place.
GridPoint centred(const GridPart& part,
                  const GridPoint& point,
                  int64_t x_q16,
                  int64_t y_q16) noexcept {
  if (part.grid == nullptr) {
    return point;
  }
  const int32_t scale_log2 = part.grid->scale_log2();
  const int32_t half = 32768 << scale_log2;
  const auto slope = [&](int64_t dx, int64_t dy) {
    const int32_t rise = at_part(part, x_q16 + dx, y_q16 + dy).distance_q10 -
                         at_part(part, x_q16 - dx, y_q16 - dy).distance_q10;
    return rise * 8 >> scale_log2;
  };
  return {point.distance_q10, slope(half, 0), slope(0, half)};
}

Ramp ramp_of(const Filter& filter) noexcept {
  return {filter.outside_q10, max(filter.inside_q10, filter.outside_q10 + 1)};
}

// `edges` counts the parts that have an edge here.
GridPoint fold(Span<const GridPart> parts,
               int32_t x_q16,
               int32_t y_q16,
               const Ramp& ramp,
               bool is_centred,
               size_t& edges) noexcept {
  GridPoint result = {kFarQ10, 0, 0};
  for (size_t i = 0; i < parts.size; ++i) {
    GridPoint next = at_part(parts[i], x_q16, y_q16);
    if (is_edge(next, ramp)) {
      ++edges;
      if (is_centred) {
        next = centred(parts[i], next, x_q16, y_q16);
      }
    }
    result = i == 0 ? next : combined(result, next, parts[i], ramp);
  }
  return result;
}

// Exact slopes are needed only where edges meet; each costs five probes.
GridPoint fold(Span<const GridPart> parts,
               int32_t x_q16,
               int32_t y_q16,
               const Ramp& ramp) noexcept {
  size_t edges = 0;
  const GridPoint result = fold(parts, x_q16, y_q16, ramp, false, edges);
  return edges < 2 ? result : fold(parts, x_q16, y_q16, ramp, true, edges);
}

Rect box_of(const GridPart& part, int32_t around) noexcept {
  if (part.grid == nullptr || part.grid->width() == 0) {
    return {};
  }
  const int32_t x = clamp(part.x.raw >> 16, -kMostPlace, kMostPlace);
  const int32_t y = clamp(part.y.raw >> 16, -kMostPlace, kMostPlace);
  return {x - around, y - around, x + part.grid->width_px() + around + 1,
          y + part.grid->height_px() + around + 1};
}

}  // namespace

GridPoint combined_at(Span<const GridPart> parts,
                      Q16_16 x,
                      Q16_16 y,
                      const Filter& filter) noexcept {
  return fold(parts, x.raw, y.raw, ramp_of(filter));
}

Rect combined_box(Span<const GridPart> parts, const Filter& filter) noexcept {
  Rect box;
  for (size_t i = 0; i < parts.size; ++i) {
    const GridPart& part = parts[i];
    const bool is_added =
        i == 0 || part.how == Combine::unite || part.how == Combine::blend;
    const int32_t fillet =
        part.how == Combine::blend ? reach_q10(part) >> 12 : 0;
    const int32_t reach = (max(-filter.outside_q10, 0) >> 10) + 1 + fillet;
    const Rect own = box_of(part, reach);
    if (is_added) {
      box = bounding_box(box, own);
    } else if (part.how == Combine::intersect) {
      box = intersect(box, own);
    }
  }
  return box;
}

void draw_combined(Span<const GridPart> parts,
                   const Filter& filter,
                   const Sink& sink) noexcept {
  const Rect box = intersect(combined_box(parts, filter), sink.window);
  const Ramp ramp = ramp_of(filter);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    PixelRun run(sink, y);
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const GridPoint at =
          fold(parts, x * 65536 + 32768, y * 65536 + 32768, ramp);
      run.add(x, filter.coverage(at.distance_q10));
    }
    run.flush();
  }
}

}  // namespace inkcell::simulation
