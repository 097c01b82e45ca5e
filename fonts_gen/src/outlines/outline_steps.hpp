// An outline as the steps that its record stores.
#pragma once

#include <cstdint>
#include <vector>

#include "outlines/minimal_outline.hpp"

namespace inkcell::gen {

/// The meaning of a code word. The values are those of the code table.
enum class WordKind : uint8_t { off_curve, smooth, corner, end };

/// A step from one point to the next, or the end of a contour. [grid units]
struct OutlineStep {
  WordKind kind;
  int dx;
  int dy;
};

struct GridPosition {
  int x;
  int y;
};

/// Most bits of dx and dy.
inline constexpr int kMostStepBits = 15;

/// Bits of `value` in two's complement; 0 has none.
inline int step_bits(int value) {
  int bits = 0;
  if (value != 0) {
    const unsigned rest = static_cast<unsigned>(value < 0 ? ~value : value);
    for (bits = 1; rest >> (bits - 1) != 0; ++bits) {
    }
  }
  return bits;
}

/// The start of a record's steps: the lower left corner of the glyph's box in
/// METR [font units], rounded down to the grid of 2^grid_shift font units.
GridPosition record_start(int x_min, int y_min, int grid_shift);

/// The steps of `outline` from `start`, with an `end` after each contour. Lines
/// and curves with steps of more than 15 bits are halved until all fit; the
/// added points are rounded to the grid.
///
/// Throws GeometryError::too_complex if a coordinate exceeds +-2^19, a contour
/// begins more than 15 bits from the point before it, or the outline has too
/// many points for the format. With a coarser grid it may fit.
std::vector<OutlineStep> outline_steps(const MinimalOutline& outline,
                                       GridPosition start);

/// The points as counted by `max_points` of the font's header: one for each
/// step, and one closing point for each contour.
int point_count(const std::vector<OutlineStep>& steps);

}  // namespace inkcell::gen
