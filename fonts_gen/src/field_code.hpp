// The steps in which a font states its fields, and what a field costs.
#pragma once

#include <array>
#include <cstdint>

#include "adf.hpp"
#include "inkcell/packed.hpp"

namespace inkcell {
namespace gen {

/// The distance that makes an error of the tolerance at the edge. [u]
double e0_u(const AdfOptions& options);

/// Steps that keep the tolerance with room to spare.
PackedCoding coding_for(const AdfOptions& options);

/// The bytes of `coding` in the font's header.
std::array<uint8_t, 8> coding_bytes(const PackedCoding& coding);

/// Bits of a distance and of an angle in a square of 2^log2 u.
inline int d0_bits(const PackedCoding& coding, int log2) {
  return static_cast<int>(coding.d0_bits(static_cast<uint32_t>(log2)));
}
inline int angle_bits(const PackedCoding& coding, int log2) {
  return static_cast<int>(coding.angle_bits(static_cast<uint32_t>(log2)));
}

/// The distance of `d0_u` in steps, as near as it can be written.
int quantised_d0(const PackedCoding& coding, double d0_u, int log2);

/// Bits of a bend, which is not 0, in a square of 2^log2 u.
int bend_bits(const PackedCoding& coding, int bend, int log2);

/// The largest bend that can be written.
int most_bend(const PackedCoding& coding, int log2);

/// The length at which a bend is a sagitta in steps: half the square, at least
/// 32 u. [log2]
inline int bend_length_log2(int log2) {
  return log2 <= 6 ? 5 : log2 - 1;
}

}  // namespace gen
}  // namespace inkcell
