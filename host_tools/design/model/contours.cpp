#include "model/contours.hpp"

#include <algorithm>
#include <cmath>

#include "model/error.hpp"
#include "outlines/curves.hpp"
#include "shape/outline.hpp"
#include "shape/points.hpp"

namespace inkcell::design {
namespace {

// The deepest nesting of references, more than fonts have.
constexpr int kMostDepth = 16;

// A joint is smooth if it turns by less. [cosine of a degree]
constexpr double kSmoothCosine = 0.99985;

gen::Point scaled(const GlyphPoint& p, double scale) {
  return {p.x * scale, p.y * scale};
}

void add_segment(gen::Contour& out, std::initializer_list<gen::Point> points) {
  gen::Segment segment;
  segment.kind = points.size() == 2   ? gen::Segment::Kind::line
                 : points.size() == 3 ? gen::Segment::Kind::quadratic
                                      : gen::Segment::Kind::cubic;
  std::copy(points.begin(), points.end(), segment.p);
  out.segments.push_back(segment);
}

// Adds a piece from `from` to `to` with the off-curve points between them.
void add_piece(gen::Contour& out,
               const gen::Point& from,
               const std::vector<gen::Point>& controls,
               const gen::Point& to,
               PointType type) {
  if (controls.empty()) {
    add_segment(out, {from, to});
  } else if (type == PointType::curve && controls.size() == 2) {
    add_segment(out, {from, controls[0], controls[1], to});
  } else {
    gen::Point at = from;
    for (size_t i = 0; i + 1 < controls.size(); ++i) {
      const gen::Point next = middle(controls[i], controls[i + 1]);
      add_segment(out, {at, controls[i], next});
      at = next;
    }
    add_segment(out, {at, controls.back(), to});
  }
}

int degree(const gen::Segment& segment) {
  return segment.kind == gen::Segment::Kind::line        ? 1
         : segment.kind == gen::Segment::Kind::quadratic ? 2
                                                         : 3;
}

gen::Point unit(const gen::Point& a, const gen::Point& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return length == 0 ? gen::Point{0, 0}
                     : gen::Point{(b.x - a.x) / length, (b.y - a.y) / length};
}

bool joins_smoothly(const gen::Segment& a, const gen::Segment& b) {
  const bool both_lines = degree(a) == 1 && degree(b) == 1;
  const gen::Point in = unit(a.p[degree(a) - 1], a.p[degree(a)]);
  const gen::Point out = unit(b.p[0], b.p[1]);
  return !both_lines && in.x * out.x + in.y * out.y > kSmoothCosine;
}

bool reaches_within(const Project& project,
                    size_t layer,
                    const std::string& from,
                    const std::string& target,
                    int depth) {
  if (from == target) {
    return true;
  }
  const GlyphPointer glyph = project.find(from, layer);
  if (glyph == nullptr || depth == 0) {
    return false;
  }
  return std::any_of(glyph->components.begin(), glyph->components.end(),
                     [&](const ComponentUse& use) {
                       return reaches_within(project, layer, use.base, target,
                                             depth - 1);
                     });
}

void append_within(const Project& project,
                   size_t layer,
                   const ComponentUse& use,
                   int depth,
                   std::vector<PointContour>& contours) {
  const GlyphPointer base = project.find(use.base, layer);
  if (base == nullptr) {
    throw Error("there is no glyph '" + use.base +
                "', which is used as a component; add it, or remove the "
                "component");
  }
  if (depth == 0) {
    throw Error("the glyph '" + use.base +
                "' contains itself, or components are nested too deeply");
  }
  std::vector<PointContour> parts = base->contours;
  for (const ComponentUse& inner : base->components) {
    append_within(project, layer, inner, depth - 1, parts);
  }
  for (PointContour& contour : parts) {
    contour.identifier.clear();
    for (GlyphPoint& point : contour.points) {
      const gen::Point to = use.matrix.map(point.x, point.y);
      point.x = to.x;
      point.y = to.y;
      point.identifier.clear();
    }
    // A reflection would swap the filled side.
    contours.push_back(use.matrix.determinant() < 0 ? reversed(contour)
                                                    : contour);
  }
}

// Leaves out on-curve points in the middle of off-curve points of quadratics,
// but for one.
void drop_implied(PointContour& contour) {
  std::vector<GlyphPoint>& points = contour.points;
  const auto type_after = [&points](size_t i) {
    do {
      i = (i + 1) % points.size();
    } while (!points[i].on_curve());
    return points[i].type;
  };
  auto left = std::count_if(points.begin(), points.end(),
                            [](const GlyphPoint& p) { return p.on_curve(); });
  for (size_t i = points.size(); i-- > 0 && left > 1;) {
    const size_t count = points.size();
    const GlyphPoint& before = points[(i + count - 1) % count];
    const GlyphPoint& after = points[(i + 1) % count];
    if (points[i].type == PointType::qcurve && !before.on_curve() &&
        !after.on_curve() && type_after(i) == PointType::qcurve &&
        points[i].x == (before.x + after.x) / 2 &&
        points[i].y == (before.y + after.y) / 2) {
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      --left;
    }
  }
}

// twice_area() of the largest contour of the glyph and its components; 0
// without contours.
double largest_area(const Project& project, const Glyph& glyph) {
  double largest = 0;
  const auto add = [&largest](const Glyph& part, double scale) {
    for (const PointContour& contour : part.contours) {
      const double area = scale * twice_area(contour);
      largest = std::abs(area) > std::abs(largest) ? area : largest;
    }
  };
  add(glyph, 1);
  for (const ComponentUse& use : glyph.components) {
    const GlyphPointer base = project.find(use.base);
    if (base != nullptr) {
      add(*base, std::abs(use.matrix.determinant()));
    }
  }
  return largest;
}

}  // namespace

PointContour parse_contour(const Value& points) {
  const auto refuse = [] {
    throw Error(
        "points are [x, y], [x, y, \"curve\"] or [x, y, \"curve\", "
        "\"smooth\"]");
  };
  PointContour contour;
  if (!points.is_array()) {
    refuse();
  }
  for (const Value& value : points) {
    const bool ok = value.is_array() && value.size() >= 2 &&
                    value.size() <= 4 && value[0].is_number() &&
                    value[1].is_number() &&
                    (value.size() < 3 || value[2].is_string()) &&
                    (value.size() < 4 || value[3] == "smooth");
    if (!ok) {
      refuse();
    }
    GlyphPoint point;
    point.x = value[0].get<double>();
    point.y = value[1].get<double>();
    if (value.size() >= 3) {
      point.type = parse_type(value[2].get<std::string>());
    }
    point.smooth = value.size() == 4;
    contour.points.push_back(point);
  }
  check_contour(contour);
  return contour;
}

Value contour_value(const PointContour& contour) {
  Value points = Value::array();
  for (const GlyphPoint& point : contour.points) {
    Value value = {point.x, point.y, type_name(point.type)};
    if (point.smooth) {
      value.push_back("smooth");
    }
    points.push_back(std::move(value));
  }
  return points;
}

void check_contour(const PointContour& contour) {
  const std::vector<GlyphPoint>& points = contour.points;
  size_t controls = 0;
  // Off-curve points at the end of a closed contour belong to its first point.
  if (!contour.open()) {
    for (auto p = points.rbegin(); p != points.rend() && !p->on_curve(); ++p) {
      ++controls;
    }
  }
  const bool only_controls = !points.empty() && controls == points.size();
  for (size_t i = 0; i < points.size() && !only_controls; ++i) {
    const PointType type = points[i].type;
    if (type == PointType::move && i != 0) {
      throw Error("a point of type 'move' is the first of its contour");
    }
    if (type == PointType::offcurve) {
      ++controls;
      continue;
    }
    if ((type == PointType::line && controls > 0) ||
        (type == PointType::curve && controls > 2)) {
      throw Error("point " + std::to_string(i) + " of the contour, a " +
                  type_name(type) + ", has " + std::to_string(controls) +
                  " off-curve points before it; allowed are 0 before a line "
                  "and up to 2 before a curve");
    }
    controls = 0;
  }
  if (contour.open() && controls > 0) {
    throw Error("an open contour ends with a point on the curve");
  }
}

PointContour reversed(const PointContour& contour) {
  if (contour.points.empty()) {
    return contour;
  }
  // The type of an on-curve point describes the curve that ends there;
  // reversed, it belongs to the point at the other end.
  const size_t count = contour.points.size();
  std::vector<GlyphPoint> points(contour.points.rbegin(),
                                 contour.points.rend());
  std::vector<size_t> on;
  for (size_t i = 0; i < count; ++i) {
    if (points[i].on_curve()) {
      on.push_back(i);
    }
  }
  if (!on.empty()) {
    std::vector<PointType> types;
    for (const size_t i : on) {
      types.push_back(points[i].type);
    }
    for (size_t k = 1; k < on.size(); ++k) {
      points[on[k]].type = types[k - 1];
    }
    points[on.front()].type = contour.open() ? PointType::move : types.back();
  }
  if (!contour.open()) {
    // The same first point again.
    std::rotate(points.begin(), points.end() - 1, points.end());
  }
  return {points, contour.identifier};
}

gen::Contour to_segments(const PointContour& contour, double scale) {
  gen::Contour out;
  const std::vector<GlyphPoint>& points = contour.points;
  if (contour.open() || points.size() < 2) {
    return out;
  }
  size_t first = 0;
  while (first < points.size() && !points[first].on_curve()) {
    ++first;
  }
  std::vector<gen::Point> controls;
  if (first == points.size()) {  // quadratic, all points implied
    for (const GlyphPoint& point : points) {
      controls.push_back(scaled(point, scale));
    }
    const gen::Point start = middle(controls.back(), controls.front());
    add_piece(out, start, controls, start, PointType::qcurve);
    return out;
  }
  gen::Point at = scaled(points[first], scale);
  for (size_t i = 1; i <= points.size(); ++i) {
    const GlyphPoint& point = points[(first + i) % points.size()];
    if (!point.on_curve()) {
      controls.push_back(scaled(point, scale));
      continue;
    }
    const gen::Point to = scaled(point, scale);
    add_piece(out, at, controls, to, point.type);
    controls.clear();
    at = to;
  }
  return out;
}

PointContour from_segments(const gen::Contour& contour, double scale) {
  PointContour out;
  const size_t count = contour.segments.size();
  for (size_t i = 0; i < count; ++i) {
    const gen::Segment& segment = contour.segments[i];
    const gen::Segment& next = contour.segments[(i + 1) % count];
    const int last = degree(segment);
    for (int k = 1; k < last; ++k) {
      out.points.push_back({segment.p[k].x / scale, segment.p[k].y / scale,
                            PointType::offcurve, false, "", ""});
    }
    const PointType type = last == 1   ? PointType::line
                           : last == 2 ? PointType::qcurve
                                       : PointType::curve;
    out.points.push_back({segment.p[last].x / scale, segment.p[last].y / scale,
                          type, joins_smoothly(segment, next), "", ""});
  }
  drop_implied(out);
  return out;
}

std::vector<PointContour> contours_of(const Project& project,
                                      const gen::Outline& outline,
                                      double grid) {
  const auto rounded = [grid](double value) {
    return grid > 0 ? std::round(value / grid) * grid : value;
  };
  std::vector<PointContour> contours;
  for (const gen::Contour& contour : outline.contours) {
    PointContour points =
        from_segments(contour, gen::kUPerEm / project.units_per_em());
    for (GlyphPoint& point : points.points) {
      point.x = rounded(point.x);
      point.y = rounded(point.y);
    }
    contours.push_back(std::move(points));
  }
  return contours;
}

bool is_clockwise(const Project& project, const Glyph& glyph) {
  double area = largest_area(project, glyph);
  for (auto other = project.front().glyphs.begin();
       area == 0 && other != project.front().glyphs.end(); ++other) {
    area = largest_area(project, *other->second);
  }
  return area < 0;
}

std::vector<PointContour> in_direction_of(const Project& project,
                                          const Glyph& glyph,
                                          std::vector<PointContour> contours) {
  if (is_clockwise(project, glyph)) {
    for (PointContour& contour : contours) {
      contour = contour.open() ? contour : reversed(contour);
    }
  }
  return contours;
}

double twice_area(const PointContour& contour) {
  double area = 0;
  for (const gen::Segment& segment : to_segments(contour, 1).segments) {
    area += gen::twice_area(segment);
  }
  return area;
}

bool reaches(const Project& project,
             size_t layer,
             const std::string& from,
             const std::string& target) {
  return reaches_within(project, layer, from, target, kMostDepth);
}

void append_component(const Project& project,
                      size_t layer,
                      const ComponentUse& use,
                      std::vector<PointContour>& contours) {
  append_within(project, layer, use, kMostDepth, contours);
}

gen::Outline outline_of(const Project& project,
                        const Glyph& glyph,
                        size_t layer) {
  std::vector<PointContour> contours = glyph.contours;
  for (const ComponentUse& use : glyph.components) {
    append_component(project, layer, use, contours);
  }
  gen::Outline outline;
  for (const PointContour& contour : contours) {
    gen::Contour curves =
        to_segments(contour, gen::kUPerEm / project.units_per_em());
    if (!curves.segments.empty()) {
      outline.contours.push_back(std::move(curves));
    }
  }
  return outline;
}

}  // namespace inkcell::design
