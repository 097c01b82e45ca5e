// Commands of the design library for operations on the canvas.
#pragma once

#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// Several commands as one step.
Value batch(std::vector<Value> commands);

/// Let go of the strokes or the tree of a glyph.
std::vector<Value> without_source(const Glyph& glyph);

/// Moves the selected points. Their handles move with them; the handle of a
/// quadratic moves along the tangent at its other end if that is smooth. If a
/// handle is moved alone and its point is smooth, the opposite handle turns
/// with it, or between quadratics the point stays between both. Null if nothing
/// is selected.
Value move_selection(const Glyph& glyph,
                     const Selection& selection,
                     double dx,
                     double dy);

/// Deletes points, each with one handle on either side, so that two curves
/// become one. Contours with fewer than two on-curve points are deleted.
Value delete_points(const Glyph& glyph, const Selection& selection);

/// Aligns the selected points at their mean x or mean y, whichever is nearer.
/// Handles move with them. Null for fewer than two points.
Value align_points(const Glyph& glyph, const Selection& selection);

/// Maps the selected component or points with their handles, or without a
/// selection the glyph, about the middle. `matrix` as in commands.
Value transform_selection(const Editor& editor, const Value& matrix);

/// The contours with a selected point.
Value selected_contours(const Editor& editor);

/// Converts the line that ends at the point `id` to a cubic of the same shape.
/// Null if no line ends there.
Value curve_line(const Glyph& glyph, PointId id);

/// Makes a point of a curve smooth, with its handles in line, or a corner.
Value toggle_smooth(const Glyph& glyph, PointId id);

/// Replaces contours that differ by `contours`; the history calls it `title`.
Value replace_contours(const Glyph& glyph,
                       const std::vector<PointContour>& contours,
                       const char* title);

Value add_contour(const PointContour& contour);

/// Adds a contour that is counter-clockwise, in the direction of the glyph's.
Value draw_contour(const Editor& editor, const PointContour& contour);

/// Counter-clockwise, between two corners.
PointContour rectangle(Point a, Point b);
PointContour ellipse(Point a, Point b);

}  // namespace inkcell::design::editor
