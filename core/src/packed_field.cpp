// The numbers of new fields: what the packed coding's steps stand for.
#include "inkcell/format.hpp"
#include "inkcell/packed.hpp"

namespace inkcell {
namespace {

constexpr uint32_t kQuarterLog2 = 8;
constexpr uint32_t kQuarterSteps = 1 << kQuarterLog2;

// A quarter of a sine wave. [Q15]
struct Sines {
  uint16_t q15[kQuarterSteps + 1];
};

// The Taylor series with integers: terms above 2^-30 are all it takes.
constexpr Sines make_sines() noexcept {
  constexpr int64_t kHalfTurnQ30 = 3373259426;  // pi
  Sines sines = {};
  for (uint32_t i = 0; i <= kQuarterSteps; ++i) {
    const int64_t x = (kHalfTurnQ30 * i) >> (kQuarterLog2 + 1);
    const int64_t square = (x * x) >> 30;
    int64_t term = x;
    int64_t sum = x;
    for (int64_t n = 2; n < 20; n += 2) {
      term = -((term * square) >> 30) / (n * (n + 1));
      sum += term;
    }
    sines.q15[i] = static_cast<uint16_t>((sum + (1 << 14)) >> 15);
  }
  return sines;
}

constexpr Sines kSines = make_sines();
static_assert(kSines.q15[kQuarterSteps] == 1 << 15, "sine of a quarter turn");

// The sine of 2^-16 turns, off by less than 1. [Q14]
int32_t sine_q14(uint32_t turn) noexcept {
  constexpr uint32_t kQuarter = 1 << 14;
  constexpr uint32_t kFractionBits = 14 - kQuarterLog2;
  uint32_t along = turn & (kQuarter - 1);
  if ((turn & kQuarter) != 0) {
    along = kQuarter - along;
  }
  const uint32_t i = along >> kFractionBits;
  const int32_t fraction =
      static_cast<int32_t>(along & ((1 << kFractionBits) - 1));
  const int32_t low = kSines.q15[i];
  const int32_t high = kSines.q15[fraction == 0 ? i : i + 1];
  const int32_t sum = (low << kFractionBits) + (high - low) * fraction;
  const int32_t sine = (sum + (1 << kFractionBits)) >> (kFractionBits + 1);
  return (turn & 2 * kQuarter) != 0 ? -sine : sine;
}

int16_t clamp(int32_t value, int32_t low) noexcept {
  if (value < low) {
    return static_cast<int16_t>(low);
  }
  return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX : value);
}

// Products and sums that may wrap.
uint32_t times(int32_t a, int32_t b) noexcept {
  return static_cast<uint32_t>(a) * static_cast<uint32_t>(b);
}

// Half the curvature of `bend` steps, each of which is a sagitta in the middle
// of a chord of the square's width, or of 64 u in smaller squares.
int16_t curvature(int32_t bend,
                  const PackedCoding& coding,
                  uint32_t log2) noexcept {
  const int32_t length_log2 = log2 <= 6 ? 5 : static_cast<int32_t>(log2) - 1;
  const int32_t shift = 13 - 2 * length_log2;
  // Any bend: the clamp is far above what streams can state, so that nothing
  // below overflows.
  constexpr int32_t kMost = 1 << 19;
  bend = bend > kMost ? kMost : bend;
  bend = bend < -kMost ? -kMost : bend;
  const int32_t steps = bend * coding.bend_step;
  const int32_t k = shift >= 0 ? steps * (1 << shift)
                               : (steps + (1 << (-shift - 1))) >> -shift;
  return clamp(k, -INT16_MAX);
}

}  // namespace

PackedCoding PackedCoding::read(const uint8_t* quantisation) noexcept {
  namespace at = format::quantisation;
  PackedCoding coding;
  coding.d0_step = quantisation[at::kD0Step];
  coding.bend_step = quantisation[at::kBendStep];
  coding.d0_base = quantisation[at::kD0Base];
  coding.d0_log2 = quantisation[at::kD0Log2];
  coding.angle_base = quantisation[at::kAngleBase];
  coding.bend_k = static_cast<uint16_t>(quantisation[at::kBendBits] |
                                        quantisation[at::kBendBits + 1] << 8);
  return coding;
}

FieldNumbers expand_field(const FieldCode& code,
                          const PackedCoding& coding,
                          uint32_t log2,
                          int32_t x_u,
                          int32_t y_u) noexcept {
  const uint32_t turn =
      code.angle << (has_angle(code.kind) ? 16 - coding.angle_bits(log2) : 14);
  const int32_t nx = sine_q14(turn + (1 << 14));
  const int32_t ny = sine_q14(turn);
  // 1/64 u are 256 in Q14.
  const uint32_t d0_q14 = times(code.d0, coding.d0_step * 256);
  const uint32_t dot_q14 = times(nx, x_u) + times(ny, y_u);
  FieldNumbers field;
  field.nx_q14 = static_cast<int16_t>(nx);
  field.ny_q14 = static_cast<int16_t>(ny);
  field.c_q4 =
      clamp(static_cast<int32_t>(d0_q14 - dot_q14 + 512) >> 10, INT16_MIN);
  if (is_bent(code.kind)) {
    field.bend = curvature(code.bend, coding, log2);
  }
  if (field.bend != 0) {
    const uint32_t cross_q14 = times(nx, y_u) - times(ny, x_u);
    field.along_q4 =
        clamp(static_cast<int32_t>(512 - cross_q14) >> 10, INT16_MIN);
  }
  return field;
}

}  // namespace inkcell
