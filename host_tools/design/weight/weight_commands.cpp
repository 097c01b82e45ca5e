// The commands that move edges: offset and weight.
#include <algorithm>
#include <cmath>
#include <set>

#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "shape/points.hpp"
#include "weight/weight.hpp"

namespace inkcell::design {
namespace {

// What bars grow by for each unit of stems.
constexpr double kBarsOfStems = 0.6;

using Contours = std::vector<PointContour>;

Contours mapped(Contours contours, const Matrix& matrix) {
  for (PointContour& contour : contours) {
    for (GlyphPoint& point : contour.points) {
      const Point to = matrix.map(point.x, point.y);
      point.x = to.x;
      point.y = to.y;
    }
  }
  return contours;
}

void round_all(Contours& contours) {
  for (PointContour& contour : contours) {
    for (GlyphPoint& point : contour.points) {
      point.x = std::round(point.x);
      point.y = std::round(point.y);
    }
  }
}

// From font units to u, upright.
Matrix to_upright_u(const Project& project) {
  const double scale = gen::kUPerEm / project.units_per_em();
  const double angle = project.font->info.value("italicAngle", 0.0);
  Matrix m;
  m.xx = scale;
  m.yy = scale;
  m.yx = scale * std::tan(gen::kDegree * angle);
  return m;
}

Matrix inverse(const Matrix& m) {  // of a slant and a scale
  Matrix back;
  back.xx = 1 / m.xx;
  back.yy = 1 / m.yy;
  back.yx = -m.yx / (m.xx * m.yy);
  return back;
}

Contours offset_by(const Contours& contours, double by, bool is_clockwise) {
  Contours result;
  for (const PointContour& contour : contours) {
    result.push_back(
        moved(contour, pieces_of(contour), {by, by}, is_clockwise));
  }
  return result;
}

Change offset(const Project& project, const Arguments& arguments) {
  const double by = arguments.number("by");
  const std::string side = arguments.text("side", "outside");
  if (!(by > 0) || (side != "outside" && side != "inside" && side != "both")) {
    arguments.refuse("\"by\" is above 0, \"side\" is outside, inside or both");
  }
  return edited(project, arguments, [&](Glyph& glyph) {
    const bool is_clockwise = design::is_clockwise(project, glyph);
    const double scale = gen::kUPerEm / project.units_per_em();
    Matrix to_u;
    to_u.xx = to_u.yy = scale;
    const Contours before = mapped(glyph.contours, to_u);
    const auto at = [&](double u) {
      return mapped(offset_by(before, u, is_clockwise), inverse(to_u));
    };
    Contours after;
    if (side != "inside") {
      after = at(by * scale);
    }
    if (side != "outside") {
      for (const PointContour& contour : at(-by * scale)) {
        after.push_back(side == "both" ? reversed(contour) : contour);
      }
    }
    round_all(after);
    glyph.contours = std::move(after);
  });
}

Heights heights_of(const Project& project, size_t layer) {
  Heights heights = {{}, {0}};
  const double scale = gen::kUPerEm / project.units_per_em();
  for (const char* name : {"x", "H", "d", "p"}) {
    const GlyphPointer glyph = project.find(name, layer);
    if (glyph != nullptr && !glyph->contours.empty()) {
      const gen::Shape shape(outline_of(project, *glyph, layer));
      heights.bottoms.push_back(shape.box().y0);
      heights.tops.push_back(shape.box().y1);
    }
  }
  const Value& info = project.font->info;
  for (const char* key : {"xHeight", "capHeight"}) {
    if (info.contains(key)) {
      heights.tops.push_back(scale * info[key].get<double>());
    }
  }
  return heights;
}

// The ink's ends from left to right. [font units]
std::pair<double, double> ink_of(const Project& project,
                                 const Glyph& glyph,
                                 size_t layer) {
  const gen::Shape shape(outline_of(project, glyph, layer));
  const double scale = project.units_per_em() / gen::kUPerEm;
  return {scale * shape.box().x0, scale * shape.box().x1};
}

struct Weighing {
  const Project& project;
  const Arguments& arguments;
  size_t layer;
  WeightChange change;  // is_clockwise is that of each glyph
};

Weighing weighing_of(const Project& project, const Arguments& arguments) {
  const size_t layer = layer_of(project, arguments);
  const double by = arguments.number("by");
  const double bars = arguments.number("bars", kBarsOfStems * by);
  const double counters = arguments.number("counters", 100);
  if (!(counters >= 0 && counters <= 100)) {
    arguments.refuse(
        "\"counters\" is 100 for those that stay, 0 for those that give all, "
        "or between");
  }
  const double most = project.units_per_em() / 4;
  if (!(std::abs(by) <= most && std::abs(bars) <= most)) {
    arguments.refuse("\"by\" and \"bars\" are at most a quarter of the em");
  }
  const double half = gen::kUPerEm / project.units_per_em() / 2;
  return {project,
          arguments,
          layer,
          {{half * by, half * bars},
           1 - counters / 100,
           heights_of(project, layer),
           false}};
}

void weigh_contours(Weighing& weighing, Glyph& glyph) {
  const Matrix to_u = to_upright_u(weighing.project);
  weighing.change.is_clockwise = is_clockwise(weighing.project, glyph);
  const Glyph before = glyph;
  glyph.contours =
      mapped(with_weight(mapped(glyph.contours, to_u), weighing.change),
             inverse(to_u));
  round_all(glyph.contours);
  settle_source(before, glyph);
  Glyph bare[2] = {before, glyph};
  for (Glyph& one : bare) {
    one.components.clear();
  }
  const auto was = ink_of(weighing.project, bare[0], weighing.layer);
  const auto now = ink_of(weighing.project, bare[1], weighing.layer);
  const double wider =
      std::round(now.second - now.first - was.second + was.first);
  double width = glyph.width + wider;  // both bearings stay
  if (weighing.arguments.has("advance")) {
    const Value& advance = weighing.arguments.value("advance");
    if (advance != "keep" && !advance.is_number()) {
      weighing.arguments.refuse("\"advance\" is \"keep\" or a number");
    }
    width = advance.is_number() ? advance.get<double>() : glyph.width;
  }
  // What is missing, or too much, is shared by both bearings.
  const double dx = std::round((width - glyph.width - wider) / 2);
  for (PointContour& contour : glyph.contours) {
    for (GlyphPoint& point : contour.points) {
      point.x += dx;
    }
  }
  for (Anchor& anchor : glyph.anchors) {
    anchor.x += std::round(anchor.x / std::max(glyph.width, 1.0) *
                           (width - glyph.width));
  }
  glyph.width = width;
}

// A glyph of components: the advance of its first one, above whose middle the
// others stay.
void follow_components(const Project& before,
                       const Project& after,
                       size_t layer,
                       Glyph& glyph) {
  const auto middle_moved = [&](const std::string& name) {
    const auto a = ink_of(before, *before.glyph(name, layer), layer);
    const auto b = ink_of(after, *after.glyph(name, layer), layer);
    return (b.first + b.second - a.first - a.second) / 2;
  };
  const std::string base = glyph.components.front().base;
  glyph.width +=
      after.glyph(base, layer)->width - before.glyph(base, layer)->width;
  for (size_t i = 1; i < glyph.components.size(); ++i) {
    ComponentUse& use = glyph.components[i];
    use.matrix.dx +=
        std::round(middle_moved(base) - use.matrix.xx * middle_moved(use.base));
  }
}

std::vector<std::string> names_of(const Weighing& weighing) {
  const Arguments& arguments = weighing.arguments;
  if (arguments.has("glyph")) {
    return {arguments.text("glyph")};
  }
  std::vector<std::string> names;
  if (arguments.value("glyphs") == "all") {
    for (const auto& [name, glyph] :
         weighing.project.layers[weighing.layer].glyphs) {
      names.push_back(name);
    }
    return names;
  }
  for (const Value& name : arguments.array("glyphs")) {
    if (!name.is_string()) {
      arguments.refuse("\"glyphs\" is \"all\" or lists names of glyphs");
    }
    names.push_back(name.get<std::string>());
  }
  return names;
}

Change change_weight(const Project& project, const Arguments& arguments) {
  Weighing weighing = weighing_of(project, arguments);
  Project after = project;
  Change change;
  const auto add = [&](const std::string& name, Glyph glyph) {
    GlyphChange entry = {weighing.layer, name,
                         project.glyph(name, weighing.layer),
                         std::make_shared<const Glyph>(std::move(glyph))};
    after.layers[weighing.layer].glyphs[name] = entry.after;
    change.glyphs.push_back(std::move(entry));
  };
  std::vector<std::string> composites;
  for (const std::string& name : names_of(weighing)) {
    Glyph glyph = *project.glyph(name, weighing.layer);
    if (!glyph.contours.empty()) {
      weigh_contours(weighing, glyph);
      add(name, std::move(glyph));
    } else if (!glyph.components.empty()) {
      composites.push_back(name);
    }
  }
  for (const std::string& name : composites) {
    Glyph glyph = *project.glyph(name, weighing.layer);
    follow_components(project, after, weighing.layer, glyph);
    if (!(glyph == *project.glyph(name, weighing.layer))) {
      add(name, std::move(glyph));
    }
  }
  return change;
}

}  // namespace

void add_weight_commands(CommandTable& table) {
  table["change_weight"] = change_weight;
  table["offset"] = offset;
}

}  // namespace inkcell::design
