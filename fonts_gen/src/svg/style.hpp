// How an element is painted, from its attributes and style properties.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "shape/paint.hpp"

namespace inkcell::gen {

enum class FillRule { nonzero, evenodd };
enum class LineJoin { miter, round, bevel };
enum class LineCap { butt, round, square };

/// The pen's settings, in the units of the element.
struct PenStyle {
  double width = 1;
  LineJoin join = LineJoin::miter;
  double miter_limit = 4;
  LineCap cap = LineCap::butt;
};

/// The properties that elements inherit.
struct PaintStyle {
  /// Whether colours may have an opacity, and `currentColor` is the text's.
  bool has_colours = false;
  std::string color = "#000000";
  /// A colour as "#rrggbb" or as the file writes it; "none".
  std::string fill = "#000000";
  std::string stroke = "none";
  /// 0 to 1; that of groups counts for each of their elements.
  double opacity = 1;
  double fill_opacity = 1;
  double stroke_opacity = 1;
  FillRule rule = FillRule::nonzero;
  PenStyle pen;
  bool is_shown = true;
};

/// The value of an attribute or of the property in `style`, which has priority,
/// without blanks around it; "" if there is neither.
std::string property_of(const pugi::xml_node& node, const char* name);

/// The number of an attribute or property in user units: "2", "2px", "1e1";
/// `otherwise` without one. Throws Error for percent and other units.
double number_of(const pugi::xml_node& node,
                 const char* name,
                 double otherwise);

/// The numbers of a list such as `points` or `viewBox`. Throws Error.
std::vector<double> numbers_of(const pugi::xml_node& node, const char* name);

/// The style of `node` in an element with the style `parent`. Throws Error with
/// a remedy for gradients, patterns, dashes, clip paths, masks, filters and
/// markers, and without colours for partial transparency.
PaintStyle style_of(const pugi::xml_node& node, const PaintStyle& parent);

/// The colour of a fill or stroke: hexadecimal digits, rgb() and rgba(), some
/// names, and `currentcolor`, the text's own. Throws Error with a remedy.
Paint paint_of(const std::string& color, double opacity);

}  // namespace inkcell::gen
