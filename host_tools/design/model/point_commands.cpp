// Commands on points.
#include <algorithm>
#include <cmath>

#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "model/point_selection.hpp"
#include "shape/points.hpp"

namespace inkcell::design {
namespace {

PointContour& contour_of(Glyph& glyph, const Arguments& arguments) {
  return glyph.contours[arguments.index("contour", glyph.contours.size())];
}

Change move_points(const Project& project, const Arguments& arguments) {
  const double dx = arguments.number("dx", 0);
  const double dy = arguments.number("dy", 0);
  return edited(project, arguments, [&](Glyph& glyph) {
    for (const auto& [contour, point] : parse_selection(glyph, arguments)) {
      GlyphPoint& moved = glyph.contours[contour].points[point];
      moved.x += dx;
      moved.y += dy;
    }
  });
}

Change set_point(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    PointContour& contour = contour_of(glyph, arguments);
    GlyphPoint& point =
        contour.points[arguments.index("point", contour.points.size())];
    point.x = arguments.number("x", point.x);
    point.y = arguments.number("y", point.y);
    point.type = parse_type(arguments.text("type", type_name(point.type)));
    point.smooth = arguments.flag("smooth", point.smooth) && point.on_curve();
    check_contour(contour);
  });
}

Change insert_points(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    PointContour& contour = contour_of(glyph, arguments);
    const size_t at = arguments.place("at", contour.points.size());
    // The order of points only makes sense in the whole contour.
    Value all = contour_value(contour);
    const Value& added = arguments.array("points");
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), added.begin(),
               added.end());
    const PointContour parsed = parse_contour(all);
    contour.points.insert(
        contour.points.begin() + static_cast<std::ptrdiff_t>(at),
        parsed.points.begin() + static_cast<std::ptrdiff_t>(at),
        parsed.points.begin() + static_cast<std::ptrdiff_t>(at + added.size()));
  });
}

// Deleting an on-curve point also deletes the off-curve points before it that
// the remaining curve does not need.
Change delete_point(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    PointContour& contour = contour_of(glyph, arguments);
    std::vector<GlyphPoint>& points = contour.points;
    const size_t at = arguments.index("point", points.size());
    const GlyphPoint gone = points[at];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(at));
    if (gone.type == PointType::move && !points.empty()) {
      while (!points.empty() && !points.front().on_curve()) {
        points.erase(points.begin());
      }
      if (!points.empty()) {
        points.front().type = PointType::move;
      }
    }
    while (contour.open() && !points.back().on_curve()) {
      points.pop_back();
    }
    check_contour(contour);
  });
}

Change set_start(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [&](Glyph& glyph) {
    PointContour& contour = contour_of(glyph, arguments);
    const size_t at = arguments.index("point", contour.points.size());
    if (contour.open()) {
      arguments.refuse("an open contour begins where it begins");
    }
    std::rotate(contour.points.begin(),
                contour.points.begin() + static_cast<std::ptrdiff_t>(at),
                contour.points.end());
  });
}

Change round_points(const Project& project, const Arguments& arguments) {
  const double grid = arguments.number("grid", 1);
  if (!(grid > 0)) {
    arguments.refuse("\"grid\" is above 0");
  }
  return edited(project, arguments, [grid](Glyph& glyph) {
    for (PointContour& contour : glyph.contours) {
      for (GlyphPoint& point : contour.points) {
        point.x = std::round(point.x / grid) * grid;
        point.y = std::round(point.y / grid) * grid;
      }
    }
  });
}

gen::Segment cubic_of(const gen::Segment& segment) {
  if (segment.kind != gen::Segment::Kind::quadratic) {
    return segment;
  }
  const gen::Point* p = segment.p;
  const gen::Point control = 2.0 / 3 * p[1];
  return {gen::Segment::Kind::cubic,
          {p[0], control + 1.0 / 3 * p[0], control + 1.0 / 3 * p[2], p[2]}};
}

Change to_cubics(const Project& project, const Arguments& arguments) {
  return edited(project, arguments, [](Glyph& glyph) {
    for (PointContour& contour : glyph.contours) {
      const bool has_quadratics = std::any_of(
          contour.points.begin(), contour.points.end(),
          [](const auto& point) { return point.type == PointType::qcurve; });
      const bool is_off_curve = std::none_of(
          contour.points.begin(), contour.points.end(),
          [](const GlyphPoint& point) { return point.on_curve(); });
      gen::Contour curves = to_segments(contour, 1);
      if (!(has_quadratics || is_off_curve) || curves.segments.empty()) {
        continue;
      }
      std::transform(curves.segments.begin(), curves.segments.end(),
                     curves.segments.begin(), cubic_of);
      contour.points = from_segments(curves, 1).points;
      for (GlyphPoint& point : contour.points) {
        point.x = std::round(point.x);
        point.y = std::round(point.y);
      }
    }
  });
}

}  // namespace

PointSelection parse_selection(const Glyph& glyph, const Arguments& arguments) {
  PointSelection selected;
  for (const Value& pair : arguments.array("points")) {
    const bool ok = pair.is_array() && pair.size() == 2 &&
                    pair[0].is_number_unsigned() &&
                    pair[1].is_number_unsigned() &&
                    pair[0].get<size_t>() < glyph.contours.size() &&
                    pair[1].get<size_t>() <
                        glyph.contours[pair[0].get<size_t>()].points.size();
    if (!ok) {
      arguments.refuse("\"points\" are pairs of a contour and a point; " +
                       pair.dump() + " is none of this glyph");
    }
    selected.emplace(pair[0].get<size_t>(), pair[1].get<size_t>());
  }
  return selected;
}

void add_point_commands(CommandTable& table) {
  table["delete_point"] = delete_point;
  table["insert_points"] = insert_points;
  table["move_points"] = move_points;
  table["round_points"] = round_points;
  table["set_point"] = set_point;
  table["set_start"] = set_start;
  table["to_cubics"] = to_cubics;
}

}  // namespace inkcell::design
