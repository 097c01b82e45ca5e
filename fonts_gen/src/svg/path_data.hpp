// The path data of SVG.
#pragma once

#include <string_view>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// A part of a path that the pen draws without being lifted.
struct Subpath {
  std::vector<Segment> segments;  // at least one; may have no length
  /// The pen went back to where it began: by Z, along a line if need be.
  bool is_closed = false;
};

using SvgPath = std::vector<Subpath>;

/// The attribute `d` of a path (SVG 1.1, section 8.3), in its own coordinates,
/// y down. Arcs become cubics of at most 45 degrees, which are off by 1/200000
/// of their radius.
///
/// Throws Error that says where the data is wrong.
SvgPath parse_path_data(std::string_view data);

/// What a path encloses: its subpaths, each closed by a line if need be. Pieces
/// without length are left out.
Outline contours_of(const SvgPath& path);

}  // namespace inkcell::gen
