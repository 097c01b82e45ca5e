// A line of text, its side bearings and its kerning.
#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design::editor {

/// A glyph of a line. [font units]
struct PlacedGlyph {
  std::string name;
  GlyphPointer glyph;
  double x = 0;     // of its origin
  double kern = 0;  // between it and the glyph before it
};

/// The characters of a text that the font has, kerned.
std::vector<PlacedGlyph> line_of_text(const Project& project,
                                      const std::string& text);
double width_of(const std::vector<PlacedGlyph>& line);

/// Sets the kerning between two glyphs: the entry that decides it now, of
/// groups if there are some, or with `is_exception` that of the pair. [font
/// units]
Value set_kern(const Project& project,
               const std::string& left,
               const std::string& right,
               double value,
               bool is_exception);
/// The entry of kerning as a text: "A|V", "@A|@V" of groups.
std::string kern_text(const std::pair<std::string, std::string>& entry);

/// The kerning group of a glyph on the left or on the right of pairs, without
/// public.kern1. or public.kern2.; may be "".
std::string group_of(const Project& project,
                     const std::string& glyph,
                     bool is_left);
/// Takes a glyph out of its group and puts it into another one, unless `group`
/// is "". Null if it is there already.
Value join_group(const Project& project,
                 const std::string& glyph,
                 bool is_left,
                 const std::string& group);

}  // namespace inkcell::design::editor
