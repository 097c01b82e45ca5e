#include "model/masters.hpp"

#include <algorithm>

#include "model/error.hpp"

namespace inkcell::design {
namespace {

std::string kind_of(const GlyphPoint& point) {
  switch (point.type) {
    case PointType::offcurve:
      return "a handle";
    case PointType::line:
      return "the end of a line";
    case PointType::move:
      return "an open end";
    default:
      return "the end of a curve";
  }
}

// Its name if it has one, or its numbers from 1 on.
std::string name_of(const PointContour& contour, size_t c, size_t p) {
  const std::string& name = contour.points[p].name;
  return "point " + (name.empty() ? std::to_string(p + 1) : "'" + name + "'") +
         " of contour " + std::to_string(c + 1);
}

std::string count_text(size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void compare(const PointContour& a,
             const PointContour& b,
             size_t c,
             const std::string& other,
             std::vector<std::string>& found) {
  const size_t count = std::min(a.points.size(), b.points.size());
  for (size_t p = 0; p < count; ++p) {
    if (a.points[p].type != b.points[p].type) {
      found.push_back(name_of(a, c, p) + ": " + kind_of(a.points[p]) +
                      " here, " + kind_of(b.points[p]) + " in " + other);
    }
  }
  if (a.points.size() != b.points.size()) {
    found.push_back("contour " + std::to_string(c + 1) + ": " +
                    count_text(a.points.size(), "point") + " here, " +
                    std::to_string(b.points.size()) + " in " + other);
  }
}

AxisPlace place_of(const Value& value,
                   const std::vector<Axis>& axes,
                   const std::string& what) {
  AxisPlace place;
  for (const Axis& axis : axes) {
    const Value at = value.value(axis.tag, Value());
    if (!at.is_number()) {
      throw Error(what + " has no place on the axis '" + axis.tag + "'");
    }
    place[axis.tag] = at.get<double>();
  }
  return place;
}

}  // namespace

std::string master_name(const Project& project, size_t layer) {
  const std::string& name = project.layers[layer].name;
  return name == "public.default" ? "Default" : name;
}

std::vector<std::string> mismatches(const Glyph& a,
                                    const Glyph& b,
                                    const std::string& other) {
  std::vector<std::string> found;
  if (a.contours.size() != b.contours.size()) {
    found.push_back(count_text(a.contours.size(), "contour") + " here, " +
                    std::to_string(b.contours.size()) + " in " + other);
  }
  const size_t count = std::min(a.contours.size(), b.contours.size());
  for (size_t c = 0; c < count; ++c) {
    compare(a.contours[c], b.contours[c], c, other, found);
  }
  return found;
}

Axes axes_of(const Project& project) {
  const auto found = project.font->lib.find(kAxesKey);
  if (found == project.font->lib.end()) {
    throw Error(
        "the font has no axes; \"Axis and instances\", or the command "
        "set_axes, "
        "gives masters their places");
  }
  return parse_axes(project, *found);
}

Axes parse_axes(const Project& project, const Value& value) {
  Axes result;
  for (const Value& axis : value.value("axes", Value::array())) {
    const Axis one = {axis.value("tag", ""), axis.value("name", "")};
    if (one.tag.size() != 4 || one.name.empty()) {
      throw Error("an axis has a \"tag\" of four letters and a \"name\"");
    }
    result.axes.push_back(one);
  }
  const Value masters = value.value("masters", Value::object());
  for (size_t i = 0; i < project.layers.size(); ++i) {
    const auto found = masters.find(project.layers[i].name);
    if (found != masters.end()) {
      result.masters.push_back(
          {i, place_of(*found, result.axes,
                       "the master " + master_name(project, i))});
    } else if (i == 0) {
      throw Error("\"masters\" lacks " + project.layers[0].name);
    }
  }
  for (const auto& [name, place] : masters.items()) {
    if (std::none_of(
            project.layers.begin(), project.layers.end(),
            [&layer = name](const Layer& one) { return one.name == layer; })) {
      throw Error("there is no layer '" + name + "'; add it as a master");
    }
  }
  for (const Value& instance : value.value("instances", Value::array())) {
    const std::string name = instance.value("name", "");
    result.instances.push_back(
        {name, place_of(instance, result.axes, "the instance '" + name + "'")});
  }
  if (result.axes.empty() || result.masters.size() < 2) {
    throw Error("a variable font has an axis and two masters or more");
  }
  return result;
}

}  // namespace inkcell::design
