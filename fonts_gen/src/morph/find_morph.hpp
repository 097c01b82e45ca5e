// The way from one outline to another.
#pragma once

#include <optional>

#include "morph/morph_check.hpp"
#include "morph/morph_pair.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// Morphs whose area deviates by more are refused: in the numbers of the device
/// it stays within 5 %.
inline constexpr double kMostAreaError = 0.045;

/// Pairs the contours of two outlines of lines and quadratics. A hole of one
/// outline only is born at a point inside strokes of the other; no stroke is
/// cut. Of all ways that which travels less, keeps the area, and does not
/// thicken strokes.
///
/// None: no way was found on which no contour crosses another or itself, and
/// the area deviates by kMostAreaError at most.
std::optional<MorphPair> find_morph(const Outline& first,
                                    const Outline& second);

}  // namespace inkcell::gen
