// Composite glyphs of TrueType: other glyphs, transformed and moved.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "export/glyf.hpp"
#include "model/project.hpp"

namespace inkcell::design {

/// A component of a record: x' = xx x + yx y + dx, y' = xy x + yy y + dy.
struct GlyfComponent {
  std::string base;
  std::array<int, 4> matrix_q14 = {};  // xx xy yx yy
  int dx = 0;                          // [font units]
  int dy = 0;
  bool overlaps = false;  // its box and that of another component meet
};

/// A glyph of the table.
struct GlyfGlyph {
  /// All contours, components resolved, rounded as FreeType rounds them.
  std::vector<GlyfContour> contours;
  /// Empty: the record holds the contours.
  std::vector<GlyfComponent> components;
  /// Levels of components; 0: none.
  int depth = 0;
  /// A component is reflected, so its contours are filled on the other side.
  bool is_reflected = false;
};

/// The glyph as a composite if a record can hold it: no contours of its own;
/// no component whose name begins with '_', which fonts leave out;
/// matrices in [-2, 2) whose rounding to Q2.14 moves no point by more than 1/8
/// unit; and no reflected component near another one, as their opposite
/// contours would cancel. Else as contours. Drops components without ink.
///
/// Throws Error for a component that does not exist or contains itself, and if
/// a coordinate is beyond +-16383.
GlyfGlyph glyf_glyph(const Project& project, const Glyph& glyph);

/// The record of a glyph with components. `ids` has their numbers by name.
BigEndian composite_record(const GlyfGlyph& glyph,
                           const std::map<std::string, unsigned>& ids);

}  // namespace inkcell::design
