// Draws glyphs with the device's core and holds them against the truth.
#pragma once

#include <cstdint>
#include <vector>

#include "errors.hpp"
#include "filters.hpp"
#include "inkcell/font.hpp"
#include "truth.hpp"

namespace inkcell::tools {

/// A filter as the documentation states it, in real numbers.
struct ExactFilter {
  const NamedFilter* device = nullptr;
  double outside_px = 0;
  double inside_px = 0;
  double exponent = 1;

  /// 0..255, not rounded.
  double coverage(double distance_px) const;
};

/// Throws std::runtime_error if there is no filter of this name.
ExactFilter exact_filter(std::string_view name);

/// What to compare.
struct ComparisonRequest {
  std::vector<double> sizes;  // [px/em]
  std::vector<ExactFilter> filters;
  int phases = 4;    // sub-pixel positions, 1..kMaxPhases
  double angle = 0;  // [degrees], counter-clockwise
};

inline constexpr int kMaxPhases = 8;

/// Errors for each size and filter: results[size * filters + filter].
using ComparisonResults = std::vector<ErrorStatistics>;

/// Compares one glyph and adds to `results`.
void compare_glyph(const Font& font,
                   uint16_t glyph,
                   char32_t code_point,
                   const TrueGlyph& truth,
                   const ComparisonRequest& request,
                   ComparisonResults& results);

}  // namespace inkcell::tools
