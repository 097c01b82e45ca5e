// Build options that trade speed for code size and stack.
#pragma once

// 0: cells of primitives are drawn in pixel order, each pixel for itself,
// instead of in bands of rows in which each cell is met once, and which skip
// what is saturated; and large glyphs of samples row by row instead of cell by
// cell.
#ifndef INKCELL_OBJECT_ORDER
#  define INKCELL_OBJECT_ORDER 1
#endif

// 0: one loop for all cells of primitives, instead of loops for one, two and
// three fields, of lines and of arcs.
#ifndef INKCELL_FAST_ROWS
#  define INKCELL_FAST_ROWS 1
#endif

namespace inkcell {
namespace detail {

inline constexpr bool kObjectOrder = INKCELL_OBJECT_ORDER != 0;
inline constexpr bool kFastRows = INKCELL_FAST_ROWS != 0;

}  // namespace detail
}  // namespace inkcell
