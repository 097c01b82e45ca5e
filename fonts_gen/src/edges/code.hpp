// Fields in steps: the numbers that the encoder tries, and what they cost.
//
// Steps are as coarse as the tolerance allows, so that few codes need trying
// and cells that share a field find the same one.
#pragma once

#include <cstdint>

#include "target/target.hpp"

namespace inkcell {
namespace gen {

/// The kind of a field: bit 0 is set in arcs, bit 1 where the direction is any
/// and not one of the axes.
enum class PrimitiveKind : uint8_t {
  axis = 0,
  axis_arc = 1,
  line = 2,
  arc = 3
};

constexpr bool is_bent(PrimitiveKind kind) {
  return (static_cast<unsigned>(kind) & 1) != 0;
}
constexpr bool has_angle(PrimitiveKind kind) {
  return (static_cast<unsigned>(kind) & 2) != 0;
}

/// A field in steps, seen from its anchor: the centre of the square where it is
/// new.
struct PrimitiveCode {
  PrimitiveKind kind = PrimitiveKind::axis;
  int32_t d0 = 0;      // the distance at the anchor [d0_step]
  uint32_t angle = 0;  // quarters of a turn, or of 2^angle_bits a turn
  int32_t bend = 0;    // [bend_step]; 0 unless bent
};

/// A field as a record states it (format::edges).
struct PrimitiveNumbers {
  int16_t nx_q14 = 0;
  int16_t ny_q14 = 0;
  int16_t c_q4 = 0;      // [u]
  int16_t along_q4 = 0;  // [u], 0 unless bent
  int16_t bend = 0;      // [2^-19 / u], 0: a line
};

/// The steps, and the bits of their numbers in a square of 2^log2 u.
struct PrimitiveSteps {
  int d0_step = 0;       // [u/64]
  int bend_step = 0;     // [u/64]
  int d0_base = 0;       // [bits]
  int d0_log2 = 0;       // squares up to here take d0_base
  int angle_base = 0;    // [bits]
  int bend_low[4] = {};  // bits below the unary part, by level

  int d0_bits(int log2) const;
  int angle_bits(int log2) const;

  /// Bits of a bend, which is not 0: a Golomb-Rice code.
  int bend_bits(int bend, int log2) const;
  /// The largest bend that is tried.
  int most_bend(int log2) const;

  /// The distance of `d0_u` in steps, the nearest one that has a number.
  int quantised_d0(double d0_u, int log2) const;

  /// The length at which a bend is a sagitta in steps: half the square, at
  /// least 32 u. [log2]
  static int bend_length_log2(int log2) { return log2 <= 6 ? 5 : log2 - 1; }
};

/// The distance that makes an error of the tolerance at the edge. [u]
double e0_u(const Target& options);

/// Steps that keep the tolerance with room to spare.
PrimitiveSteps steps_for(const Target& options);

/// The numbers of a field that is new in a square of 2^log2 u, log2 up to 12,
/// with its anchor at (x_u, y_u), at most 2^13 in magnitude. Numbers that do
/// not fit are clamped.
PrimitiveNumbers field_numbers(const PrimitiveCode& code,
                               const PrimitiveSteps& steps,
                               int log2,
                               int x_u,
                               int y_u);

}  // namespace gen
}  // namespace inkcell
