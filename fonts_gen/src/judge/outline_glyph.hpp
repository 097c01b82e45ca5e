// One glyph of outlines, refitted until the device draws it within the
// tolerance.
#pragma once

#include "inkcell/font.hpp"
#include "judge/closed_loop.hpp"
#include "outlines/minimal_outline.hpp"
#include "outlines/refit.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// How all glyphs of a font are refitted: the coarsest grid that keeps the
/// tolerance at the largest size, or that has room for glyphs as wide or high
/// as `largest_u` if that is coarser, and how far outlines may stray. Font
/// units serve sooner if the source's points lie on them.
RefitOptions refit_options(const Target& options,
                           int units_per_em,
                           double largest_u,
                           bool is_on_units);

struct RefittedGlyph {
  MinimalOutline outline;
  GlyphErrors errors;
  int trials = 0;  // outlines that were drawn until one held
};

/// No glyph takes more.
inline constexpr int kMostTrials = 36;

/// Refits `source`, draws it with the device's decoder and painter at all sizes
/// of the loop, and takes more care where a pixel misses the tolerance by
/// distance, or by the bound of its area: first corners and a quarter of the
/// tolerance, then the points of the source, then chords. What held stays as it
/// was. The best of all attempts, which may still miss the tolerance; see
/// `errors`. One whose areas hold is better than all whose do not.
///
/// `shape` is the area of `source` and not empty, `metrics` its box. Throws
/// GeometryError.
RefittedGlyph refit_glyph(const Outline& source,
                          const Shape& shape,
                          const GlyphMetrics& metrics,
                          const RefitOptions& options,
                          const LoopOptions& loop_options);

}  // namespace inkcell::gen
