// Commands on the sources of outlines: strokes and trees of shapes. The source
// is stored in the glyph's lib, its outline in the contours.
#include <algorithm>

#include "component/contour_csg.hpp"
#include "component/csg.hpp"
#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "shape/outline.hpp"
#include "stroke/stroke.hpp"

namespace inkcell::design {
namespace {

// The tolerance of curves against the exact border, and of a stroke's path
// against its points. [u]
constexpr double kFit_u = 0.12;
constexpr double kPathFit_u = 0.5;

std::vector<PointContour> fitted(const Project& project,
                                 const Arguments& arguments,
                                 const Glyph& glyph,
                                 const gen::Shape& shape) {
  return in_direction_of(
      project, glyph,
      contours_of(project, fit_polygons(polygons_of(shape), kFit_u),
                  arguments.number("grid", 1)));
}

// The area of a stroke of a command.
struct SweptStroke {
  Value stroke;
  double scale = 0;
  std::vector<std::vector<Point>> polygons;
};

// The areas of strokes. A pointer that drags a knot asks for the same glyph
// again and again, with one stroke changed: those of the last command are kept.
const std::vector<SweptStroke>& swept(const Value& strokes, double scale) {
  thread_local std::vector<SweptStroke> last;
  std::vector<SweptStroke> now;
  for (const Value& stroke : strokes) {
    const auto kept =
        std::find_if(last.begin(), last.end(), [&](const SweptStroke& swept) {
          return swept.scale == scale && swept.stroke == stroke;
        });
    now.push_back(kept != last.end()
                      ? *kept
                      : SweptStroke{stroke, scale,
                                    polygons_of(parse_stroke(stroke, scale),
                                                kPathFit_u)});
  }
  last = std::move(now);
  return last;
}

Change set_strokes(const Project& project, const Arguments& arguments) {
  const double scale = gen::kUPerEm / project.units_per_em();
  std::vector<std::vector<Point>> polygons;
  for (const SweptStroke& stroke : swept(arguments.array("strokes"), scale)) {
    polygons.insert(polygons.end(), stroke.polygons.begin(),
                    stroke.polygons.end());
  }
  const gen::Shape shape(outline_of_polygons(polygons));
  return edited(
      project, arguments,
      [&](Glyph& glyph) {
        const std::vector<PointContour> outline =
            fitted(project, arguments, glyph, shape);
        const size_t own = own_contours(glyph);
        glyph.contours.resize(own);
        glyph.contours.insert(glyph.contours.end(), outline.begin(),
                              outline.end());
        glyph.lib.erase(kTreeKey);
        glyph.lib[kStrokesKey] = arguments.value("strokes");
        if (own != 0) {
          glyph.lib[kOwnContoursKey] = own;
        }
      },
      true);
}

// follow_parts() makes the contours.
Change set_tree(const Project& project, const Arguments& arguments) {
  const Value& tree = arguments.value("tree");
  return edited(
      project, arguments,
      [&](Glyph& glyph) {
        drop_source(glyph);
        glyph.lib[kTreeKey] = tree;
      },
      true);
}

// The area of some contours with that of the others.
Change combine_contours(const Project& project, const Arguments& arguments) {
  const std::string op = arguments.text("op");
  return edited(project, arguments, [&](Glyph& glyph) {
    std::vector<bool> is_named(glyph.contours.size());
    for (const Value& index : arguments.array("contours")) {
      if (!index.is_number_unsigned() ||
          index.get<size_t>() >= glyph.contours.size()) {
        arguments.refuse("\"contours\" are numbers below " +
                         std::to_string(glyph.contours.size()) +
                         ", the glyph's contours; " + index.dump() +
                         " is none");
      }
      is_named[index.get<size_t>()] = true;
    }
    // The outline of strokes only if it is named.
    const auto own =
        is_named.begin() + static_cast<std::ptrdiff_t>(own_contours(glyph));
    const bool names_own =
        std::find(own, is_named.end(), true) == is_named.end();
    const size_t count = names_own ? own_contours(glyph) : is_named.size();
    std::vector<PointContour> parts[2];
    for (size_t i = 0; i < count; ++i) {
      parts[is_named[i] ? 1 : 0].push_back(glyph.contours[i]);
    }
    std::vector<PointContour> result =
        in_direction_of(project, glyph, combined(parts[0], parts[1], op));
    result.insert(result.end(),
                  glyph.contours.begin() + static_cast<std::ptrdiff_t>(count),
                  glyph.contours.end());
    glyph.contours = std::move(result);
  });
}

}  // namespace

void add_source_commands(CommandTable& table) {
  table["set_strokes"] = set_strokes;
  table["combine_contours"] = combine_contours;
  table["set_tree"] = set_tree;
}

}  // namespace inkcell::design
