// Sub-pixels of cells: a distance for each stripe of a pixel, and from how it
// changes between them how steep their ramp is.
#include "inkcell/lcd.hpp"

#include "effects/lcd_stripes.hpp"
#include "effects/mixed_cells.hpp"
#include "raster/paint_leaf.hpp"

namespace inkcell {
namespace detail {
namespace {

// How much steeper than the filter the ramp of a stripe is, by 1/32 of the
// gradient's component across the stripes: a stripe is a third of a pixel wide
// and a pixel long, and a straight edge of normal (n, m) covers it over a
// distance of n / 3 + m. [Q8]
constexpr uint16_t kSteepness[33] = {
    256, 253, 251, 249, 248, 246, 245, 244, 243, 243, 243,
    243, 243, 244, 245, 246, 248, 250, 252, 255, 259, 263,
    268, 274, 281, 289, 300, 313, 330, 353, 388, 448, 768};

// How far the flattest ramp of all reaches beyond the filter's, and from a
// stripe to the next. [px, Q8]
constexpr int32_t kFlattest = 16;
constexpr int32_t kThird = 86;

// Of a pixel's stripes. [px]
struct Distances {
  int32_t before_q10;
  int32_t middle_q10;
  int32_t behind_q10;
};

// From distances at a pixel's stripes to their coverages.
class StripeRamp {
 public:
  explicit StripeRamp(const Filter& filter) noexcept
      : centre_q10_((filter.outside_q10 + filter.inside_q10) >> 1),
        first_q10_(centre_q10_ - filter.outside_q10 - 1),
        steps_(static_cast<uint32_t>(filter.inside_q10 - filter.outside_q10) -
               1),
        scale_(filter.scale),
        table_(filter.table) {}

  // `out`: a pixel that is 0. [px]
  __attribute__((always_inline)) void cover(const Distances& distances,
                                            uint8_t* out) const noexcept {
    const int32_t before = distances.before_q10 - centre_q10_;
    const int32_t middle = distances.middle_q10 - centre_q10_;
    const int32_t behind = distances.behind_q10 - centre_q10_;
    const int32_t change = max(abs(middle - before), abs(behind - middle));
    const int32_t steepness = kSteepness[min((3 * change + 16) >> 5, 32)];
    out[0] = coverage(before * steepness);
    out[1] = coverage(middle * steepness);
    out[2] = coverage(behind * steepness);
  }
  // Whether all of a pixel is so far from the edge as its middle says.
  bool is_far(int32_t middle_q10) const noexcept {
    constexpr uint32_t kMore = 4 * (kFlattest + kThird);
    return static_cast<uint32_t>(middle_q10 - centre_q10_ + first_q10_) +
               kMore >=
           steps_ + 2 * kMore;
  }

 private:
  // Filter::coverage of what is so far from the centre. [px, Q18]
  __attribute__((always_inline)) uint8_t coverage(
      int32_t way_q18) const noexcept {
    const auto step = static_cast<uint32_t>(first_q10_ + (way_q18 >> 8));
    if (step < steps_) {
      return table_[static_cast<uint8_t>((step + 1) * scale_ >> 14)];
    }
    return static_cast<uint8_t>(~(wrapped(step) >> 31));
  }

  int32_t centre_q10_;
  int32_t first_q10_;  // from the centre to the ramp's first step
  uint32_t steps_;     // of the ramp
  uint32_t scale_;
  const uint8_t* table_;
};

// kCount primitives of a leaf at a pixel's stripes: in the middle, and along
// their tangents, beyond the cell if need be. What rounding a vertex changes in
// the middle it changes in all of them.
template <uint32_t kCount>
class PrimitiveStripes : public Cursor {
 public:
  PrimitiveStripes(const CellBand& band,
                   TileLeaf& leaf,
                   const GlyphPoint& first) noexcept
      : Cursor(band.map(), first),
        band_(band),
        leaf_(leaf),
        sign_(kCount == 1 ? 0 : leaf.sign) {
    const GlyphPoint& next = band.stripes()->next;
    const PixelPlace way = {q8_of(next.x_q20), q8_of(next.y_q20)};
    for (uint32_t i = 0; i < kCount; ++i) {
      Part& part = parts_[i];
      part.arc = ArcValue(leaf.parts[i], band.scale(), 0);
      const LineValue& plane = part.arc.plane;
      part.step_q22 = wrapped(times(plane.nx_q14, way.x_q8) +
                              times(plane.ny_q14, way.y_q8));
      part.along_q14 = wrapped(times(plane.nx_q14, way.y_q8) -
                               times(plane.ny_q14, way.x_q8)) >>
                       8;
    }
  }

  // The distance in the middle. [px]
  int32_t middle_q10() noexcept {
    const PixelPlace at = place();
    for (uint32_t i = 0; i < kCount; ++i) {
      const ArcValue& arc = parts_[i].arc;
      uint32_t value_q22 = arc.plane.plane_q22(at);
      slopes_q15_[i] = 0;
      if (arc.bend != 0) {
        const uint32_t along_q8 = arc.along_q8(at);
        const int32_t slope = arc.slope_q15(along_q8, band_.bend_shift());
        slopes_q15_[i] = slope;
        value_q22 +=
            static_cast<uint32_t>(wrapped(times(slope, along_q8)) >> 1);
      }
      values_[i] = with_sign(wrapped(value_q22), sign_);
    }
    const int32_t middle_q22 = combine<kCount>(
        band_, leaf_, sign_,
        [&](uint32_t i) __attribute__((always_inline)) { return values_[i]; },
        [&]() __attribute__((always_inline)) { return at; });
    if (kCount != 1) {
      rounding_q22_ = middle_q22 - with_sign(least(values_), sign_);
    }
    return middle_q22 >> 12;
  }
  // The same of the stripes beside it.
  __attribute__((always_inline)) void beside(
      Distances& distances) const noexcept {
    int32_t before[kCount];
    int32_t behind[kCount];
    for (uint32_t i = 0; i < kCount; ++i) {
      const Part& part = parts_[i];
      const auto slope_q15 = static_cast<uint32_t>(slopes_q15_[i]);
      const int32_t step_q22 = with_sign(
          part.step_q22 + (wrapped(times(part.along_q14, slope_q15)) >> 6),
          sign_);
      before[i] = values_[i] - step_q22;
      behind[i] = values_[i] + step_q22;
    }
    distances.before_q10 =
        (with_sign(least(before), sign_) + rounding_q22_) >> 12;
    distances.behind_q10 =
        (with_sign(least(behind), sign_) + rounding_q22_) >> 12;
  }

 private:
  struct Part {
    ArcValue arc;
    int32_t step_q22;  // from stripe to stripe, and of w
    int32_t along_q14;
  };

  // With the leaf's sign; no vertex is rounded.
  __attribute__((always_inline)) int32_t least(
      const int32_t* values) const noexcept {
    if constexpr (kCount == 1) {
      return values[0];
    } else if constexpr (kCount == 2) {
      return min(values[0], values[1]);
    } else {
      return min(values[0], leaf_.is_nested ? max(values[1], values[2])
                                            : min(values[1], values[2]));
    }
  }

  const CellBand& band_;
  TileLeaf& leaf_;
  int32_t sign_;
  int32_t rounding_q22_ = 0;
  int32_t slopes_q15_[kCount];  // k w
  int32_t values_[kCount];
  Part parts_[kCount];
};

// Any leaf: of samples, or where edges are stretched differently.
class AnyStripes : public PointCursor {
 public:
  AnyStripes(const CellBand& band,
             TileLeaf& leaf,
             const GlyphPoint& first) noexcept
      : PointCursor(band.map(), leaf, first), band_(band), leaf_(leaf) {}

  int32_t middle_q10() const noexcept { return distance_q10(at); }

  void beside(Distances& distances) const noexcept {
    const GlyphPoint& next = band_.stripes()->next;
    distances.before_q10 =
        distance_q10({at.x_q16 - next.x_q16, at.y_q16 - next.y_q16,
                      at.x_q20 - next.x_q20, at.y_q20 - next.y_q20});
    distances.behind_q10 =
        distance_q10({at.x_q16 + next.x_q16, at.y_q16 + next.y_q16,
                      at.x_q20 + next.x_q20, at.y_q20 + next.y_q20});
  }

 private:
  int32_t distance_q10(const GlyphPoint& place) const noexcept {
    const Stretching* const stretching = band_.stretching();
    if (leaf_.has_primitives()) {
      return stretching->value(band_, leaf_, place.place()) >> 12;
    }
    // Samples tell nothing of what is beyond their cell.
    constexpr int32_t kFarQ10 = 1 << 16;
    Leaf leaf;
    leaf.saturate(false);
    if (is_in_grid(map.field, place)) {
      find_leaf(map.field, place.x_q16 >> 16, place.y_q16 >> 16, leaf);
    }
    if (leaf.count == 0) {
      return leaf.is_inside ? kFarQ10 : -kFarQ10;
    }
    const uint32_t in_cell = (1u << (leaf.size_log2 + 16)) - 1;
    const uint32_t x_q16 = place.x_q16 & in_cell;
    const uint32_t y_q16 = place.y_q16 & in_cell;
    return stretching != nullptr
               ? stretching->samples_value(band_, leaf, x_q16, y_q16) >> 12
               : map.style.to_px_q10(samples_distance_q10(
                     leaf.parts[0], leaf.size_log2, x_q16, y_q16));
  }

  const CellBand& band_;
  TileLeaf& leaf_;
};

template <typename Values>
__attribute__((noinline)) void paint_leaf(const CellBand& band,
                                          TileLeaf& leaf,
                                          const GlyphPoint& first) noexcept {
  const StripeRamp ramp(band.map().style.filter());
  Values values(band, leaf, first);
  uint8_t* out = leaf.line;
  const TileSpan* span = leaf.spans;
  int32_t count = span == nullptr ? leaf.width : span->end - span->begin;
  for (int32_t rows = leaf.height;;) {
    for (uint8_t* const end = out + 3 * count; out != end; out += 3) {
      Distances distances;
      distances.middle_q10 = values.middle_q10();
      if (!ramp.is_far(distances.middle_q10)) {
        values.beside(distances);
        ramp.cover(distances, out);
      } else if (distances.middle_q10 > 0) {
        out[0] = out[1] = out[2] = 255;
      }
      values.advance(1);
    }
    if (--rows == 0) {
      return;
    }
    int32_t back = -count;
    if (span != nullptr) {
      back = span[1].begin - span->end;
      ++span;
      count = span->end - span->begin;
    }
    values.next_row(leaf, back);
    out += 3 * (kTileColumns + back);
  }
}

void fill_leaf(const TileLeaf& leaf) noexcept {
  for (int32_t row = 0; row < leaf.height; ++row) {
    const TileSpan* const span = leaf.spans;
    const int32_t shift = span == nullptr ? 0 : span[row].begin - span->begin;
    const int32_t count =
        span == nullptr ? leaf.width : span[row].end - span[row].begin;
    CellBand::fill_inside(leaf.line + 3 * (row * kTileColumns + shift),
                          3 * count);
  }
}

void paint_stripes(const CellBand& band,
                   TileLeaf& leaf,
                   const GlyphPoint& at) noexcept {
  if (leaf.count == 0) {
    fill_leaf(leaf);
  } else if (band.stretching() != nullptr || !leaf.has_primitives()) {
    paint_leaf<AnyStripes>(band, leaf, at);
  } else if (leaf.count == 1) {
    paint_leaf<PrimitiveStripes<1>>(band, leaf, at);
  } else if (leaf.count == 2) {
    paint_leaf<PrimitiveStripes<2>>(band, leaf, at);
  } else {
    paint_leaf<PrimitiveStripes<3>>(band, leaf, at);
  }
}

void mix_lcd_cells(GlyphJob& job) {
  const int32_t stride = job.band.stride;
  const auto& lcd =
      *static_cast<const LcdOptions*>(job.style->effect().options);
  if (is_vertical(lcd.order)) {
    mix_stripes(job, {2 - stride, 1, stride, 3, stride});
  } else {
    mix_stripes(job, {-1, 1, 3, 3, stride});
  }
}

}  // namespace

void paint_lcd(const GlyphField& field,
               const TextStyle& style,
               const void* options,
               const FinePoint& origin,
               const Sink& sink) {
  const auto& lcd = *static_cast<const LcdOptions*>(options);
  BandPlan plan;
  plan.widen(style.filter());
  plan.outside_q8 += kFlattest + kThird;
  plan.inside_q8 += kFlattest + kThird;
  // A channel takes a stripe of each pixel beside it.
  const auto third = [](const GlyphStep& step) noexcept {
    return GlyphStep{step.x_q16 / 3, step.y_q16 / 3, step.x_q20 / 3,
                     step.y_q20 / 3};
  };
  Stripes stripes = {{}, paint_stripes, CellBand::cover_stripes};
  if (is_vertical(lcd.order)) {
    plan.margin_y = 1;
    stripes.next.advance(third(style.up()), UINT32_MAX);
  } else {
    plan.margin_x = 1;
    stripes.next.advance(third(style.right()));
  }
  plan.shown_q8 = plan.outside_q8;
  mix_cells(field, style, origin, sink, plan, &stripes, mix_lcd_cells);
}

}  // namespace detail
}  // namespace inkcell
