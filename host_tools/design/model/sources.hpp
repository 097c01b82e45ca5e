// Sources of outlines in a glyph's lib: strokes and trees of shapes.
#pragma once

#include <functional>

#include "model/glyph.hpp"

namespace inkcell::design {

/// Keys of a glyph's lib.
inline constexpr const char* kStrokesKey = "org.inkcell.strokes";
inline constexpr const char* kTreeKey = "org.inkcell.tree";
/// The number of contours beside strokes; they come first. Default 0.
inline constexpr const char* kOwnContoursKey = "org.inkcell.ownContours";

/// Whether the outline is made of strokes or of a tree.
bool has_source(const Glyph& glyph);
void drop_source(Glyph& glyph);

/// The number of contours that are not the outline of strokes.
size_t own_contours(const Glyph& glyph);
/// The glyph without the outline of its strokes.
Glyph own_part(const Glyph& glyph);

/// After an edit of contours: strokes stay if their outline did not change. A
/// tree goes.
void settle_source(const Glyph& before, Glyph& glyph);

/// Calls `edit` with each leaf of a tree, in order: { "glyph", "matrix" }.
void map_leaves(Value& node, const std::function<void(Value&)>& edit);

/// The matrix of a leaf, by default the identity.
Matrix matrix_of(const Value& leaf);
void set_matrix(const Matrix& matrix, Value& leaf);

/// Maps the source of a glyph. A source that cannot be mapped goes: strokes and
/// blends by a matrix that does not scale alike in all directions.
void transform_source(const Matrix& matrix, Glyph& glyph);

}  // namespace inkcell::design
