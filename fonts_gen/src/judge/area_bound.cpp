#include "judge/area_bound.hpp"

#include <algorithm>
#include <cmath>

#include "judge/moved_area.hpp"
#include "judge/painted_chords.hpp"
#include "outlines/expand.hpp"

namespace inkcell::gen {
namespace {

// From a size to the next smaller one that is looked at. What is moved counts
// less in larger pixels; chords and roundings are what is left then.
int next_smaller(int px, int max_px) {
  return px - std::max(1, 2 * px > max_px ? px / 12 : px / 4);
}

bool are_alike(const Polygons& a, const Polygons& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const auto& p, const auto& q) { return p.size() == q.size(); });
}

// The chords of a size, one case or two.
std::vector<Polygons> strays_of(const MinimalOutline& outline,
                                double u_per_grid,
                                int px) {
  std::vector<Polygons> strays;
  for (const ChordNumber number : {ChordNumber::fewer, ChordNumber::more}) {
    strays.push_back(chord_strays(outline, u_per_grid, px, number));
  }
  if (are_alike(strays[0], strays[1])) {
    strays.pop_back();
  }
  return strays;
}

LoopMiss miss_of(const MovedPixel& pixel, int px) {
  return {pixel.centre_u.x, pixel.centre_u.y, px,
          std::min(255.0, 255 * pixel.share + kAreaRounding)};
}

}  // namespace

LoopResult bound_areas(const Shape& source,
                       const MinimalOutline& outline,
                       const RefitOptions& refit,
                       const LoopOptions& options) {
  const double u_per_grid =
      std::ldexp(1024.0 / refit.units_per_em, refit.grid_shift);
  const MovedArea moved(
      source, Shape(expand(outline, refit.units_per_em, refit.grid_shift)));
  const double limit = (options.tolerance - kAreaRounding) / 255;
  LoopResult result;
  MovedPixel worst;
  for (int px = options.max_px; px >= options.min_px;
       px = next_smaller(px, options.max_px)) {
    std::vector<MovedPixel> beyond;
    const MovedPixel found = moved.worst_pixel(
        px, strays_of(outline, u_per_grid, px), limit, worst, beyond);
    if (found.share > worst.share) {
      worst = found;
      result.worst_pixel = miss_of(found, px);
    }
    for (const MovedPixel& pixel : beyond) {
      result.misses.push_back(miss_of(pixel, px));
    }
  }
  result.worst = miss_of(worst, 0).error;
  result.miss_count = result.misses.size();
  std::stable_sort(
      result.misses.begin(), result.misses.end(),
      [](const LoopMiss& a, const LoopMiss& b) { return a.error > b.error; });
  return result;
}

}  // namespace inkcell::gen
