// Several faces as one font.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "source/font_source.hpp"

namespace inkcell::gen {

/// A face that gives characters which the faces before it do not.
struct MergedFace {
  std::filesystem::path file;
  /// The characters it is asked for; none: those that are still missing.
  CharSet characters;
};

/// Reads "FILE" or "FILE=LIST" with a list of add_ranges. Throws Error.
MergedFace parse_merged_face(const std::string& text);

/// Reads `first`, and then the faces of `more` in their order. A character
/// comes from the first face that is asked for it and has it. Lines, metrics,
/// the name and .notdef are those of `first`, other faces are scaled by their
/// units per em; characters of different faces do not kern. `lines` are shaped
/// by all faces, whatever characters these are asked for. Of an ellipsis, the
/// point is added, or U+2026 if no face has one; of hyphens '-' or U+2010; both
/// only to letters and digits. What no face has is not missing. Throws Error.
SourceFont load_faces(const FontRequest& first,
                      const std::vector<MergedFace>& more,
                      const std::vector<LineText>& lines,
                      int jobs,
                      Warnings& warnings);

/// Adds the glyphs of `part` to `font`, but for its .notdef, and puts all in
/// the order that SourceFont::glyphs has. They have no character in common.
/// Throws Error if they are too many.
void merge_font(SourceFont part, SourceFont& font);

/// Puts the glyphs of `font` in the order that SourceFont::glyphs has.
void sort_glyphs(SourceFont& font);

}  // namespace inkcell::gen
