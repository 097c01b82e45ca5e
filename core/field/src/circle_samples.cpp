// Samples of a pixel: the centre, four on an inner circle, eight on an outer.
//
//       o   o   o          The outer circle has two thirds of the filter's
//          i i             radius, the inner one a third. Of the outer one the
//       o   c   o          four on the axes come first: with the centre they
//          i i             tell whether the field bends or breaks there.
//       o   o   o
#include "inkcell/field/circle_samples.hpp"

#include "base/math.hpp"
#include "field_source.hpp"

namespace inkcell {
namespace {

using detail::abs;
using detail::circle_q10;
using detail::diagonal_q10;
using detail::FieldJob;
using detail::FieldPlace;
using detail::FieldSampler;
using detail::max;
using detail::min;

// Up to the first of these second differences a field counts as a plane, from
// the second on as none. [px, Q10]
constexpr int32_t kPlane = 64;
constexpr int32_t kBroken = 192;
constexpr int32_t kMeanQ8 = 35;

constexpr uint32_t kCross = 4;      // samples on the axes
constexpr uint32_t kDiagonals = 8;  // outer and inner ones, in turn

// CircleSamples::edge between its entries, which lie farther apart than those
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

// The samples of a pixel, one after the other.
class PixelSamples {
 public:
  PixelSamples(const CircleSamples& options, const FieldJob& job) noexcept
      : options_(options),
        style_(*job.style),
        filter_(style_.filter()),
        sampler_(job.field) {
    const int32_t outer = circle_q10(options_.radius_q10, 2);
    const int32_t inner = diagonal_q10(circle_q10(options_.radius_q10, 1));
    const int32_t corner = diagonal_q10(outer);
    reach_q16_ = static_cast<uint32_t>(abs(style_.right().x_q16) +
                                       abs(style_.right().y_q16));
    set(0, outer, 0);
    set(1, 0, outer);
    set(2, -outer, 0);
    set(3, 0, -outer);
    for (uint32_t i = 0; i < 4; ++i) {
      const int32_t right = i < 2 ? 1 : -1;
      const int32_t up = i == 1 || i == 2 ? 1 : -1;
      set(kCross + 2 * i, right * corner, up * corner);
      set(kCross + 2 * i + 1, right * inner, up * inner);
    }
  }

  uint8_t coverage(const FieldPlace& at) noexcept {
    at_ = at;
    centre_q10_ = distance_q10(at);
    if (sampler_.leaf().samples == nullptr && sampler_.has_room(reach_q16_)) {
      return sampler_.leaf().is_inside ? 255 : 0;
    }
    return static_cast<uint8_t>(options_.rule == SampleRule::even ? even()
                                                                  : paper());
  }

  ~PixelSamples() noexcept {
    if (options_.more_samples != nullptr) {
      *options_.more_samples += more_samples_;
    }
  }

 private:
  void set(uint32_t i, int32_t right_q10, int32_t up_q10) noexcept {
    const GlyphStep& right = style_.right();
    const GlyphStep& up = style_.up();
    // cppcheck-suppress constStatement ; it is assigned to
    x_q16_[i] = static_cast<int32_t>(
        (int64_t{right.x_q16} * right_q10 + int64_t{up.x_q16} * up_q10) >> 10);
    // cppcheck-suppress constStatement ; as above
    y_q16_[i] = static_cast<int32_t>(
        (int64_t{right.y_q16} * right_q10 + int64_t{up.y_q16} * up_q10) >> 10);
  }
  int32_t distance_q10(const FieldPlace& at) noexcept {
    return screen_distance_q10(style_, sampler_, at);
  }
  int32_t sample_q10(uint32_t i) noexcept {
    ++more_samples_;
    return distance_q10({at_.x_q16 + x_q16_[i], at_.y_q16 + y_q16_[i]});
  }
  int32_t even() noexcept;
  int32_t paper() noexcept;

  const CircleSamples& options_;
  const Style& style_;
  const Filter& filter_;
  FieldSampler sampler_;
  uint32_t reach_q16_;                  // a pixel along both axes [u]
  int32_t x_q16_[kCross + kDiagonals];  // from the centre [u]
  int32_t y_q16_[kCross + kDiagonals];
  FieldPlace at_ = {0, 0};
  int32_t centre_q10_ = 0;
  uint32_t more_samples_ = 0;
};

__attribute__((noinline)) int32_t PixelSamples::even() noexcept {
  const Filter& edge = options_.edge;
  // A saturated cell tells no more than that its own points are far.
  if ((centre_q10_ <= edge.outside_q10 || centre_q10_ >= edge.inside_q10) &&
      sampler_.leaf().samples != nullptr) {
    return edge_coverage(edge, centre_q10_);
  }
  int32_t cross[kCross];
  int32_t least = centre_q10_;
  int32_t most = centre_q10_;
  for (uint32_t i = 0; i < kCross; ++i) {
    cross[i] = sample_q10(i);
    least = min(least, cross[i]);
    most = max(most, cross[i]);
  }
  // The other eight lie between these, and distances change by no more than the
  // length of the step.
  const int32_t margin = circle_q10(options_.radius_q10, 2) >> 1;
  if (most <= filter_.outside_q10 - margin ||
      least >= filter_.inside_q10 + margin) {
    return most <= filter_.outside_q10 ? 0 : 255;
  }
  const int32_t across = cross[0] + cross[2] - 2 * centre_q10_;
  const int32_t upright = cross[1] + cross[3] - 2 * centre_q10_;
  const int32_t bend = max(abs(across), abs(upright));
  // Where the field bends a little its mean is a little elsewhere: the circles
  // are at a quarter of the sum, and at a quarter of that, with 0.43 of the
  // weight each.
  const int32_t mean_q10 =
      bend < kBroken ? centre_q10_ + (((across + upright) * kMeanQ8) >> 8)
                     : centre_q10_;
  const int32_t plane = edge_coverage(edge, mean_q10);
  if (bend <= kPlane) {
    return plane;
  }
  int32_t outer = 0;
  int32_t inner = 0;
  for (const int32_t distance : cross) {
    outer += filter_.coverage(distance);
  }
  for (uint32_t i = kCross; i < kCross + kDiagonals; i += 2) {
    outer += filter_.coverage(sample_q10(i));
    inner += filter_.coverage(sample_q10(i + 1));
  }
  const int32_t sum_q16 =
      filter_.coverage(centre_q10_) * CircleSamples::kCentreQ16 +
      inner * CircleSamples::kInnerQ16 + outer * CircleSamples::kOuterQ16;
  const int32_t mean = (sum_q16 + (1 << 15)) >> 16;
  return bend >= kBroken
             ? mean
             : plane + (mean - plane) * (bend - kPlane) / (kBroken - kPlane);
}

// 13 samples where a cell is no wider than half the radius, 5 where it is no
// wider than that.
__attribute__((noinline)) int32_t PixelSamples::paper() noexcept {
  // What a saturated cell reports is clamped to what cannot change coverage.
  const int32_t low = filter_.outside_q10 - options_.radius_q10;
  const int32_t high = filter_.inside_q10 + options_.radius_q10;
  // Widths as the radius has them: 2^log2 u in px, Q10.
  const int32_t width_q10 =
      style_.to_px_q10(int32_t{1} << (10 + sampler_.leaf().size_log2));
  if (width_q10 > options_.radius_q10 ||
      (sampler_.leaf().samples != nullptr &&
       (centre_q10_ < low || centre_q10_ > high))) {
    return filter_.coverage(centre_q10_);
  }
  const auto clamped = [low, high](int32_t distance_q10) noexcept {
    return min(max(distance_q10, low), high);
  };
  int64_t outer = 0;
  for (uint32_t i = 0; i < kCross; ++i) {
    outer += clamped(sample_q10(i));
  }
  const int64_t centre = clamped(centre_q10_);
  if (2 * width_q10 > options_.radius_q10) {
    const int32_t sum =
        CircleSamples::kCentreQ16 + 4 * CircleSamples::kOuterQ16;
    return filter_.coverage(
        static_cast<int32_t>((centre * CircleSamples::kCentreQ16 +
                              outer * CircleSamples::kOuterQ16) /
                             sum));
  }
  int64_t inner = 0;
  for (uint32_t i = kCross; i < kCross + kDiagonals; i += 2) {
    outer += clamped(sample_q10(i));
    inner += clamped(sample_q10(i + 1));
  }
  return filter_.coverage(static_cast<int32_t>(
      (centre * CircleSamples::kCentreQ16 + inner * CircleSamples::kInnerQ16 +
       outer * CircleSamples::kOuterQ16) >>
      16));
}

void plan_samples(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  plan.ink_margin_q8 +=
      static_cast<const CircleSamples&>(effect).radius_q10 >> 2;
}

void mix_samples(const Effect& effect, GlyphBand& glyph) noexcept {
  const auto& job = static_cast<const FieldJob&>(glyph);
  const detail::Band& band = job.band;
  PixelSamples samples(static_cast<const CircleSamples&>(effect), job);
  for (int32_t row = 0; row != band.rows; ++row) {
    FieldPlace place =
        job.rows.place_of(job.band_x_q8(), job.band_y_q8() + 256 * row);
    place.move(job.rows.right(), job.column);
    uint8_t* at = band.row(row) + job.column;
    for (uint8_t* const end = band.row(row) + band.last_column + 1; at != end;
         ++at) {
      *at = samples.coverage(place);
      place.move(job.rows.right(), 1);
    }
  }
  glyph.emit();
}

bool can_sample(const Effect&, const Style& style, bool is_field) noexcept {
  return is_field && !style.is_stretched();
}

}  // namespace

const Mixer detail::kCircleSamplesMixer = {nullptr, plan_samples, mix_samples,
                                           can_sample};

}  // namespace inkcell
