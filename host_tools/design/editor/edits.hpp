// Commands of the design library for what is done on the canvas.
#pragma once

#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// Several commands as one step.
Value batch(std::vector<Value> commands);

/// Moves the selected points. Handles of a selected point of a cubic go along;
/// a handle opposite to one that moves alone turns with it if their point is
/// smooth. Null if nothing is selected.
Value move_selection(const Glyph& glyph,
                     const Selection& selection,
                     double dx,
                     double dy);

/// Deletes points, each with one handle on either side, so that one curve
/// stands for two; contours with less than two points on the curve go.
Value delete_points(const Glyph& glyph, const Selection& selection);

/// Gives the selected points one height or one abscissa, their mean, whichever
/// they are nearer to. Handles go along. Null for less than two points.
Value align_points(const Glyph& glyph, const Selection& selection);

/// The line that ends at the point `id` becomes a cubic of the same shape. Null
/// if no line ends there.
Value curve_line(const Glyph& glyph, PointId id);

/// A point of a curve becomes smooth, its handles in one line; or a corner.
Value toggle_smooth(const Glyph& glyph, PointId id);

/// Puts `contours` in the place of all contours that differ.
Value replace_contours(const Glyph& glyph,
                       const std::vector<PointContour>& contours);

Value add_contour(const PointContour& contour);

/// Counter-clockwise, between two corners.
PointContour rectangle(Point a, Point b);
PointContour ellipse(Point a, Point b);

}  // namespace inkcell::design::editor
