// How a new field is written: quantised in the cell that introduces it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "field_model.hpp"

namespace inkcell {
namespace gen {

enum class FieldKind : uint8_t {
  axis,      // normal along an axis, straight
  axis_arc,  // normal along an axis, curved
  line,
  arc,
};

/// What a new field says in the stream. The anchor is the cell's centre.
struct FieldCode {
  FieldKind kind = FieldKind::line;
  int d0 = 0;     // distance at the anchor, in steps
  int angle = 0;  // axis: quarter turns; else steps of a turn / 2^angle_bits
  int bend = 0;   // sagitta at the reference length, in steps; arcs: not 0
};

/// The steps of a font, as its header states them (docs/FORMAT.md).
struct Quantisation {
  int d0_step_q6 = 32;    // [u, Q6]
  int bend_step_q6 = 48;  // [u, Q6]
  int d0_base = 8;        // bits in cells of up to 2^d0_log2 u
  int d0_log2 = 6;
  int angle_base = 8;                        // bits in cells of up to 32 u
  std::array<int, 4> bend_k = {4, 3, 2, 2};  // Golomb-Rice, by level

  /// For a tolerance of `e0_u` at the edge, and fields that reach `band_u`.
  static Quantisation make(double e0_u, double band_u);

  int d0_bits(int log2) const { return d0_base + std::max(0, log2 - d0_log2); }
  int angle_bits(int log2) const { return angle_base + std::max(0, log2 - 5); }
  int bend_bits(int bend, int log2) const {
    return 2 + ((std::abs(bend) - 1) >> bend_k[bend_level(log2)]) +
           bend_k[bend_level(log2)];
  }
  /// Largest |bend| that can be written.
  int most_bend(int log2) const { return 16 << bend_k[bend_level(log2)]; }

  static size_t bend_level(int log2) {
    return static_cast<size_t>(std::clamp(8 - log2, 0, 3));
  }
};

/// The reference length of the bend: half the cell, at least 32 u.
inline int bend_length_log2(int size_log2) {
  return size_log2 <= 6 ? 5 : size_log2 - 1;
}

/// The field that a decoder makes of a code, in a cell whose centre (rounded
/// down) is at (x, y). [u]
DirectField expand(const FieldCode& code,
                   const Quantisation& q,
                   int size_log2,
                   int x_u,
                   int y_u);

}  // namespace gen
}  // namespace inkcell
