// Outlines for the tests of the generator: from font files, and made by hand.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {
namespace test {

inline constexpr char kDejaVuSans[] =
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
inline constexpr char kLiberationSerif[] =
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf";
inline constexpr char kRoboto[] =
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf";
/// A variable font: wght 100..900, slnt -10..0.
inline constexpr char kInterVariable[] =
    "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf";
inline constexpr char kInterItalicVariable[] =
    "/usr/share/fonts/truetype/inter-vf/Inter-italic.var.ttf";
inline constexpr char kNotoSansCjk[] =
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc";

/// Outlines of `code_points`, straight from FreeType. Throws
/// std::runtime_error if the file or a glyph is missing.
std::vector<Outline> load_outlines(const std::string& file,
                                   int face_index,
                                   const std::vector<uint32_t>& code_points);

/// 0x21..0x7E: the ASCII characters with ink.
std::vector<uint32_t> ascii();

inline Outline outline(std::vector<Contour> contours) {
  return {std::move(contours)};
}

/// A closed polygon.
Contour polygon(const std::vector<Point>& corners);

/// Counter-clockwise if x0 < x1 and y0 < y1.
Contour rectangle(double x0, double y0, double x1, double y1);

/// Four cubics; counter-clockwise if radius > 0.
Contour circle(double x, double y, double radius);

}  // namespace test
}  // namespace inkcell::gen
