// The path data of SVG.
#pragma once

#include <string_view>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// A part of a path drawn without lifting the pen.
struct Subpath {
  std::vector<Segment> segments;  // at least one; may have no length
  /// The pen returned to the start: by Z, with a line if needed.
  bool is_closed = false;
};

using SvgPath = std::vector<Subpath>;

/// Parses the attribute `d` of a path (SVG 1.1, section 8.3), in its own
/// coordinates, y down. Arcs become cubics of at most 45 degrees, with an error
/// of 1/200000 of the radius.
///
/// Throws Error that names the position of the mistake.
SvgPath parse_path_data(std::string_view data);

/// The area that a path encloses: its subpaths, each closed by a line if
/// needed. Segments without length are left out.
Outline contours_of(const SvgPath& path);

}  // namespace inkcell::gen
