// A preview from exact distances, available before the device's.
#pragma once

#include "editor/preview.hpp"

namespace inkcell::design::editor {

/// `last` with new pictures for `job`. The job's glyph is drawn from the exact
/// distance to its outline by the device's `text` filter, without hints; other
/// glyphs of the text come from the font in `last`. Empty if `last` is of
/// another glyph. Throws std::runtime_error or Error.
std::shared_ptr<const Preview> draw_exact_preview(const Preview& last,
                                                  const PreviewJob& job);

}  // namespace inkcell::design::editor
