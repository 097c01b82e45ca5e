// Common features of a face's glyphs: zones and standard widths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "hints/features.hpp"

namespace inkcell::gen {

/// Widths that differ by no more count as equal. [u]
inline constexpr double kSameWidth = 3;

/// A height shared by edges of many glyphs. Round edges are at flat_u +
/// overshoot_u, beyond the flat ones.
struct HintZone {
  int flat_u = 0;
  int overshoot_u = 0;  // at least 0 in a top zone, at most 0 in a bottom one
  bool is_top = false;  // ink is below it
};

struct FaceHints {
  std::vector<HintZone> zones;   // up to format::grid::kMaxZones
  std::optional<size_t> x_zone;  // that of the lower case
  int stem_width_u = 0;          // 0: there are no stems
  int bar_width_u = 0;
  bool has_contrast = false;  // bars are much thinner than stems
  bool has_few_bars = false;  // fits badly
};

/// The zone of an edge, and whether it is round.
struct ZoneEdge {
  size_t zone = 0;
  bool is_round = false;
};

/// Finds zones from letters of Latin, Cyrillic and Greek, if the font has them,
/// then from extremes that many glyphs share. Works with any list of glyphs.
FaceHints find_face(const std::vector<GlyphFeatures>& glyphs,
                    const std::map<char32_t, uint16_t>& glyph_of);

/// The zone of an edge at the height `y`, if there is one.
std::optional<ZoneEdge> zone_of(const FaceHints& face, double y, bool is_top);

}  // namespace inkcell::gen
