// Draws fields, cell borders, points of outlines and sheets of glyphs.
#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "canvas.hpp"
#include "cells.hpp"
#include "census.hpp"
#include "colours.hpp"
#include "inkcell/format/rom.hpp"
#include "outline_field.hpp"

namespace inkcell::tools {
namespace {

// Borders of cells.
constexpr Colour kSaturatedBorder = {196, 204, 214};
constexpr Colour kBorder = {40, 52, 72};
// What grid fitting knows.
constexpr Colour kZone = {90, 96, 104};
constexpr Colour kBar = {208, 0, 24};
constexpr Colour kSerif = {226, 122, 0};
constexpr Colour kEdge = {150, 0, 190};
constexpr Colour kFreeEnd = {0, 140, 160};
constexpr Colour kStem = {0, 120, 40};
constexpr int kDash = 6;  // and the gap to the next one [px]
// Points of outlines.
constexpr Colour kInside = {246, 226, 200};
constexpr Colour kOutside = {255, 255, 255};
constexpr Colour kCurve = {24, 32, 48};
constexpr Colour kControl = {150, 166, 186};
constexpr Colour kCorner = {208, 0, 24};
constexpr Colour kSmooth = {0, 120, 40};
constexpr Colour kOffCurve = {30, 90, 200};
// Around the ink of outlines. [u]
constexpr int kMargin = 48;

// A point of the glyph. [u]
struct Vector {
  double x = 0;
  double y = 0;
};

// A part of the plane on a picture.
struct View {
  Rect box_u;  // y up
  double px_per_u;
  int width;
  int height;

  double x_px(double x_u) const { return (x_u - box_u.x0) * px_per_u; }
  double y_px(double y_u) const { return (box_u.y1 - y_u) * px_per_u; }
  int column(int x_u) const { return static_cast<int>(std::lround(x_px(x_u))); }
  int row(int y_u) const { return static_cast<int>(std::lround(y_px(y_u))); }
  // The centre of a pixel.
  double x_u(int px) const { return box_u.x0 + (px + 0.5) / px_per_u; }
  double y_u(int px) const { return box_u.y1 - (px + 0.5) / px_per_u; }
};

Q16_16 to_q16(double u) {
  return Q16_16::from_raw(static_cast<int32_t>(std::floor(u * 65536)));
}

// A picture by the colours of points.
template <typename ColourAt>
Image picture_of(const View& view, const ColourAt& colour_at) {
  Image image(view.width + 1, view.height + 1, 3, 255);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      put(image, x, y, colour_at(view.x_u(x), view.y_u(y)));
    }
  }
  return image;
}

Image draw_cell_field(const View& view, const GlyphField& field) {
  return picture_of(view, [&](double x, double y) {
    const Q16_16 x_u = to_q16(x);
    const Q16_16 y_u = to_q16(y);
    const double distance = distance_at(field, x_u, y_u).raw / 1024.0;
    const Cell cell = locate(field, x_u.floor(), y_u.floor());
    return field_colour({distance, cell.is_saturated()}, view.px_per_u);
  });
}

// The four sides of a cell over the picture without borders.
void draw_border(const View& view,
                 const Cell& cell,
                 const Image& bare,
                 Image& image) {
  const int size = 1 << cell.size_log2;
  const int left = view.column(cell.x0_u);
  const int right = view.column(cell.x0_u + size);
  const int top = view.row(cell.y0_u + size);
  const int bottom = view.row(cell.y0_u);
  // Small cells would become one dark mass.
  const double strength = std::clamp(0.10 * (right - left), 0.25, 0.62);
  const Colour& colour = cell.is_saturated() ? kSaturatedBorder : kBorder;
  const auto blend = [&](int x, int y) {
    put(image, x, y, mix(get(bare, x, y), colour, strength));
  };
  for (int x = left; x <= right; ++x) {
    blend(x, bottom);
    blend(x, top);
  }
  for (int y = top; y <= bottom; ++y) {
    blend(left, y);
    blend(right, y);
  }
}

// Where a saturated cell meets another one, the border of that one shows.
void draw_borders(const View& view, const GlyphField& field, Image& image) {
  const Image bare = image;
  for (const bool is_saturated : {true, false}) {
    for_each_cell(field, [&](const Cell& cell) {
      if (cell.is_saturated() == is_saturated) {
        draw_border(view, cell, bare, image);
      }
    });
  }
}

// A picture whose longer side becomes `side` px.
View view_of(const Rect& box_u, int side) {
  const int width_u = box_u.x1 - box_u.x0;
  const int height_u = box_u.y1 - box_u.y0;
  const double px_per_u =
      static_cast<double>(side) / std::max(width_u, height_u);
  return {box_u, px_per_u, static_cast<int>(std::lround(width_u * px_per_u)),
          static_cast<int>(std::lround(height_u * px_per_u))};
}

// The grid of cells, or the ink with kMargin around it.
Rect box_of(const Font& font, const GlyphCensus& glyph) {
  const GlyphMetrics& m = glyph.metrics;
  if (glyph.bytes == 0 || m.x_max <= m.x_min || m.y_max <= m.y_min) {
    throw std::runtime_error("the glyph has no ink, and so no picture");
  }
  const GlyphField& field = glyph.field;
  if (!font.has_outlines()) {
    return {field.x0_u, field.y0_u, field.x1_u(), field.y1_u()};
  }
  const double u = 1024.0 / font.units_per_em();
  return {static_cast<int>(std::floor(m.x_min * u)) - kMargin,
          static_cast<int>(std::floor(m.y_min * u)) - kMargin,
          static_cast<int>(std::ceil(m.x_max * u)) + kMargin,
          static_cast<int>(std::ceil(m.y_max * u)) + kMargin};
}

Image draw_outline_field(const View& view,
                         const Font& font,
                         const GlyphCensus& glyph) {
  const OutlineField field(font, glyph.glyph, view.box_u);
  return picture_of(view, [&](double x, double y) {
    return field_colour(field.at(x, y), view.px_per_u);
  });
}

Image draw_field(const View& view, const Font& font, const GlyphCensus& glyph) {
  return font.has_outlines() ? draw_outline_field(view, font, glyph)
                             : draw_cell_field(view, glyph.field);
}

// Lines across the whole picture, `dash` px long with gaps in between; 0: in
// one piece.
void draw_height(
    const View& view, int y_u, const Colour& colour, int dash, Image& image) {
  const int y = view.row(y_u);
  for (int x = 0; y >= 0 && y < image.height && x < image.width; ++x) {
    if (dash == 0 || x / dash % 2 == 0) {
      put(image, x, y, colour);
    }
  }
}

void draw_abscissa(const View& view, int x_u, Image& image) {
  const int x = view.column(x_u);
  for (int y = 0; x >= 0 && x < image.width && y < image.height; ++y) {
    put(image, x, y, kStem);
  }
}

const Colour& colour_of(HeightHint::Kind kind) {
  switch (kind) {
    case HeightHint::Kind::bar:
      return kBar;
    case HeightHint::Kind::serif:
      return kSerif;
    case HeightHint::Kind::edge:
      return kEdge;
    case HeightHint::Kind::free_end:
      break;
  }
  return kFreeEnd;
}

void draw_hints(const View& view,
                const GridHints& hints,
                const GlyphHints& glyph,
                Image& image) {
  for (const HintZone& zone : hints.zones) {
    draw_height(view, zone.flat_u, kZone, kDash, image);
  }
  for (const HeightHint& hint : glyph.heights) {
    draw_height(view, hint.low_u, colour_of(hint.kind), 0, image);
    draw_height(view, hint.high_u, colour_of(hint.kind), 0, image);
  }
  for (const StemHint& hint : glyph.stems) {
    draw_abscissa(view, hint.left_u, image);
    draw_abscissa(view, hint.right_u, image);
  }
}

// The inside of the glyph in a pale colour.
Image draw_shape(const View& view, const Font& font, const GlyphCensus& glyph) {
  const OutlineField field(font, glyph.glyph, view.box_u);
  return picture_of(view, [&](double x, double y) {
    return mix(kOutside, kInside,
               field.at(x, y).distance_u * view.px_per_u + 0.5);
  });
}

// Blends the pixels that are less than `radius_px` from the line from a to b.
// [px]
void draw_line(
    Vector a, Vector b, double radius_px, const Colour& colour, Image& image) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const auto low = [&](double p, double q) {
    return std::max(0, static_cast<int>(std::min(p, q) - radius_px) - 1);
  };
  const auto high = [&](double p, double q, int side) {
    return std::min(side - 1, static_cast<int>(std::max(p, q) + radius_px) + 1);
  };
  for (int y = low(a.y, b.y); y <= high(a.y, b.y, image.height); ++y) {
    for (int x = low(a.x, b.x); x <= high(a.x, b.x, image.width); ++x) {
      const Vector p = {x + 0.5 - a.x, y + 0.5 - a.y};
      const double along =
          square == 0 ? 0
                      : std::clamp((p.x * dx + p.y * dy) / square, 0.0, 1.0);
      const double away = std::hypot(p.x - along * dx, p.y - along * dy);
      put(image, x, y, mix(get(image, x, y), colour, radius_px + 0.5 - away));
    }
  }
}

void draw_dot(Vector p, double radius_px, const Colour& colour, Image& image) {
  draw_line(p, p, radius_px, colour, image);
}

// Corners: squares. Smooth points: discs. Off-curve points: rings.
void draw_point(Vector p, PointKind kind, Image& image) {
  constexpr double kRadius = 4.5;
  if (kind == PointKind::corner) {
    for (double y = -kRadius; y <= kRadius; ++y) {
      draw_line({p.x - kRadius + 0.5, p.y + y}, {p.x + kRadius - 0.5, p.y + y},
                0.5, kCorner, image);
    }
    return;
  }
  draw_dot(p, kRadius, kind == PointKind::smooth ? kSmooth : kOffCurve, image);
  if (kind == PointKind::off_curve) {
    draw_dot(p, kRadius - 2, kOutside, image);
  }
}

// The box of the ink, as metrics state it.
void draw_box(const View& view, Vector low, Vector high, Image& image) {
  const double left = view.x_px(low.x);
  const double right = view.x_px(high.x);
  const double top = view.y_px(high.y);
  const double bottom = view.y_px(low.y);
  const auto draw = [&](Vector a, Vector b) {
    draw_line(a, b, 0.5, kZone, image);
  };
  for (double x = left; x < right; x += 2 * kDash) {
    draw({x, top}, {std::min(x + kDash, right), top});
    draw({x, bottom}, {std::min(x + kDash, right), bottom});
  }
  for (double y = top; y < bottom; y += 2 * kDash) {
    draw({left, y}, {left, std::min(y + kDash, bottom)});
    draw({right, y}, {right, std::min(y + kDash, bottom)});
  }
}

// A quadratic curve in straight pieces.
void draw_curve(Vector from, Vector control, Vector to, Image& image) {
  constexpr int kPieces = 24;
  Vector last = from;
  for (int i = 1; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    const double a = (1 - t) * (1 - t);
    const double b = 2 * t * (1 - t);
    const double c = t * t;
    const Vector next = {a * from.x + b * control.x + c * to.x,
                         a * from.y + b * control.y + c * to.y};
    draw_line(last, next, 0.75, kCurve, image);
    last = next;
  }
}

// Control lines, curves and points. Between two consecutive off-curve points
// there is an on-curve point midway, drawn as a small disc.
void draw_contour(const View& view,
                  const OutlineContour& contour,
                  double u_per_unit,
                  Image& image) {
  std::vector<Vector> points;
  for (const OutlinePoint& point : contour) {
    points.push_back(
        {view.x_px(point.x * u_per_unit), view.y_px(point.y * u_per_unit)});
  }
  const auto is_off = [&](size_t i) {
    return contour[i].kind == PointKind::off_curve;
  };
  const auto middle = [&](size_t i, size_t j) {
    return Vector{(points[i].x + points[j].x) / 2,
                  (points[i].y + points[j].y) / 2};
  };
  const size_t count = points.size();
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    if (is_off(i) || is_off(next)) {
      draw_line(points[i], points[next], 0.5, kControl, image);
    }
  }
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    const size_t last = (i + count - 1) % count;
    if (is_off(i)) {
      draw_curve(is_off(last) ? middle(last, i) : points[last], points[i],
                 is_off(next) ? middle(i, next) : points[next], image);
    } else if (!is_off(next)) {
      draw_line(points[i], points[next], 0.75, kCurve, image);
    }
  }
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    if (is_off(i) && is_off(next)) {
      draw_dot(middle(i, next), 2, kSmooth, image);
    }
    draw_point(points[i], contour[i].kind, image);
  }
}

// Grey of the lines between the boxes of a sheet.
constexpr uint8_t kRule = 225;

}  // namespace

Image draw_cells(const Font& font, const GlyphCensus& glyph, int side) {
  if (font.has_outlines()) {
    throw std::runtime_error(
        "--cells draws cells, and the font has outlines: use --points or "
        "--field, or --coding field for a TTF or OTF");
  }
  const View view = view_of(box_of(font, glyph), side);
  Image image = draw_cell_field(view, glyph.field);
  draw_borders(view, glyph.field, image);
  return image;
}

Image draw_field(const Font& font, const GlyphCensus& glyph, int side) {
  return draw_field(view_of(box_of(font, glyph), side), font, glyph);
}

Image draw_points(const FontCensus& census,
                  const Font& font,
                  const GlyphCensus& glyph,
                  int side) {
  if (!font.has_outlines()) {
    throw std::runtime_error(
        "--points draws outlines, and the font has cells: use --cells or "
        "--field, or --coding outline for a TTF or OTF");
  }
  const View view = view_of(box_of(font, glyph), side);
  Image image = draw_shape(view, font, glyph);
  if (census.hints.is_there) {
    draw_hints(view, census.hints, census.hints.glyphs[glyph.glyph], image);
  }
  const double u = 1024.0 / font.units_per_em();
  const GlyphMetrics& m = glyph.metrics;
  draw_box(view, {m.x_min * u, m.y_min * u}, {m.x_max * u, m.y_max * u}, image);
  for (const OutlineContour& contour : glyph.outline.contours) {
    draw_contour(view, contour, u, image);
  }
  return image;
}

Image draw_sheet(const Font& font, double px) {
  const Style style = make_style(px, 0, kFilterText);  // refuses odd sizes
  const FontMetrics metrics = font.metrics();
  const double scale = px / metrics.units_per_em;
  int32_t widest = 0;
  for (uint32_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    GlyphMetrics measures;
    if (font.glyph_metrics(static_cast<uint16_t>(glyph), measures) ==
        Status::ok) {
      widest = std::max({widest, measures.advance,
                         measures.x_max - std::min<int>(measures.x_min, 0)});
    }
  }
  const int box_width = static_cast<int>(std::ceil(widest * scale)) + 8;
  const int rise = static_cast<int>(
      std::ceil(std::max(metrics.ascender, metrics.y_max) * scale));
  const int drop = static_cast<int>(
      std::ceil(-std::min(metrics.descender, metrics.y_min) * scale));
  const int box_height = rise + drop + 8;
  const int count = font.glyph_count();
  // About 3:2.
  const int columns = std::clamp(
      static_cast<int>(std::sqrt(1.5 * count * box_height / box_width)), 1,
      count);
  const int rows = (count + columns - 1) / columns;

  Image image(columns * box_width + 1, rows * box_height + 1);
  for (int i = 0; i < count; ++i) {
    GlyphMetrics measures;
    static_cast<void>(font.glyph_metrics(static_cast<uint16_t>(i), measures));
    Image box(box_width, box_height);
    Line line;
    line.glyphs.push_back({0, 0, static_cast<uint16_t>(i)});
    const double slack = box_width - measures.advance * scale;
    draw_lines(font, {line}, style, make_point(slack / 2, rise + 4), box);
    paste(box, i % columns * box_width, i / columns * box_height, image);
  }
  invert(image);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (x % box_width == 0 || y % box_height == 0) {
        *image.at(x, y) = std::min(*image.at(x, y), kRule);
      }
    }
  }
  return image;
}

}  // namespace inkcell::tools
