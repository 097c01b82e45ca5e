// Commands on the sources of outlines: strokes and trees of shapes. The source
// is stored in the glyph's lib, its outline in the contours.
#include "component/csg.hpp"
#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "shape/outline.hpp"
#include "shape/points.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design {
namespace {

constexpr const char* kStrokesKey = "org.inkcell.strokes";
constexpr const char* kTreeKey = "org.inkcell.tree";

// The tolerance of curves against the exact border, and of a stroke's path
// against its points. [u]
constexpr double kFit_u = 0.12;
constexpr double kPathFit_u = 0.5;

std::vector<PointContour> fitted(
    const Project& project, const std::vector<std::vector<Point>>& polygons) {
  return contours_of(project, fit_polygons(polygons, kFit_u));
}

StrokePoint point_of(const Value& value,
                     double scale,
                     const Arguments& arguments) {
  const bool ok = value.is_array() && value.size() >= 2 && value.size() <= 5 &&
                  value[0].is_number() && value[1].is_number();
  if (!ok) {
    arguments.refuse(
        "points of a stroke are [x, y, width, height, angle], the last three "
        "null or left out where nothing changes");
  }
  StrokePoint point;
  point.at = {scale * value[0].get<double>(), scale * value[1].get<double>()};
  const auto change = [&value](size_t i, double unit_size) {
    return i < value.size() && value[i].is_number()
               ? std::optional<double>(unit_size * value[i].get<double>())
               : std::nullopt;
  };
  point.width = change(2, scale);
  point.height = change(3, scale);
  point.angle = change(4, gen::kDegree);
  return point;
}

Change set_strokes(const Project& project, const Arguments& arguments) {
  const double scale = gen::kUPerEm / project.units_per_em();
  std::vector<std::vector<Point>> polygons;
  for (const Value& value : arguments.array("strokes")) {
    if (!value.is_object() || !value.contains("nib") ||
        !value["nib"].is_string() || !value.contains("points")) {
      arguments.refuse(
          "strokes are { \"nib\": \"ellipse:80,30,45\", \"points\": [...] }");
    }
    Stroke stroke;
    stroke.nib = parse_nib(value["nib"].get<std::string>());
    stroke.nib.width *= scale;
    stroke.nib.height *= scale;
    for (const Value& point : value["points"]) {
      stroke.points.push_back(point_of(point, scale, arguments));
    }
    for (std::vector<Point>& polygon : polygons_of(stroke, kPathFit_u)) {
      polygons.push_back(std::move(polygon));
    }
  }
  const gen::Shape shape(outline_of_polygons(polygons));
  return edited(project, arguments, [&](Glyph& glyph) {
    glyph.contours = fitted(project, polygons_of(shape));
    glyph.lib[kStrokesKey] = arguments.value("strokes");
    glyph.lib.erase(kTreeKey);
  });
}

Change set_tree(const Project& project, const Arguments& arguments) {
  const gen::Shape shape = shape_of_tree(project, layer_of(project, arguments),
                                         arguments.value("tree"));
  return edited(project, arguments, [&](Glyph& glyph) {
    glyph.contours = fitted(project, polygons_of(shape));
    glyph.lib[kTreeKey] = arguments.value("tree");
    glyph.lib.erase(kStrokesKey);
  });
}

}  // namespace

void add_source_commands(CommandTable& table) {
  table["set_strokes"] = set_strokes;
  table["set_tree"] = set_tree;
}

}  // namespace inkcell::design
