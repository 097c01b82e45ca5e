// Draws glyphs with the device's core and compares them with the truth.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "errors.hpp"
#include "filters.hpp"
#include "image.hpp"
#include "inkcell/font.hpp"
#include "truth.hpp"

namespace inkcell::tools {

/// A filter as documented, in real numbers. kFilterArea has no distances.
struct ExactFilter {
  const NamedFilter* device = nullptr;
  double outside_px = 0;
  double inside_px = 0;
  double exponent = 1;

  bool is_area() const { return device->filter == &kFilterArea; }

  /// 0..255, not rounded.
  double coverage(double distance_px) const;
};

/// Of a preset, or "area". Throws std::runtime_error for other names.
ExactFilter exact_filter(std::string_view name);

inline constexpr int kMaxPhases = 8;
inline constexpr int kMaxPositions = 4096;

/// What to compare.
struct ComparisonRequest {
  std::vector<double> sizes;  // [px/em]
  std::vector<ExactFilter> filters;
  int phases = kMaxPhases;  // fixed sub-pixel positions, 1..kMaxPhases
  // Above 0: this many random positions instead, different for each glyph and
  // size, given by the seed.
  int positions = 0;
  uint32_t seed = 1;
  double angle = 0;  // [degrees], counter-clockwise
};

/// A glyph, in the ROM font and in the font file.
struct Subject {
  const Font& font;
  uint16_t glyph;
  char32_t code_point;
  const TrueGlyph& truth;
};

/// Errors of one glyph for each size and filter: [size * filters + filter].
std::vector<GlyphErrors> compare_glyph(const Subject& subject,
                                       const ComparisonRequest& request);

/// The pixels of one glyph at one size, angle and offset.
struct Picture {
  int x0 = 0;  // of the first pixel, relative to the glyph's origin, y down
  int y0 = 0;
  Image drawn;
  std::vector<double> exact;  // [1/255] of the same pixels, row by row
};

Picture draw_picture(const Subject& subject,
                     const ExactFilter& filter,
                     double px,
                     double angle,
                     Offset offset);

}  // namespace inkcell::tools
