#include "overlay.hpp"

#include "cells.hpp"

namespace inkcell::tools {
namespace {

constexpr double kUnitsOfU = 1024;

// From a glyph's units to px of the display.
class Map {
 public:
  Map(const Font& font, const Style& style)
      : px_per_unit_(style.size().raw / 64.0 / font.units_per_em()),
        px_per_u_(style.size().raw / 64.0 / kUnitsOfU),
        cosine_(style.direction().cosine.raw / kOne),
        sine_(style.direction().sine.raw / kOne) {}

  void set_origin(Point line, int32_t x) {
    x_ = line.x.raw / 64.0 + x * px_per_unit_ * cosine_;
    y_ = line.y.raw / 64.0 - x * px_per_unit_ * sine_;
  }
  Place from_units(double x, double y) const {
    return place(x * px_per_unit_, y * px_per_unit_);
  }
  Place from_u(double x, double y) const {
    return place(x * px_per_u_, y * px_per_u_);
  }

 private:
  static constexpr double kOne = 1 << 30;

  Place place(double right, double up) const {
    return {static_cast<float>(x_ + right * cosine_ - up * sine_),
            static_cast<float>(y_ - right * sine_ - up * cosine_)};
  }

  double px_per_unit_;
  double px_per_u_;
  double cosine_;
  double sine_;
  double x_ = 0;
  double y_ = 0;
};

Place between(Place a, Place b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

std::vector<Place> bend(Place from, Place control, Place to) {
  constexpr int kPieces = 12;
  std::vector<Place> places;
  for (int i = 0; i <= kPieces; ++i) {
    const float t = static_cast<float>(i) / kPieces;
    const float a = (1 - t) * (1 - t);
    const float b = 2 * t * (1 - t);
    const float c = t * t;
    places.push_back({a * from.x + b * control.x + c * to.x,
                      a * from.y + b * control.y + c * to.y});
  }
  return places;
}

// Between two consecutive off-curve points there is an on-curve point midway.
void add_contour(const OutlineContour& contour,
                 const Map& map,
                 Overlay& overlay) {
  const size_t count = contour.size();
  std::vector<Place> at;
  for (const OutlinePoint& point : contour) {
    at.push_back(map.from_units(point.x, point.y));
    overlay.dots.push_back({at.back(), point.kind});
  }
  const auto is_off = [&contour](size_t i) {
    return contour[i].kind == PointKind::off_curve;
  };
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    const size_t last = (i + count - 1) % count;
    if (is_off(i)) {
      overlay.curves.push_back(
          {bend(is_off(last) ? between(at[last], at[i]) : at[last], at[i],
                is_off(next) ? between(at[i], at[next]) : at[next]),
           false});
    } else if (!is_off(next)) {
      overlay.curves.push_back({{at[i], at[next]}, false});
    }
    if (is_off(i) || is_off(next)) {
      overlay.curves.push_back({{at[i], at[next]}, true});
    }
  }
}

void add_leaves(const GlyphField& field, const Map& map, Overlay& overlay) {
  for_each_cell(field, [&](const Cell& cell) {
    const int x0 = cell.x0_u;
    const int y0 = cell.y0_u;
    const int side = 1 << cell.size_log2;
    overlay.leaves.push_back(
        {{map.from_u(x0, y0), map.from_u(x0 + side, y0),
          map.from_u(x0 + side, y0 + side), map.from_u(x0, y0 + side)},
         cell.is_saturated()});
  });
}

}  // namespace

Overlay make_overlay(const Font& font,
                     const std::vector<Line>& lines,
                     const std::vector<Point>& origins,
                     const Style& style) {
  Overlay overlay;
  Map map(font, style);
  for (size_t i = 0; i < lines.size(); ++i) {
    for (const PositionedGlyph& glyph : lines[i].glyphs) {
      map.set_origin(origins[i], glyph.x);
      for (const OutlineContour& contour :
           glyph_outline(font, glyph.glyph).contours) {
        add_contour(contour, map, overlay);
      }
      GlyphField field;
      if (!font.has_outlines() &&
          read_field(font, glyph.glyph, field) == Status::ok) {
        add_leaves(field, map, overlay);
      }
    }
  }
  return overlay;
}

}  // namespace inkcell::tools
