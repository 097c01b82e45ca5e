// Records of outlines and composites (docs/FORMAT.md, "Glyph record").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "outline_code.hpp"
#include "outline_steps.hpp"

namespace inkcell::gen {

/// The record of a glyph with ink. `code` has a word for every step.
///
/// Throws GeometryError::too_large if it has not.
std::vector<uint8_t> outline_record(const std::vector<OutlineStep>& steps,
                                    const OutlineCode& code);

/// Bits of that record before trailing zeros are left out.
size_t outline_bits(const std::vector<OutlineStep>& steps,
                    const OutlineCode& code);

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

/// Whether all numbers fit a record, and no matrix mirrors.
bool fits_record(const OutlineReferences& references);

/// The record of a glyph of one component or more that fits_record().
std::vector<uint8_t> composite_record(const OutlineReferences& references);

/// Bits of that record before trailing zeros are left out.
size_t composite_bits(const OutlineReferences& references);

}  // namespace inkcell::gen
