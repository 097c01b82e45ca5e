#include "svg/style.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/trimmed.hpp"

namespace inkcell::gen {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

// The value of a property in the attribute `style`; "" if it has none.
std::string declaration_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = node.attribute("style").value();
  std::string found;
  while (!style.empty()) {
    const std::string_view item = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(item.size() + 1, style.size()));
    const size_t colon = item.find(':');
    if (colon != std::string_view::npos &&
        trimmed(item.substr(0, colon), kBlanks) == name) {
      found = trimmed(item.substr(colon + 1), kBlanks);
    }
  }
  return found;
}

std::string quoted(const char* name, const std::string& value) {
  return std::string(name) + "='" + value + "'";
}

// The value of a property, or `parent` if it has none.
template <typename Value>
Value choice(const pugi::xml_node& node,
             const char* name,
             Value parent,
             std::initializer_list<std::pair<const char*, Value>> values) {
  const std::string text = property_of(node, name);
  if (text.empty() || text == "inherit") {
    return parent;
  }
  std::string known;
  for (const auto& [word, value] : values) {
    if (text == word) {
      return value;
    }
    known += std::string(known.empty() ? "" : ", ") + word;
  }
  throw Error(quoted(name, text) + " is not supported; use one of " + known);
}

std::string paint_of(const pugi::xml_node& node,
                     const char* name,
                     const std::string& parent,
                     const std::string& color) {
  const std::string text = lower(property_of(node, name));
  if (text.empty() || text == "inherit") {
    return parent;
  }
  if (text == "currentcolor") {
    return color;
  }
  if (text.compare(0, 4, "url(") == 0) {
    throw Error(quoted(name, text) +
                " is a gradient or a pattern; an icon is of one colour: paint "
                "with it, or with none");
  }
  const bool is_hex = text[0] == '#' && (text.size() == 5 || text.size() == 9);
  const std::string function = text.substr(0, 5);
  if (is_hex || function == "rgba(" || function == "hsla(") {
    throw Error(quoted(name, text) +
                " has an alpha; write a colour without one, or none");
  }
  if (text == "transparent") {
    return "none";
  }
  if (text == "black") {
    return "#000000";
  }
  if (text.size() == 4 && text[0] == '#') {
    return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
  }
  return text;
}

// Whether the element is opaque enough to be seen.
bool is_opaque(const pugi::xml_node& node, const char* name) {
  std::string text = property_of(node, name);
  if (text == "100%") {
    text = "1";
  }
  std::string_view rest = text;
  const double opacity = text.empty() ? 1 : take_number(rest).value_or(-1);
  if (opacity == 1 || opacity == 0) {
    return opacity == 1;
  }
  throw Error(quoted(name, text) +
              " is part transparent; draw the element opaque, or remove it");
}

void refuse_unless_none(const pugi::xml_node& node,
                        const char* name,
                        const char* remedy) {
  const std::string text = property_of(node, name);
  if (!text.empty() && text != "none") {
    throw Error(quoted(name, text) + " is not supported; " + remedy);
  }
}

PenStyle pen_of(const pugi::xml_node& node, const PenStyle& parent) {
  PenStyle pen;
  pen.width = number_of(node, "stroke-width", parent.width);
  pen.miter_limit = number_of(node, "stroke-miterlimit", parent.miter_limit);
  pen.join = choice<LineJoin>(node, "stroke-linejoin", parent.join,
                              {{"miter", LineJoin::miter},
                               {"round", LineJoin::round},
                               {"bevel", LineJoin::bevel}});
  pen.cap = choice<LineCap>(node, "stroke-linecap", parent.cap,
                            {{"butt", LineCap::butt},
                             {"round", LineCap::round},
                             {"square", LineCap::square}});
  if (pen.width < 0 || pen.miter_limit < 1) {
    throw Error(
        "a stroke-width is at least 0 and a stroke-miterlimit at least 1");
  }
  return pen;
}

}  // namespace

std::string property_of(const pugi::xml_node& node, const char* name) {
  const std::string declared = declaration_of(node, name);
  return declared.empty()
             ? std::string(trimmed(node.attribute(name).value(), kBlanks))
             : declared;
}

double number_of(const pugi::xml_node& node,
                 const char* name,
                 double otherwise) {
  const std::string text = property_of(node, name);
  if (text.empty() || text == "inherit") {
    return otherwise;
  }
  std::string_view rest = text;
  const std::optional<double> value = take_number(rest);
  if (!value || !(rest.empty() || rest == "px")) {
    throw Error(quoted(name, text) +
                " is no number of user units; write one without a unit");
  }
  return *value;
}

std::vector<double> numbers_of(const pugi::xml_node& node, const char* name) {
  const std::string text = node.attribute(name).value();
  const std::optional<std::vector<double>> numbers = numbers_in(text);
  if (!numbers) {
    throw Error(quoted(name, text) + " is no list of numbers");
  }
  return *numbers;
}

PaintStyle style_of(const pugi::xml_node& node, const PaintStyle& parent) {
  refuse_unless_none(node, "clip-path",
                     "cut the paths themselves, or remove the clip path");
  refuse_unless_none(node, "mask",
                     "cut the paths themselves, or remove the mask");
  refuse_unless_none(node, "filter", "remove it");
  for (const char* marker :
       {"marker", "marker-start", "marker-mid", "marker-end"}) {
    refuse_unless_none(node, marker, "draw the marker as a path");
  }
  refuse_unless_none(node, "stroke-dasharray", "draw each dash as a path");
  refuse_unless_none(node, "vector-effect", "remove it");
  if (!property_of(node, "transform-origin").empty() ||
      !declaration_of(node, "transform").empty()) {
    throw Error(
        "transforms of style sheets are not supported; use the attribute "
        "transform");
  }
  PaintStyle style = parent;
  style.color = paint_of(node, "color", parent.color, parent.color);
  style.fill = paint_of(node, "fill", parent.fill, style.color);
  style.stroke = paint_of(node, "stroke", parent.stroke, style.color);
  style.rule = choice<FillRule>(
      node, "fill-rule", parent.rule,
      {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::evenodd}});
  style.pen = pen_of(node, parent.pen);
  const std::string visibility = property_of(node, "visibility");
  style.is_shown = parent.is_shown && is_opaque(node, "opacity") &&
                   property_of(node, "display") != "none" &&
                   visibility != "hidden" && visibility != "collapse";
  if (!is_opaque(node, "fill-opacity")) {
    style.fill = "none";
  }
  if (!is_opaque(node, "stroke-opacity") || style.pen.width == 0) {
    style.stroke = "none";
  }
  return style;
}

}  // namespace inkcell::gen
