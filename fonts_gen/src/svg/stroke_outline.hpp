// The outline of a stroke, as curves.
#pragma once

#include <optional>

#include "shape/outline.hpp"
#include "svg/path_data.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {

/// Contours that fill the stroke of `subpath` under the rule nonzero, in its
/// units: the path offset by half a pen to each side, with joins and caps.
/// Curves are cubics within `bound` of the exact border; round joins and caps
/// are arcs within 1/200000 of half the pen. Contours overlap themselves at the
/// inner sides of joins.
///
/// The result is wrong where the path turns more tightly than half the pen:
/// compare it with stroke_pieces(). Empty if a curve has a cusp, and for a
/// subpath without length unless its caps are round.
std::optional<Outline> stroke_outline(const Subpath& subpath,
                                      const PenStyle& pen,
                                      double bound);

}  // namespace inkcell::gen
