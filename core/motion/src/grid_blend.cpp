// One pass over the samples, one over their histogram.
#include "inkcell/motion/grid_blend.hpp"

#include "base/known_span.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

bool fit(const DistanceGrid& a, const DistanceGrid& b) noexcept {
  return a.width() == b.width() && a.height() == b.height() &&
         a.scale_log2() == b.scale_log2();
}

void count_in(int32_t sample, GridHistogram& histogram) noexcept {
  uint16_t& bin = histogram.bins[(sample + 128) >> 1];
  bin = static_cast<uint16_t>(bin + (bin != UINT16_MAX ? 1 : 0));
}

// The cutoff above which samples cover `wanted`. [1/16 of a sample, Q8]
int32_t cutoff_of(const GridHistogram& histogram, uint32_t wanted) noexcept {
  constexpr int32_t kHalfSample = 8;  // [bins]
  constexpr int32_t kBinLog2 = 9;     // [Q13]
  const auto count = [&](int32_t bin) -> uint32_t {
    return bin >= 0 && bin < GridHistogram::kBins ? histogram.bins[bin] : 0;
  };
  // From the inside outwards. The coverage of a sample is a ramp of one sample:
  // each bin adds 1/16 of the samples on the ramp.
  uint32_t area = 0;
  uint32_t on_ramp = 0;
  int32_t edge = GridHistogram::kBins + kHalfSample;
  while (edge > -kHalfSample) {
    on_ramp += count(edge - kHalfSample - 1);
    on_ramp -= count(edge + kHalfSample - 1);
    if (area + on_ramp * 256 > wanted) {
      break;
    }
    area += on_ramp * 256;
    --edge;
  }
  const auto rest =
      on_ramp == 0 ? 0 : static_cast<int32_t>(((wanted - area) << 1) / on_ramp);
  // Plus half a bin: the ramp is counted from the lower ends of bins.
  return edge * (1 << kBinLog2) - rest - (1 << 15) - (1 << (kBinLog2 - 1));
}

}  // namespace

Fixed<int32_t, 13> blend(const DistanceGrid& a,
                         const DistanceGrid& b,
                         const GridBlend& how,
                         DistanceGrid& out,
                         GridHistogram& scratch) noexcept {
  if (!fit(a, b) || !fit(a, out)) {
    return {};
  }
  scratch = {};
  const int32_t part = clamp(how.part_q8, 0, 256);
  // Rounded to nearest.
  const int32_t off_a = 128 - clamp(how.depth_a, 0, 255) * part;
  const int32_t off_b = 128 - clamp(how.depth_b, 0, 255) * (256 - part);
  const int32_t count = a.width() * a.height();
  const int8_t* from_a = a.row(0);
  const int8_t* from_b = b.row(0);
  int8_t* to = out.row(0);
  for (int32_t i = 0; i < count; ++i) {
    const int32_t at_a = from_a[i] * 256;
    const int32_t at_b = from_b[i] * 256;
    const int32_t moved = at_a + (from_b[i] - from_a[i]) * part + 128;
    const int32_t thin_a = at_a + off_a;
    const int32_t thin_b = at_b + off_b;
    const int32_t most = max(moved, max(thin_a, thin_b)) >> 8;
    to[i] = static_cast<int8_t>(most);
    count_in(most, scratch);
  }
  if (part == 0 || part == 256) {
    return {};
  }
  constexpr int32_t kMostArea = DistanceGrid::kMaxSide * DistanceGrid::kMaxSide;
  const auto area_a = static_cast<uint32_t>(clamp(how.area_a, 0, kMostArea));
  const auto area_b = static_cast<uint32_t>(clamp(how.area_b, 0, kMostArea));
  const auto second = static_cast<uint32_t>(part);
  return Fixed<int32_t, 13>::from_raw(
      cutoff_of(scratch, (area_a * (256 - second) + area_b * second) / 4));
}

Fixed<int32_t, 13> cutoff_for(const DistanceGrid& grid,
                              int32_t area,
                              GridHistogram& scratch) noexcept {
  scratch = {};
  // Other samples are kOutside, beyond every ramp.
  for (int32_t y = 0; y < grid.height(); ++y) {
    const int8_t* row = grid.row(y);
    const detail::KnownSpan known = detail::known_span(row, grid.width());
    for (int32_t x = known.first; x < known.end; ++x) {
      count_in(row[x], scratch);
    }
  }
  // From 1/64 of a sample to 1/16, Q8; at most 2^26.
  const auto wanted = static_cast<uint32_t>(area < 0 ? 0 : area) * 64;
  return Fixed<int32_t, 13>::from_raw(cutoff_of(scratch, wanted));
}

}  // namespace inkcell::motion
