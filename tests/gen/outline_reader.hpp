// A plain reader of outline and composite records, from docs/FORMAT.md alone.
#pragma once

#include <cstdint>
#include <vector>

#include "outlines/minimal_outline.hpp"
#include "outlines/outline_record.hpp"

namespace inkcell::gen::test {

inline constexpr PointKind kCorner = PointKind::corner;

/// The outline of a record; tables have 2^code_bits entries each. Stops after
/// `most_points`, including one closing point a contour.
MinimalOutline read_outline(const std::vector<uint8_t>& record,
                            const std::vector<uint16_t>& tables,
                            int code_bits,
                            GridPosition start,
                            int most_points);

OutlineReferences read_composite(const std::vector<uint8_t>& record);

/// Whether two outlines have the same points, contour by contour.
bool same(const MinimalOutline& a, const MinimalOutline& b);

}  // namespace inkcell::gen::test
