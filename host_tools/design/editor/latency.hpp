// Measures response times.
#pragma once

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// Median and worst of several runs, and the median of the time that all cores
/// worked. [ms]
struct Latency {
  double median = 0;
  double worst = 0;
  double cpu = 0;
};

struct Latencies {
  Latency drag;    // a moved point: change, exact pictures, distances
  Latency device;  // a change: all that the device draws, with its figures
  Latency stroke;  // the end of a stroke: outline, field, preview
  Latency weight;  // a step of the weight's slider: change, exact pictures
  // Of a glyph of strokes: a knot that moves, a nib that turns and widens; each
  // the change and exact pictures.
  std::optional<Latency> knot;
  std::optional<Latency> nib;
  // Of a glyph of strokes or parts: it becomes an outline, and is made of them
  // again by undo; likewise.
  std::optional<Latency> to_outline;
  std::optional<Latency> back;
};

/// Drags the first point of the shown glyph or its first knot, draws strokes
/// with the nib, and lets go of strokes and parts, `runs` times each, without
/// changing the project. Pictures have the preview's sizes; distances are
/// sampled four to a pixel of the largest. Throws Error.
Latencies measure_latencies(Editor& editor, int runs);

}  // namespace inkcell::design::editor
