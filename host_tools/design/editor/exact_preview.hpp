// A preview while the device's is being made: at once, from exact distances.
#pragma once

#include "editor/preview.hpp"

namespace inkcell::design::editor {

/// `last` with its pictures drawn anew for `job`: the glyph of `job` from the
/// exact distance to its outline, through the device's `text` filter, without
/// hints; other glyphs of the text as the font in `last` has them. Empty if
/// `last` is none of this glyph. Throws std::runtime_error or Error.
std::shared_ptr<const Preview> draw_exact_preview(const Preview& last,
                                                  const PreviewJob& job);

}  // namespace inkcell::design::editor
