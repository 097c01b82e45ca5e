// Glyphs that are made of strokes: centre lines through knots, and the nib at
// each knot. Everything in font units.
#pragma once

#include <optional>
#include <vector>

#include "editor/editor.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design::editor {

bool has_strokes(const Glyph& glyph);

/// Throws Error.
std::vector<Stroke> strokes_of(const Glyph& glyph);
std::vector<gen::Segment> centre_line(const Project& project,
                                      const Stroke& stroke);

/// The ends of a nib's axes, by which it is turned and widened.
struct NibHandles {
  Point along;   // width and angle
  Point across;  // height
};
NibHandles handles_of(const StrokePoint& knot, const Nib& nib);

/// The nib after its handle was dragged to `to`; `steps` turns it by 15
/// degrees.
Nib with_handle(const StrokePoint& knot,
                const Nib& nib,
                bool is_along,
                Point to,
                bool steps);

// Commands. A knot is a number of a stroke and of a point of it.
Value move_knots(const Glyph& glyph,
                 const Selection& knots,
                 double dx,
                 double dy);
/// Moves the selected knots and points.
Value move_selected(const Editor& editor, Point by);
/// Both commands as one step; either may be null.
Value both(Value a, Value b);
/// The nib of one knot alone: the others keep theirs.
Value set_nib(const Glyph& glyph, PointId knot, const Nib& nib);
/// Removes knots, and strokes without any.
Value delete_knots(const Glyph& glyph, const Selection& knots);
Value toggle_corner(const Glyph& glyph, PointId knot);
/// Adds a knot after another one, which moves no other.
Value add_knot(const Glyph& glyph, PointId before, Point at);

}  // namespace inkcell::design::editor
