// Features of a glyph for grid fitting.
#pragma once

#include <vector>

#include "hints/free_ends.hpp"
#include "hints/strokes.hpp"

namespace inkcell::gen {

/// All in u, of the outline that the device decodes.
struct GlyphFeatures {
  Box box;
  std::vector<Stroke> bars;            // ascending, serifs among them
  std::vector<StrokeEdge> lone_edges;  // heights without a partner, ascending
  std::vector<FreeEnd> ends;           // ascending
  std::vector<Stroke> stems;           // from left to right
  Interval body;                       // the extent in x without serifs
  bool is_symmetric = false;           // left and right are mirror images
  bool has_ink = false;
};

/// `outline` must be valid for Border.
GlyphFeatures find_features(const Outline& outline);

}  // namespace inkcell::gen
