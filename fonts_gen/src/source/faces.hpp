// Several faces as one font.
#pragma once

#include <vector>

#include "source/font_source.hpp"
#include "source/merged_face.hpp"

namespace inkcell::gen {

/// Reads `first`, and then the faces of `more` in their order. A character
/// comes from the first face that is asked for it and has it. Lines, metrics,
/// the name and .notdef are those of `first`; an em of another face is one of
/// `first`, or as high as its place says. Icons stand in the middle of
/// capitals: a face is one of icons if no letter, mark or digit is taken from
/// it, and either a private use character is or it lacks Latin letters.
/// Characters of different faces do not kern. `lines` are shaped by all faces,
/// whatever characters these are asked for. Of an ellipsis, the point is added,
/// or U+2026 if no face has one; of hyphens '-' or U+2010; both only to letters
/// and digits. What no face has is not missing. Throws Error.
SourceFont load_faces(const FontRequest& first,
                      const std::vector<MergedFace>& more,
                      const std::vector<LineText>& lines,
                      int jobs,
                      Warnings& warnings);

/// Adds the glyphs of `part`, which has one face, to `font`, scaled and shifted
/// as the face says, but for its .notdef; and puts all in the order that
/// SourceFont::glyphs has. They have no character in common. Throws Error if
/// they are too many.
void merge_font(SourceFont part, SourceFont& font);

/// Puts the glyphs of `font` in the order that SourceFont::glyphs has.
void sort_glyphs(SourceFont& font);

}  // namespace inkcell::gen
