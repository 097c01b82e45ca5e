// Samples of a pixel: the centre, four on an inner circle, eight on an outer.
//
//       o   o   o          The outer circle has two thirds of the filter's
//          i i             radius, the inner one a third. Of the outer one the
//       o   c   o          four on the axes come first: with the centre they
//          i i             tell whether the field bends or breaks there.
//       o   o   o
#include "inkcell/supersample.hpp"

#include "base/math.hpp"
#include "distance/sampler.hpp"
#include "raster/coverage_ramp.hpp"
#include "raster/draw_cells.hpp"
#include "sink/row_writer.hpp"

namespace inkcell {
namespace {

using detail::abs;
using detail::CellSampler;
using detail::GlyphPoint;
using detail::moved;
using detail::moved_back;
using detail::offset_of;
using detail::RowWriter;
using detail::Surroundings;

constexpr int32_t kHalfRootQ15 = 23170;

// Up to the first of these second differences a field counts as a plane, from
// the second on as none. [px, Q10]
constexpr int32_t kPlane = 64;
constexpr int32_t kBroken = 192;
constexpr int32_t kMeanQ8 = 35;

int32_t part_of(int32_t radius_q10, int32_t thirds) noexcept {
  return radius_q10 * thirds / 3;
}

int32_t diagonal(int32_t way_q10) noexcept {
  return (way_q10 * kHalfRootQ15) >> 15;
}

// Heights at which samples lie, and how far to the right.
enum Height : uint8_t {
  kCentre,
  kOuterUp,
  kOuterDown,
  kDiagonalUp,
  kDiagonalDown,
  kInnerUp,
  kInnerDown,
  kHeights
};

// Samples of all pixels of a row, as they lie around the first one.
struct SampleRows {
  GlyphPoint heights[kHeights];
  GlyphPoint outer;  // to the right
  GlyphPoint diagonal;
  GlyphPoint inner;
};

// Supersampling::edge between its entries, which lie farther apart than those
// of the filter.
int32_t edge_coverage(const Filter& edge, int32_t distance_q10) noexcept {
  if (distance_q10 <= edge.outside_q10) {
    return 0;
  }
  if (distance_q10 >= edge.inside_q10) {
    return 255;
  }
  // Entries stand for the middles of their intervals.
  const int32_t place_q14 =
      (distance_q10 - edge.outside_q10) * edge.scale - (1 << 13);
  const int32_t entry = place_q14 >> 14;
  const int32_t low = entry < 0 ? 0 : edge.table[entry];
  const int32_t high =
      entry + 1 < Filter::kEntries ? edge.table[entry + 1] : 255;
  const int32_t part_q8 = (place_q14 >> 6) & 255;
  return low + (((high - low) * part_q8 + 128) >> 8);
}

// What a glyph's pixels have in common.
struct Sampling {
  const TextStyle& style;
  const Supersampling& options;
  CellSampler walk;
  Surroundings around;
  uint32_t more_samples;

  Sampling(const GlyphField& field,
           const TextStyle& the_style,
           const Supersampling& the_options) noexcept;

  int32_t distance_q10(const GlyphPoint& at) noexcept {
    ++more_samples;
    return walk.distance_q10(at);
  }
  int32_t coverage(const GlyphPoint& at) noexcept {
    return style.filter().coverage(distance_q10(at));
  }
};

Sampling::Sampling(const GlyphField& field,
                   const TextStyle& the_style,
                   const Supersampling& the_options) noexcept
    : style(the_style),
      options(the_options),
      // Farther away vertices need not be round.
      walk(field,
           the_style,
           reach_of(detail::CoverageRamp(the_style.filter())) +
               (the_options.radius_q10 << 12)),
      around{part_of(the_options.radius_q10, 2), 0, 0},
      more_samples(0) {
  const GlyphPoint right = offset_of(the_style, {around.radius_q10, 0});
  const GlyphPoint up = offset_of(the_style, {0, around.radius_q10});
  const auto sum = [](uint32_t a, uint32_t b) noexcept {
    return static_cast<uint32_t>(abs(static_cast<int32_t>(a)) +
                                 abs(static_cast<int32_t>(b)));
  };
  around.x_q16 = sum(right.x_q16, up.x_q16);
  around.y_q16 = sum(right.y_q16, up.y_q16);
}

// Of values on the two circles.
struct Sums {
  int32_t inner;
  int32_t outer;
};

// Places around a pixel.
struct Pixel {
  Sampling& sampling;
  const SampleRows& rows;
  const GlyphPoint& way;  // from the row's first pixel

  GlyphPoint at(Height height) const noexcept {
    return moved(rows.heights[height], way);
  }

  // Both go around the centre, so that many a sample lies in the cell of the
  // one before.

  // On the axes: right, up, left and down.
  void cross(int32_t* out_q10) const noexcept {
    const GlyphPoint centre = at(kCentre);
    out_q10[0] = sampling.distance_q10(moved(centre, rows.outer));
    out_q10[1] = sampling.distance_q10(at(kOuterUp));
    out_q10[2] = sampling.distance_q10(moved_back(centre, rows.outer));
    out_q10[3] = sampling.distance_q10(at(kOuterDown));
  }

  // On the diagonals; `value` maps a place to what is summed.
  template <typename Value>
  Sums diagonals(const Value& value) const noexcept {
    Sums sums = {0, 0};
    for (uint32_t corner = 0; corner < 4; ++corner) {
      // From the lower right one to the lower left one.
      const bool is_up = corner == 1 || corner == 2;
      const bool is_right = corner < 2;
      const GlyphPoint outer = at(is_up ? kDiagonalUp : kDiagonalDown);
      const GlyphPoint inner = at(is_up ? kInnerUp : kInnerDown);
      sums.outer += value(is_right ? moved(outer, rows.diagonal)
                                   : moved_back(outer, rows.diagonal));
      sums.inner += value(is_right ? moved(inner, rows.inner)
                                   : moved_back(inner, rows.inner));
    }
    return sums;
  }
};

// The even rule, where the field may not be a plane.
__attribute__((noinline)) int32_t even_coverage(const Pixel& pixel,
                                                int32_t centre_q10) noexcept {
  Sampling& sampling = pixel.sampling;
  const Supersampling& options = sampling.options;
  const Filter& filter = sampling.style.filter();
  int32_t cross[4];
  pixel.cross(cross);
  // The other eight lie between these, and distances change by no more than the
  // way.
  const int32_t margin = sampling.around.radius_q10 >> 1;
  int32_t least = centre_q10;
  int32_t most = centre_q10;
  for (const int32_t distance_q10 : cross) {
    least = distance_q10 < least ? distance_q10 : least;
    most = distance_q10 > most ? distance_q10 : most;
  }
  if (most <= filter.outside_q10 - margin ||
      least >= filter.inside_q10 + margin) {
    return most <= filter.outside_q10 ? 0 : 255;
  }
  const int32_t across = cross[0] + cross[2] - 2 * centre_q10;
  const int32_t upright = cross[1] + cross[3] - 2 * centre_q10;
  const int32_t bend = abs(across) > abs(upright) ? abs(across) : abs(upright);
  // Where the field bends a little its mean is a little elsewhere: the circles
  // are at a quarter of the sum, and at a quarter of that, with 0.43 of the
  // weight each.
  const int32_t mean_q10 =
      bend < kBroken ? centre_q10 + (((across + upright) * kMeanQ8) >> 8)
                     : centre_q10;
  const int32_t edge = edge_coverage(options.edge, mean_q10);
  if (bend <= kPlane) {
    return edge;
  }
  const auto coverage = [&sampling](const GlyphPoint& at) noexcept {
    return sampling.coverage(at);
  };
  Sums sums = pixel.diagonals(coverage);
  for (const int32_t distance_q10 : cross) {
    sums.outer += filter.coverage(distance_q10);
  }
  const int32_t mean_q16 = filter.coverage(centre_q10) * options.centre_q16 +
                           sums.inner * options.inner_q16 +
                           sums.outer * options.outer_q16;
  const int32_t mean = (mean_q16 + (1 << 15)) >> 16;
  if (bend >= kBroken) {
    return mean;
  }
  return edge + (mean - edge) * (bend - kPlane) / (kBroken - kPlane);
}

int32_t even_sample(const Pixel& pixel) noexcept {
  Sampling& sampling = pixel.sampling;
  const GlyphPoint at = pixel.at(kCentre);
  const int32_t centre_q10 = sampling.walk.distance_q10(at);
  const Filter& edge = sampling.options.edge;
  const bool is_far =
      centre_q10 <= edge.outside_q10 || centre_q10 >= edge.inside_q10;
  // Of a saturated cell no more is known than that its own points are far.
  if ((is_far && !sampling.walk.is_saturated()) ||
      sampling.walk.is_plane_around(at, sampling.around)) {
    return edge_coverage(edge, centre_q10);
  }
  return even_coverage(pixel, centre_q10);
}

// The paper's rule: 13 samples where a cell is no wider than half the radius.
__attribute__((noinline)) int32_t paper_sample(const Pixel& pixel) noexcept {
  Sampling& sampling = pixel.sampling;
  const Supersampling& options = sampling.options;
  const Filter& filter = sampling.style.filter();
  const int32_t centre_q10 = sampling.walk.distance_q10(pixel.at(kCentre));
  // What a saturated cell reports is clamped to what cannot change coverage.
  const int32_t low = filter.outside_q10 - options.radius_q10;
  const int32_t high = filter.inside_q10 + options.radius_q10;
  // Widths as the radius has them: 2^log2 u in px, Q10.
  const int32_t width_q10 =
      sampling.style.to_px_q10(int32_t{1} << (10 + sampling.walk.cell_log2()));
  if (width_q10 > options.radius_q10 ||
      (!sampling.walk.is_saturated() &&
       (centre_q10 < low || centre_q10 > high))) {
    return filter.coverage(centre_q10);
  }
  const auto clamped = [low, high](int32_t distance_q10) noexcept {
    distance_q10 = distance_q10 < low ? low : distance_q10;
    return distance_q10 > high ? high : distance_q10;
  };
  int32_t cross[4];
  pixel.cross(cross);
  int32_t outer = 0;
  for (const int32_t distance_q10 : cross) {
    outer += clamped(distance_q10);
  }
  const int32_t centre = clamped(centre_q10);
  if (2 * width_q10 > options.radius_q10) {
    const int32_t weight_q16 = options.outer_q16;
    const int32_t sum = options.centre_q16 + 4 * weight_q16;
    const int64_t mean =
        int64_t{centre} * options.centre_q16 + int64_t{outer} * weight_q16;
    return filter.coverage(static_cast<int32_t>(mean / sum));
  }
  const auto distance = [&](const GlyphPoint& at) noexcept {
    return clamped(sampling.distance_q10(at));
  };
  const Sums sums = pixel.diagonals(distance);
  const int64_t mean_q16 = int64_t{centre} * options.centre_q16 +
                           int64_t{sums.inner} * options.inner_q16 +
                           int64_t{outer + sums.outer} * options.outer_q16;
  return filter.coverage(static_cast<int32_t>(mean_q16 >> 16));
}

// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) void set_up_rows(SampleRows& rows,
                                           const Sampling& sampling,
                                           const FinePoint& origin,
                                           int32_t x,
                                           int32_t y) noexcept {
  const TextStyle& style = sampling.style;
  const CellSampler& walk = sampling.walk;
  const int32_t outer = part_of(sampling.options.radius_q10, 2);
  const int32_t corner = diagonal(outer);
  const int32_t inner = diagonal(part_of(sampling.options.radius_q10, 1));
  const int32_t up[] = {0, outer, -outer, corner, -corner, inner, -inner};
  for (uint32_t i = 0; i < kHeights; ++i) {
    rows.heights[i] = walk.point(origin, x, y, {0, up[i]});
  }
  rows.outer = offset_of(style, {outer, 0});
  rows.diagonal = offset_of(style, {corner, 0});
  rows.inner = offset_of(style, {inner, 0});
}

// The pixels of a row whose samples are set up.
__attribute__((noinline)) void draw_pixels(Sampling& sampling,
                                           const SampleRows& rows,
                                           int32_t x,
                                           int32_t end,
                                           RowWriter& writer) noexcept {
  const GlyphPoint step = offset_of(sampling.style, {1 << 10, 0});
  const bool is_even = sampling.options.rule == SampleRule::even;
  GlyphPoint way = {0, 0, 0, 0};
  const Pixel pixel = {sampling, rows, way};
  for (; x < end; ++x) {
    writer.put(x, static_cast<uint8_t>(is_even ? even_sample(pixel)
                                               : paper_sample(pixel)));
    way = moved(way, step);
  }
  writer.next_row();
}

// Not inline, like all that draws a row: no function needs much of the stack.
__attribute__((noinline)) void draw_row(Sampling& sampling,
                                        const FinePoint& origin,
                                        const Rect& box,
                                        int32_t y,
                                        const Sink& sink) noexcept {
  SampleRows rows;
  set_up_rows(rows, sampling, origin, box.x0, y);
  RowWriter writer(sink, y);
  draw_pixels(sampling, rows, box.x0, box.x1, writer);
}

}  // namespace

Supersampling make_supersampling(const Filter& filter,
                                 Q6_10 radius,
                                 SampleRule rule) noexcept {
  constexpr int32_t kLeast = 256;
  constexpr int32_t kMost = 1536;
  // 1, 2^(-1/3) and 2^(-4/3): their shares of 1 + 4 inner + 8 outer.
  constexpr int32_t kInner = 7077;
  constexpr int32_t kOuter = 3539;
  Supersampling supersampling;
  int32_t radius_q10 = radius.raw;
  radius_q10 = radius_q10 < kLeast ? kLeast : radius_q10;
  radius_q10 = radius_q10 > kMost ? kMost : radius_q10;
  supersampling.rule = rule;
  supersampling.radius_q10 = static_cast<int16_t>(radius_q10);
  supersampling.inner_q16 = kInner;
  supersampling.outer_q16 = kOuter;
  supersampling.centre_q16 = (1 << 16) - 4 * kInner - 8 * kOuter;

  // The mean of an edge along the axes and one along the diagonals: what lies
  // on the axes of one lies on the diagonals of the other.
  const int32_t outer = part_of(radius_q10, 2);
  const int32_t inner = part_of(radius_q10, 1);
  Filter& edge = supersampling.edge;
  const int32_t low = filter.outside_q10 - outer;
  const int32_t high = filter.inside_q10 + outer;
  edge.outside_q10 = static_cast<int16_t>(low);
  edge.inside_q10 = static_cast<int16_t>(high);
  edge.scale = static_cast<uint16_t>((Filter::kEntries << 14) / (high - low));
  for (int32_t i = 0; i < Filter::kEntries; ++i) {
    const int32_t middle = low + ((2 * i + 1) * (high - low)) / 512;
    const auto both = [&filter, middle](int32_t way) noexcept {
      return filter.coverage(middle - way) + filter.coverage(middle + way);
    };
    const int32_t centre = filter.coverage(middle);
    // Twice what one of the two edges has.
    const int32_t on_outer = 4 * centre + 2 * both(outer);
    const int32_t off_outer = 4 * both(diagonal(outer));
    const int32_t on_inner = 2 * centre + both(inner);
    const int32_t off_inner = 2 * both(diagonal(inner));
    const int32_t sum_q17 = 2 * centre * supersampling.centre_q16 +
                            (on_inner + off_inner) * kInner +
                            (on_outer + off_outer) * kOuter;
    edge.table[i] = static_cast<uint8_t>((sum_q17 + (1 << 16)) >> 17);
  }
  return supersampling;
}

void detail::paint_supersampled(const GlyphField& field,
                                const TextStyle& style,
                                const void* options,
                                const FinePoint& origin,
                                const Sink& sink) {
  const auto& supersampling = *static_cast<const Supersampling*>(options);
  const Rect box = detail::visible_pixels(field, style, origin, sink.window);
  Sampling sampling(field, style, supersampling);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    draw_row(sampling, origin, box, y, sink);
  }
  if (supersampling.more_samples != nullptr) {
    *supersampling.more_samples += sampling.more_samples;
  }
}

}  // namespace inkcell
