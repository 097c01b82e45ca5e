// The way from one outline to another.
#pragma once

#include <optional>

#include "morph/morph_check.hpp"
#include "morph/morph_pair.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// Morphs whose area deviates by less are preferred, see MorphQuality.
inline constexpr double kGoodAreaError = 0.03;
/// Morphs whose area deviates by more are refused.
inline constexpr double kMostAreaError = 0.08;

/// Pairs the contours of two outlines of lines and quadratics. Contours of one
/// outline only are joined to their neighbours across a stroke, or holes open
/// as a slit: whichever travels less, keeps the area, and does not thicken
/// strokes.
///
/// None: no way was found on which no contour crosses another or itself, and
/// the area deviates by kMostAreaError at most.
std::optional<MorphPair> find_morph(const Outline& first,
                                    const Outline& second);

}  // namespace inkcell::gen
