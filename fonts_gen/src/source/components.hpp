// Components of composite glyphs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace inkcell::gen {

/// A matrix of Q14 numbers: xx xy yx yy.
using MatrixQ14 = std::array<int, 4>;

/// a b + c d of Q14 numbers.
inline int sum_q14(int64_t a, int64_t b, int64_t c, int64_t d) {
  return static_cast<int>((a * b + c * d + (1 << 13)) >> 14);
}

/// Maps by `n`, then by `m`.
inline MatrixQ14 product(const MatrixQ14& m, const MatrixQ14& n) {
  return {sum_q14(m[0], n[0], m[1], n[2]), sum_q14(m[0], n[1], m[1], n[3]),
          sum_q14(m[2], n[0], m[3], n[2]), sum_q14(m[2], n[1], m[3], n[3])};
}

/// Another glyph's outline, moved and transformed: a component of a composite.
struct OutlineReference {
  static constexpr int kOne_q14 = 1 << 14;

  size_t glyph = 0;  // number in the font
  int dx = 0;        // [font units]
  int dy = 0;
  /// x' = xx x + xy y + dx, y' = yx x + yy y + dy.
  MatrixQ14 matrix_q14 = {kOne_q14, 0, 0, kOne_q14};

  bool has_matrix() const {
    return matrix_q14 != MatrixQ14{kOne_q14, 0, 0, kOne_q14};
  }
};

using OutlineReferences = std::vector<OutlineReference>;

}  // namespace inkcell::gen
