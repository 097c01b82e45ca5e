// Merges several faces into one font.
#pragma once

#include <functional>
#include <vector>

#include "source/font_source.hpp"
#include "source/merged_face.hpp"

namespace inkcell::gen {

/// Reads `first`, then the faces of `more` in order. A character comes from the
/// first face that has it and is asked for it.
///
/// Lines, metrics, the name and .notdef are those of `first`. An em of another
/// face is scaled to one of `first`, or as its place says. A face is one of
/// icons if no letter, mark or digit is taken from it, and either a private use
/// character is or it lacks Latin letters; icons are centred on the capitals.
/// Characters of different faces do not kern. All faces shape `lines`, whatever
/// characters they are asked for.
///
/// For letters and digits the dot is added as ellipsis, or U+2026 if no face
/// has it, and '-' as hyphen, or U+2010. If no face has them, they are not
/// missing. Throws Error.
SourceFont load_faces(const FontRequest& first,
                      const std::vector<MergedFace>& more,
                      const std::vector<LineText>& lines,
                      int jobs,
                      Warnings& warnings);

/// Characters that layout needs beside `asked`, of those that a font has.
CharSet additions_to(const CharSet& asked,
                     Additions additions,
                     const std::function<bool(char32_t)>& has);

/// Adds the glyphs of `part`, which has one face, to `font`, scaled and shifted
/// as the face says, without .notdef, and sorts all with sort_glyphs(). Both
/// must have no character in common. Throws Error if they are too many.
void merge_font(SourceFont part, SourceFont& font);

/// Sorts the glyphs of `font` as SourceFont::glyphs says.
void sort_glyphs(SourceFont& font);

}  // namespace inkcell::gen
