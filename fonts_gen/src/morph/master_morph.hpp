// The way from one master of a glyph to another, by the numbers of points.
#pragma once

#include <optional>

#include "morph/morph_pair.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {

/// Morphs of masters whose area deviates by more are refused.
inline constexpr double kMostMasterAreaError = 0.03;

/// Whether both have the same contours of the same lines and curves.
bool have_equal_points(const Outline& a, const Outline& b);

/// Pairs `first` with `second`: outlines of lines and quadratics that were
/// fitted to two masters of one glyph. The points of the masters correspond by
/// their numbers, so the place on the first master says where each piece of
/// `first` must arrive.
///
/// None: the masters differ in their numbers of contours or points, the
/// outlines in their numbers of contours, a contour crosses another or itself
/// on the way, or the area deviates by more than kMostMasterAreaError.
std::optional<MorphPair> find_master_morph(const Outline& first,
                                           const Outline& second,
                                           const Outline (&masters)[2]);

}  // namespace inkcell::gen
