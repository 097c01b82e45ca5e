#include "field_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "inkcell/format.hpp"

namespace inkcell {
namespace gen {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Steps in e0, that of the angle so far from the anchor. Coarser ones make more
// cells and little less bytes; of finer ones that of the distance pays best.
constexpr double kDistanceStep = 0.25;
constexpr double kAngleStep = 0.5;
constexpr double kAngleReach_u = 24;
constexpr double kBendStep = 0.75;

// Golomb-Rice parameters of levels 0 to 3 at an e0 of 1 u: four bits each.
constexpr int kBendBits[] = {4, 3, 2, 2};
constexpr int kMostBendBits = 6;

// A unary part of this length is not valid.
constexpr int kUnaryLimit = 16;

int whole(double value, int least, int most) {
  return std::clamp(static_cast<int>(std::lround(value)), least, most);
}

}  // namespace

double e0_u(const AdfOptions& options) {
  return options.tolerance / 255 * 1024 / options.max_px;
}

PackedCoding coding_for(const AdfOptions& options) {
  const double e0 = e0_u(options);
  PackedCoding coding;
  const double step = 64 * kDistanceStep * e0;
  coding.d0_step = static_cast<uint8_t>(whole(step, 1, 255));
  coding.bend_step = static_cast<uint8_t>(whole(64 * kBendStep * e0, 1, 255));
  coding.d0_log2 =
      static_cast<uint8_t>(whole(std::ceil(std::log2(band_u(options))), 4, 8));
  const double range = 2 * std::ldexp(64.0, coding.d0_log2) / coding.d0_step;
  coding.d0_base =
      static_cast<uint8_t>(whole(std::ceil(std::log2(range)), 4, 16));
  const double turn = 2 * kPi * kAngleReach_u / (kAngleStep * e0);
  coding.angle_base = static_cast<uint8_t>(whole(std::log2(turn), 4, 10));
  for (int level = 0; level < 4; ++level) {
    const int bits = whole(kBendBits[level] - std::log2(e0), 0, kMostBendBits);
    coding.bend_k = static_cast<uint16_t>(coding.bend_k | bits << 4 * level);
  }
  return coding;
}

std::array<uint8_t, 8> coding_bytes(const PackedCoding& coding) {
  namespace at = format::quantisation;
  static_assert(at::kBytes == 8, "");
  std::array<uint8_t, 8> bytes{};
  bytes[at::kD0Step] = coding.d0_step;
  bytes[at::kBendStep] = coding.bend_step;
  bytes[at::kD0Base] = coding.d0_base;
  bytes[at::kD0Log2] = coding.d0_log2;
  bytes[at::kAngleBase] = coding.angle_base;
  bytes[at::kBendBits] = static_cast<uint8_t>(coding.bend_k);
  bytes[at::kBendBits + 1] = static_cast<uint8_t>(coding.bend_k >> 8);
  return bytes;
}

int quantised_d0(const PackedCoding& coding, double d0_u, int log2) {
  const int most = 1 << (d0_bits(coding, log2) - 1);
  return whole(d0_u * 64 / coding.d0_step, -most, most - 1);
}

int bend_bits(const PackedCoding& coding, int bend, int log2) {
  const auto k =
      static_cast<int>(coding.bend_bits(static_cast<uint32_t>(log2)));
  return 2 + k + ((std::abs(bend) - 1) >> k);
}

int most_bend(const PackedCoding& coding, int log2) {
  return kUnaryLimit << coding.bend_bits(static_cast<uint32_t>(log2));
}

}  // namespace gen
}  // namespace inkcell
