// Glyphs that are made of other glyphs by operators: a tree of shapes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

bool has_tree(const Glyph& glyph);

/// The parts of a tree, in order: { "glyph", "matrix" }.
std::vector<Value> parts_of(const Glyph& glyph);
/// The contours of a part, for display.
std::vector<PointContour> contours_of_part(const Project& project,
                                           const Value& part);
/// The last part around a place.
std::optional<size_t> part_at(const Project& project,
                              const Glyph& glyph,
                              Point at);

/// Maps a part by `matrix` after its own.
Value map_part(const Glyph& glyph, size_t part, const Matrix& matrix);
/// Throws Error for one of the last two parts.
Value delete_part(const Glyph& glyph, size_t part);
Value add_part(const Glyph& glyph, const std::string& base);
Value set_tree(const Value& tree);

/// Makes the components of a glyph the parts of a tree, which unites them.
/// Throws Error unless there are two, and nothing else.
Value combine_components(const Glyph& glyph);

}  // namespace inkcell::design::editor
