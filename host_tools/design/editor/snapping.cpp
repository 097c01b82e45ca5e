#include "editor/snapping.hpp"

#include <cmath>

#include "editor/strokes.hpp"
#include "model/sources.hpp"
#include "shape/points.hpp"

namespace inkcell::design::editor {
namespace {

// The nearest of several coordinates, and a point that has it.
struct Nearest {
  double distance = 0;
  double value = 0;
  Point at;
  bool is_found = false;

  void offer(double candidate, double wanted, Point point) {
    const double d = std::abs(candidate - wanted);
    if (d < distance) {
      *this = {d, candidate, point, true};
    }
  }
};

struct Attraction {
  Nearest x;
  Nearest y;
};

void offer_guides(const Glyph& glyph, Point wanted, Attraction& found) {
  for (const Guideline& line : glyph.guidelines) {
    if (line.x && !line.y) {
      found.x.offer(*line.x, wanted.x, {*line.x, 0});
    } else if (line.y && (!line.x || line.angle.value_or(0) == 0)) {
      found.y.offer(*line.y, wanted.y, {0, *line.y});
    }
  }
}

// Points and knots that are not selected.
void offer_points(const Editor& editor,
                  const Glyph& glyph,
                  Point wanted,
                  Attraction& found) {
  const auto offer = [&](Point at) {
    found.x.offer(at.x, wanted.x, at);
    found.y.offer(at.y, wanted.y, at);
  };
  for (size_t c = 0; c < own_contours(glyph); ++c) {
    const std::vector<GlyphPoint>& points = glyph.contours[c].points;
    for (size_t p = 0; p < points.size(); ++p) {
      if (points[p].on_curve() && editor.selection.count({c, p}) == 0) {
        offer({points[p].x, points[p].y});
      }
    }
  }
  const std::vector<Stroke> strokes = strokes_of(glyph);
  for (size_t s = 0; s < strokes.size(); ++s) {
    for (size_t k = 0; k < strokes[s].points.size(); ++k) {
      if (editor.knots.count({s, k}) == 0) {
        offer(strokes[s].points[k].at);
      }
    }
  }
}

}  // namespace

std::vector<Zone> zones_of(const Project& project) {
  const Value& info = project.font->info;
  const double em = project.units_per_em();
  std::vector<Zone> zones = {{"baseline", 0},
                             {"ascender", info.value("ascender", 0.8 * em)},
                             {"descender", info.value("descender", -0.2 * em)}};
  for (const auto& [label, key] : {std::pair("x-height", "xHeight"),
                                   std::pair("cap height", "capHeight")}) {
    if (info.contains(key)) {
      zones.push_back({label, info.value(key, 0.0)});
    }
  }
  return zones;
}

gen::Segment line_of(const Guideline& guide) {
  const double turn =
      gen::kDegree * guide.angle.value_or(guide.x && !guide.y ? 90 : 0);
  gen::Segment line;
  line.p[0] = {guide.x.value_or(0), guide.y.value_or(0)};
  line.p[1] = {line.p[0].x + std::cos(turn), line.p[0].y + std::sin(turn)};
  return line;
}

Snap snap(const Editor& editor,
          Point from,
          Point move,
          double reach,
          bool keeps_x,
          bool keeps_y) {
  const GlyphPointer glyph = editor.stored();
  const Point wanted = {from.x + move.x, from.y + move.y};
  const Nearest none = {reach, 0, {}, false};
  Attraction found = {none, none};
  offer_points(editor, *glyph, wanted, found);
  offer_guides(*glyph, wanted, found);
  for (const Zone& zone : zones_of(editor.project())) {
    found.y.offer(zone.y, wanted.y, {0, zone.y});
  }
  for (const double x : {0.0, glyph->width}) {
    found.x.offer(x, wanted.x, {x, 0});
  }
  Snap result = {move.x, move.y, {}};
  Point at = wanted;
  if (found.x.is_found && !keeps_x) {
    at.x = found.x.value;
    result.dx = std::round(at.x - from.x);
  }
  if (found.y.is_found && !keeps_y) {
    at.y = found.y.value;
    result.dy = std::round(at.y - from.y);
  }
  if (found.x.is_found && !keeps_x) {
    result.lines.push_back({{at.x, found.x.at.y}, at});
  }
  if (found.y.is_found && !keeps_y) {
    result.lines.push_back({{found.y.at.x, at.y}, at});
  }
  return result;
}

}  // namespace inkcell::design::editor
