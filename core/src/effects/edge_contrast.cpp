#include "inkcell/edge_contrast.hpp"

#include "base/math.hpp"
#include "distance/sampler.hpp"
#include "raster/draw_cells.hpp"
#include "sink/row_writer.hpp"

namespace inkcell {
namespace {

using detail::CellSampler;
using detail::GlyphPoint;
using detail::max;
using detail::moved;
using detail::moved_back;
using detail::RowWriter;
using detail::ScreenGradient;

// Where a pixel's neighbours are asked for their gradients: close enough to
// lie in cells that are not saturated. [px, Q10]
constexpr int32_t kAway = 600;

constexpr int32_t kOneQ14 = 1 << 14;

// A gradient that points to neither side points there by less. [Q14]
constexpr int32_t kAside = 3277;

// Where a stroke can be thin: distances in its middle. [px, Q10]
constexpr int32_t kThinLow = -358;
constexpr int32_t kThinHigh = 768;

// Where a row's first pixel lies, and its neighbours above and below.
struct Rows {
  GlyphPoint centre;
  GlyphPoint above;
  GlyphPoint below;
};

// By how much the gradients on both sides of a pixel oppose each other: 0
// unless both point to it, because between strokes they point away. [Q14]
int32_t convergence(const ScreenGradient& low,
                    int32_t low_inwards,
                    const ScreenGradient& high,
                    int32_t high_inwards) noexcept {
  if (low_inwards < kAside || high_inwards < kAside) {
    return 0;
  }
  const int32_t dot =
      (low.right_q14 * high.right_q14 + low.up_q14 * high.up_q14) >> 14;
  return max(0, -dot);
}

struct Painting {
  const TextStyle& style;
  const EdgeContrast& options;
  CellSampler sampler;
  GlyphPoint aside;  // kAway to the right
};

__attribute__((noinline)) int32_t thinness_q14(
    Painting& painting,
    const GlyphPoint& centre,
    const GlyphPoint& above,
    const GlyphPoint& below) noexcept {
  CellSampler& walk = painting.sampler;
  const ScreenGradient left = walk.gradient(moved_back(centre, painting.aside));
  const ScreenGradient right = walk.gradient(moved(centre, painting.aside));
  const int32_t across =
      convergence(left, left.right_q14, right, -right.right_q14);
  const ScreenGradient low = walk.gradient(below);
  const ScreenGradient high = walk.gradient(above);
  return max(across, convergence(low, low.up_q14, high, -high.up_q14));
}

// What a change of `share_q22` of I (1 - I) makes of a coverage.
int32_t changed(int32_t coverage, int32_t share_q22) noexcept {
  // I (1 - I) is at most a quarter: 64 levels.
  const int32_t room = (coverage * (255 - coverage) + 127) / 255;
  const int32_t result =
      coverage + ((room * (share_q22 >> 6) + (1 << 15)) >> 16);
  return result > 255 ? 255 : result;
}

__attribute__((noinline)) uint8_t coverage_at(Painting& painting,
                                              const Rows& rows,
                                              const GlyphPoint& way) noexcept {
  const GlyphPoint at = moved(rows.centre, way);
  const int32_t distance_q10 = painting.sampler.distance_q10(at);
  int32_t coverage = painting.style.filter().coverage(distance_q10);
  if (coverage == 0 || coverage == 255) {
    return static_cast<uint8_t>(coverage);
  }
  const ScreenGradient g = painting.sampler.gradient(at);
  int32_t side_q14 = max(g.right_q14, g.up_q14) - max(-g.right_q14, -g.up_q14);
  side_q14 = side_q14 > kOneQ14 ? kOneQ14 : max(side_q14, -kOneQ14);
  coverage = changed(coverage, side_q14 * painting.options.edge);
  if (distance_q10 > kThinLow && distance_q10 < kThinHigh) {
    const int32_t thin_q14 = thinness_q14(painting, at, moved(rows.above, way),
                                          moved(rows.below, way));
    coverage = changed(coverage, thin_q14 * painting.options.thin);
  }
  return static_cast<uint8_t>(coverage);
}

__attribute__((noinline)) void draw_row(Painting& painting,
                                        const FinePoint& origin,
                                        const Rect& box,
                                        int32_t y,
                                        const Sink& sink) noexcept {
  const auto position = [&](int32_t up_q10) noexcept {
    return painting.sampler.point(origin, box.x0, y, {0, up_q10});
  };
  const Rows rows = {position(0), position(kAway), position(-kAway)};
  RowWriter writer(sink, y);
  const GlyphPoint step = detail::offset_of(painting.style, {1 << 10, 0});
  GlyphPoint way = {0, 0, 0, 0};
  for (int32_t x = box.x0; x < box.x1; ++x) {
    writer.put(x, coverage_at(painting, rows, way));
    way = moved(way, step);
  }
  writer.next_row();
}

}  // namespace

void detail::paint_edge_contrast(const GlyphField& field,
                                 const TextStyle& style,
                                 const void* options,
                                 const FinePoint& origin,
                                 const Sink& sink) {
  const Rect box = detail::visible_pixels(field, style, origin, sink.window);
  Painting painting = {style, *static_cast<const EdgeContrast*>(options),
                       CellSampler(field, style, detail::kNoReach),
                       detail::offset_of(style, {kAway, 0})};
  for (int32_t y = box.y0; y < box.y1; ++y) {
    draw_row(painting, origin, box, y, sink);
  }
}

}  // namespace inkcell
