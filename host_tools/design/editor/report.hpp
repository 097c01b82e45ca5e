// The report that scripts print.
#pragma once

#include "editor/editor.hpp"
#include "editor/latency.hpp"

namespace inkcell::design::editor {

/// The shown glyph, the view, and figures of its preview.
Value report_of(const Editor& editor, const Preview& preview);
Value report_of(const Latencies& latencies);

}  // namespace inkcell::design::editor
