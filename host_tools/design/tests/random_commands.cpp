#include "random_commands.hpp"

#include <iterator>

#include "model/commands.hpp"
#include "model/error.hpp"

namespace inkcell::design::test {

// Fonts have at most this many glyphs.
constexpr size_t kMostGlyphs = 40;
constexpr size_t kMostContours = 6;
constexpr size_t kMostPoints = 12;
constexpr size_t kMostParts = 4;  // anchors and guidelines

bool is_large(const Glyph& glyph) {
  size_t points = 0;
  for (const PointContour& contour : glyph.contours) {
    points += contour.points.size();
  }
  return points > kMostContours * kMostPoints;
}

Value RandomCommands::next(const Project& project) {
  for (;;) {
    Value command = attempt(project);
    try {
      change_of(project, command);
      return command;
    } catch (const Error&) {
      // Not valid for this project: tries another one.
    }
  }
}

std::string RandomCommands::any_glyph(const Project& project) {
  const auto& glyphs = project.front().glyphs;
  if (glyphs.empty()) {
    return "";
  }
  return std::next(glyphs.begin(), below(static_cast<int>(glyphs.size())))
      ->first;
}

Value RandomCommands::attempt(const Project& project) {
  const size_t count = project.front().glyphs.size();
  if (below(20) == 0) {
    return on_font(project);
  }
  const int kind = below(30);
  const std::string name = "g" + std::to_string(below(200));
  if (count == 0 || (kind < 2 && count < kMostGlyphs)) {
    return {{"do", "add_glyph"},
            {"glyph", name},
            {"width", below(1000)},
            {"unicodes", {static_cast<unsigned>(0x20 + below(500))}}};
  }
  const std::string glyph = any_glyph(project);
  if (kind == 2) {
    return {{"do", "delete_glyph"}, {"glyph", glyph}};
  }
  if (kind == 3) {
    return {{"do", "rename_glyph"}, {"glyph", glyph}, {"to", name}};
  }
  if (kind == 4) {
    return {{"do", "add_component"},
            {"glyph", glyph},
            {"base", any_glyph(project)},
            {"matrix", {1, 0, 0.25 * below(3), -1, coordinate(), 7}}};
  }
  const GlyphPointer found = project.glyph(glyph);
  if (is_large(*found)) {
    return {{"do", "set_contours"},
            {"glyph", glyph},
            {"contours", Value::array({points()})}};
  }
  return on_glyph(glyph, *found);
}

Value RandomCommands::points() {
  Value list = Value::array();
  const int pieces = 1 + below(4);
  const bool open = below(5) == 0;
  if (open) {
    list.push_back({coordinate(), coordinate(), "move"});
  }
  for (int i = 0; i < pieces; ++i) {
    const int kind = below(3);
    for (int k = 0; k < kind; ++k) {
      list.push_back({coordinate(), coordinate(), "offcurve"});
    }
    const char* const types[] = {"line", "qcurve", "curve"};
    list.push_back({coordinate(), coordinate(), types[kind]});
  }
  return list;
}

Value RandomCommands::on_glyph(const std::string& name, const Glyph& glyph) {
  Value command = {{"glyph", name}};
  const auto make = [&command](const char* what) {
    command["do"] = what;
    return command;
  };
  switch (below(13)) {
    case 0:
      command["width"] = coordinate();
      return make("set_advance");
    case 1:
      command["key"] = "org.inkcell.test" + std::to_string(below(3));
      if (below(3) != 0) {
        command["value"] = {{"a", below(9)}, {"b", {true, "x", 0.5}}};
      }
      return make("set_glyph_lib");
    case 2:
      command["matrix"] = {0.5 + below(4) * 0.5, 0, 0, 1, 3, -2};
      command["round"] = below(2) == 0;
      return make("transform");
    case 3:
      if (glyph.anchors.size() >= kMostParts) {
        command["anchor"] = 0;
        return make("delete_anchor");
      }
      command["name"] = "top";
      command["x"] = coordinate();
      command["y"] = coordinate();
      return make("add_anchor");
    case 4:
      command["anchor"] = below(2);
      return make("delete_anchor");
    case 5:
      command["component"] = 0;
      return make(below(2) == 0 ? "delete_component" : "set_component");
    case 6:
      return make("decompose");
    case 7:
      if (glyph.guidelines.size() >= kMostParts) {
        command["guideline"] = 0;
        return make("delete_guideline");
      }
      command["y"] = coordinate();
      return make("add_guideline");
    case 8:
      command["guideline"] = below(2);
      return make("delete_guideline");
    case 9:
      command["unicodes"] = {static_cast<unsigned>(below(9999))};
      return make("set_unicodes");
    case 10:
      if (below(3) != 0) {
        const std::string number = std::to_string(below(3));
        command["file"] = "p" + number + ".png";
        command["data"] = "iVBORw0KGgo" + number;  // a PNG's first bytes
      }
      return make("set_image");
    default:
      return on_contour(command, glyph);
  }
}

Value RandomCommands::on_contour(Value command, const Glyph& glyph) {
  const auto make = [&command](const char* what) {
    command["do"] = what;
    return command;
  };
  const size_t count = glyph.contours.size();
  if (count < 2 || (below(6) == 0 && count < kMostContours)) {
    command["points"] = points();
    return make("add_contour");
  }
  const size_t contour = static_cast<size_t>(below(static_cast<int>(count)));
  const size_t size = glyph.contours[contour].points.size();
  const size_t point = static_cast<size_t>(below(static_cast<int>(size) + 1));
  command["contour"] = contour;
  switch (below(9)) {
    case 0:
      return make("delete_contour");
    case 1:
      return make("reverse_contour");
    case 2:
      command["point"] = point;
      return make("delete_point");
    case 3:
      command["point"] = point;
      return make("set_start");
    case 4:
      command["point"] = point;
      command["x"] = coordinate();
      command["smooth"] = below(2) == 0;
      return make("set_point");
    case 5:
      command["at"] = point;
      command["points"] = points();
      return make("insert_points");
    case 6:
      command["grid"] = 1 + below(8);
      return make("round_points");
    case 7:
      command["contours"] = {points(), points()};
      return make("set_contours");
    default:
      command["points"] = {{contour, point}, {contour, 0u}};
      command["dx"] = below(200) - 100;
      command["dy"] = 0.125 * below(100);
      return make("move_points");
  }
}

Value RandomCommands::on_font(const Project& project) {
  const std::string key = "key" + std::to_string(below(5));
  switch (below(5)) {
    case 0:
      return {{"do", "set_info"}, {"key", "descender"}, {"value", -below(300)}};
    case 1:
      return {{"do", "set_kerning"},
              {"left", any_glyph(project)},
              {"right", key},
              {"value", below(100) - 50}};
    case 2:
      return {
          {"do", "set_group"}, {"group", key}, {"value", {any_glyph(project)}}};
    case 3:
      return {{"do", "set_lib"}, {"key", key}};
    default:
      return {{"do", "set_features"}, {"text", "# " + key + "\n"}};
  }
}

}  // namespace inkcell::design::test
