// Measures response times.
#pragma once

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// Median and worst of several runs. [ms]
struct Latency {
  double median = 0;
  double worst = 0;
};

struct Latencies {
  Latency drag;    // a moved point: change, exact pictures, distances
  Latency device;  // a change: all that the device draws, with its figures
  Latency stroke;  // the end of a stroke: outline, field, preview
};

/// Drags the first point of the shown glyph, and draws strokes with the nib,
/// `runs` times each, without changing the project. Pictures have the preview's
/// sizes; distances are sampled four to a pixel of the largest. Throws Error.
Latencies measure_latencies(Editor& editor, int runs);

}  // namespace inkcell::design::editor
