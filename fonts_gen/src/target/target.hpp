// What is good enough: sizes, tolerance, and how hard to try.
#pragma once

#include "inkcell/format/rom.hpp"

namespace inkcell::gen {

/// What decides whether a cell is good enough. size_aware: the error of
/// rendered intensity over a range of sizes. fixed: the paper's, the error of
/// distance, near the edge only.
using format::Predicate;

/// What glyphs are made of (docs/FORMAT.md).
using format::Coding;

/// A size at which pictures of all glyphs are made: 4..255 px/em, pixels of 1,
/// 2 or 4 bits.
struct StrikeTarget {
  int px = 0;
  int bits = 0;
  format::StrikeFit fit = format::StrikeFit::both;
};

struct Target {
  Coding coding = Coding::field;
  /// Sizes at which the glyph will be drawn. [px/em]
  double min_px = 8;
  double max_px = 64;
  /// Largest error of rendered intensity. [1/255] Used by size_aware.
  double tolerance = 16;
  Predicate predicate = Predicate::size_aware;
  /// How far from the edge distances are good, at min_px [px]: for outlines,
  /// shadows and glows. 0: what filters need, see band_u.
  double band_px = 0;
  /// How hard to try to serve a large cell before it is divided, 0..9. Used by
  /// cells with size_aware. 0: the cell's own nine samples or nothing; else
  /// they are fitted in up to 2 * effort rounds.
  int effort = 5;
};

/// The widest band: what kCoordinateLimit leaves room for. [u]
inline constexpr double kMostBand_u = 192;

/// How far from the edge the field must be good, at the smallest size. [u]
/// Where nothing is asked for: 0.75 px, the widest filter of the presets.
double band_u(const Target& options);

}  // namespace inkcell::gen
