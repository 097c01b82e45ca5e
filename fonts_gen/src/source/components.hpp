// Components of composite glyphs.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace inkcell::gen {

/// Another glyph's outline, moved and transformed: a component of a composite.
struct OutlineReference {
  static constexpr int kOne_q14 = 1 << 14;

  size_t glyph = 0;  // number in the font
  int dx = 0;        // [font units]
  int dy = 0;
  /// x' = xx x + xy y + dx, y' = yx x + yy y + dy.
  std::array<int, 4> matrix_q14 = {kOne_q14, 0, 0, kOne_q14};  // xx xy yx yy

  bool has_matrix() const {
    return matrix_q14 != std::array<int, 4>{kOne_q14, 0, 0, kOne_q14};
  }
};

using OutlineReferences = std::vector<OutlineReference>;

}  // namespace inkcell::gen
