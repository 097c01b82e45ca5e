#include "svg/basic_shapes.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "svg/style.hpp"

namespace inkcell::gen {
namespace {

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g ", value);
  return text;
}

// Path data of a command and its numbers.
std::string step(const char* command, std::initializer_list<double> numbers) {
  std::string text = command;
  for (const double number : numbers) {
    text += text_of(number);
  }
  return text;
}

// A quarter of an ellipse, clockwise on the screen.
std::string quarter(double rx, double ry, double x, double y) {
  return step("a", {rx, ry, 0, 0, 1, x, y});
}

double size_of(const pugi::xml_node& node, const char* name) {
  const double value = number_of(node, name, 0);
  if (value < 0) {
    throw Error(std::string(name) + "='" + node.attribute(name).value() +
                "' is below 0");
  }
  return value;
}

std::string ellipse(const pugi::xml_node& node, double rx, double ry) {
  if (rx == 0 || ry == 0) {
    return "";
  }
  return step("M", {number_of(node, "cx", 0) + rx, number_of(node, "cy", 0)}) +
         quarter(rx, ry, -rx, ry) + quarter(rx, ry, -rx, -ry) +
         quarter(rx, ry, rx, -ry) + quarter(rx, ry, rx, ry) + "z";
}

// One radius is the default of the other; both are at most half a side.
std::string rectangle(const pugi::xml_node& node) {
  const double x = number_of(node, "x", 0);
  const double y = number_of(node, "y", 0);
  const double w = size_of(node, "width");
  const double h = size_of(node, "height");
  if (w == 0 || h == 0) {
    return "";
  }
  const auto has = [&](const char* name) {
    const std::string text = property_of(node, name);
    return !text.empty() && text != "auto";
  };
  double rx = has("rx") ? size_of(node, "rx") : 0;
  double ry = has("ry") ? size_of(node, "ry") : rx;
  rx = std::min(has("rx") ? rx : ry, w / 2);
  ry = std::min(ry, h / 2);
  if (rx == 0 || ry == 0) {
    return step("M", {x, y}) + step("h", {w}) + step("v", {h}) +
           step("h", {-w}) + "z";
  }
  return step("M", {x + rx, y}) + step("H", {x + w - rx}) +
         quarter(rx, ry, rx, ry) + step("V", {y + h - ry}) +
         quarter(rx, ry, -rx, ry) + step("H", {x + rx}) +
         quarter(rx, ry, -rx, -ry) + step("V", {y + ry}) +
         quarter(rx, ry, rx, -ry) + "z";
}

std::string polygon(const pugi::xml_node& node, const char* end) {
  const std::vector<double> points = numbers_of(node, "points");
  if (points.size() % 2 != 0) {
    throw Error("points has an odd number of coordinates; each point has two");
  }
  std::string data;
  for (size_t i = 0; i < points.size(); i += 2) {
    data += step(i == 0 ? "M" : "L", {points[i], points[i + 1]});
  }
  return data.empty() ? data : data + end;
}

std::string straight(const pugi::xml_node& node) {
  return step("M", {number_of(node, "x1", 0), number_of(node, "y1", 0)}) +
         step("L", {number_of(node, "x2", 0), number_of(node, "y2", 0)});
}

}  // namespace

std::optional<SvgPath> path_of(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  if (name == "path") {
    return parse_path_data(node.attribute("d").value());
  }
  if (name == "rect") {
    return parse_path_data(rectangle(node));
  }
  if (name == "circle") {
    const double r = size_of(node, "r");
    return parse_path_data(ellipse(node, r, r));
  }
  if (name == "ellipse") {
    return parse_path_data(
        ellipse(node, size_of(node, "rx"), size_of(node, "ry")));
  }
  if (name == "line") {
    return parse_path_data(straight(node));
  }
  if (name == "polyline" || name == "polygon") {
    return parse_path_data(polygon(node, name == "polygon" ? "z" : ""));
  }
  return std::nullopt;
}

}  // namespace inkcell::gen
